//! Compressed rows as lists that grow.

use allotrope::prelude::*;

use super::entries::{self, EntryError, by_rows};
use super::operator::{Operator, Vector};

/// An entry of a row.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct InRow {
    pub(super) value: f64,
    pub(super) column: u32,
}

/// The layout of a [`RowMatrix`]: a list a row.
pub type Rows = layout!(dense(i).dynamic(j, 4096, chunk = 8).aos);

/// As many entries as a row can have.
const MOST: usize = 4096;

/// A matrix whose rows are lists of the entries that are not zero: entries can be appended to any row.
#[derive(Clone, Debug)]
pub struct RowMatrix {
    rows: Field<InRow, Rows, Ij>,
}

impl RowMatrix {
    /// The matrix of so many rows with these entries; those of one place add up.
    ///
    /// # Errors
    /// If an entry lies outside, a row has more than 4096, or memory is refused.
    pub fn of_entries(size: usize, entries: &[entries::Entry]) -> Result<Self, EntryError> {
        let (sorted, starts) = by_rows(size, entries)?;
        if let Some(row) = (0..size).find(|&row| starts[row + 1] - starts[row] > MOST) {
            return Err(EntryError::Long { row, entries: starts[row + 1] - starts[row], most: MOST });
        }
        let mut rows = Field::<InRow, Rows>::try_new([size]).map_err(|fault| EntryError::Memory(fault.to_string()))?;
        for &(row, column, value) in &sorted {
            rows.append(row, InRow { value, column: column as u32 });
        }
        Ok(Self { rows })
    }
}

impl Operator for RowMatrix {
    type Value = f64;
    type Axes = I;
    type Layout = Aos;

    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
        apply(&self.rows, x, y)
    }

    fn diagonal(&self, diagonal: &mut Vector<Self>) {
        extract_diagonal(&self.rows, diagonal);
    }
}

/// `y <- A x`; returns `x . A x`.
#[kernel]
fn apply(rows: &Field<InRow, Rows, Ij>, x: &Field<f64, _>, y: &mut Field<f64, _>) -> f64 {
    let mut curvature = 0.0;
    for i in y {
        let mut product = 0.0;
        for e in rows.row(i) {
            product += rows.value[e] * x[rows.column[e]];
        }
        y[i] = product;
        curvature += x[i] * product;
    }
    curvature
}

#[kernel]
fn extract_diagonal(rows: &Field<InRow, Rows, Ij>, diagonal: &mut Field<f64, _>) {
    for i in diagonal {
        let mut own = 0.0;
        for e in rows.row(i) {
            if rows.column[e] as i32 == i {
                own = rows.value[e];
            }
        }
        diagonal[i] = own;
    }
}
