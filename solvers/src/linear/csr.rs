//! Compressed rows as two fields.

use allotrope::prelude::*;

use super::entries::{self, EntryError, by_rows};
use super::operator::{Operator, Vector};
use super::rows::InRow;

/// A matrix as its entries that are not zero, row by row, and where each row starts: compressed sparse rows. `L` is the
/// layout of the entries.
#[derive(Clone, Debug)]
pub struct CsrMatrix<L: Layout<I> = Soa> {
    entries: Field<InRow, L>,
    starts: Field<u32, Aos>,
}

impl<L: Layout<I>> CsrMatrix<L> {
    /// The matrix of so many rows with these entries; those of one place add up.
    ///
    /// # Errors
    /// If an entry lies outside, or memory is refused.
    pub fn of_entries(size: usize, entries: &[entries::Entry]) -> Result<Self, EntryError> {
        let (sorted, row_starts) = by_rows(size, entries)?;
        let memory = |fault: allotrope::ShapeError| EntryError::Memory(fault.to_string());
        let mut entries = Field::<InRow, L>::try_new([sorted.len()]).map_err(memory)?;
        let mut starts = Field::<u32, Aos>::try_new([size + 1]).map_err(memory)?;
        for (place, &(_, column, value)) in sorted.iter().enumerate() {
            entries.set(place, InRow { value, column: column as u32 });
        }
        row_starts.iter().enumerate().for_each(|(row, &start)| starts.set(row, start as u32));
        Ok(Self { entries, starts })
    }
}

impl<L: Layout<I>> Operator for CsrMatrix<L> {
    type Value = f64;
    type Axes = I;
    type Layout = Aos;

    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
        apply(&self.entries, &self.starts, x, y)
    }

    fn diagonal(&self, diagonal: &mut Vector<Self>) {
        extract_diagonal(&self.entries, &self.starts, diagonal);
    }
}

/// `y <- A x`; returns `x . A x`.
#[kernel]
fn apply(entries: &Field<InRow, _>, starts: &Field<u32, _>, x: &Field<f64, _>, y: &mut Field<f64, _>) -> f64 {
    let mut curvature = 0.0;
    for i in y {
        let mut product = 0.0;
        for e in starts[i]..starts[i + 1] {
            product += entries.value[e] * x[entries.column[e]];
        }
        y[i] = product;
        curvature += x[i] * product;
    }
    curvature
}

#[kernel]
fn extract_diagonal(entries: &Field<InRow, _>, starts: &Field<u32, _>, diagonal: &mut Field<f64, _>) {
    for i in diagonal {
        let mut own = 0.0;
        for e in starts[i]..starts[i + 1] {
            if entries.column[e] as i32 == i {
                own = entries.value[e];
            }
        }
        diagonal[i] = own;
    }
}
