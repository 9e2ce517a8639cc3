//! Matrices all of whose entries are held.

use allotrope::prelude::*;

use super::entries::{Entry, EntryError, by_rows};
use super::operator::{Operator, Vector};

/// A matrix with all its entries, in the layout `L`.
#[derive(Clone, Debug)]
pub struct DenseMatrix<L: Layout<Ij> = Aos> {
    entries: Field<f64, L, Ij>,
}

impl<L: Layout<Ij>> DenseMatrix<L> {
    /// The square matrix whose entries a field holds.
    ///
    /// # Panics
    /// If the field is not square.
    pub fn new(entries: Field<f64, L, Ij>) -> Self {
        let [rows, columns] = entries.shape();
        assert_eq!(rows, columns, "a matrix of {rows} x {columns} is not square");
        Self { entries }
    }

    /// The matrix of so many rows with these entries; those of one place add up, and the others are zero.
    ///
    /// # Errors
    /// If an entry lies outside, or memory is refused.
    pub fn of_entries(size: usize, entries: &[Entry]) -> Result<Self, EntryError> {
        let (sorted, _) = by_rows(size, entries)?;
        let mut field =
            Field::<f64, L>::try_new([size, size]).map_err(|fault| EntryError::Memory(fault.to_string()))?;
        sorted.iter().for_each(|&(row, column, value)| field.set([row, column], value));
        Ok(Self { entries: field })
    }

    /// The entries.
    pub fn entries(&self) -> &Field<f64, L, Ij> {
        &self.entries
    }
}

impl<L: Layout<Ij>> Operator for DenseMatrix<L> {
    type Value = f64;
    type Axes = I;
    type Layout = Aos;

    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
        apply(&self.entries, x, y)
    }

    fn diagonal(&self, diagonal: &mut Vector<Self>) {
        extract_diagonal(&self.entries, diagonal);
    }
}

/// `y <- A x`; returns `x . A x`.
#[kernel]
fn apply(a: &Field<f64, _, Ij>, x: &Field<f64, _>, y: &mut Field<f64, _>) -> f64 {
    let mut curvature = 0.0;
    let columns = x.len() as i32;
    for i in y {
        let mut product = 0.0;
        for j in 0..columns {
            product += a[(i, j)] * x[j];
        }
        y[i] = product;
        curvature += x[i] * product;
    }
    curvature
}

#[kernel]
fn extract_diagonal(a: &Field<f64, _, Ij>, diagonal: &mut Field<f64, _>) {
    for i in diagonal {
        diagonal[i] = a[(i, i)];
    }
}
