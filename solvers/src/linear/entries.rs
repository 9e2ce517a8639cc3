//! Matrices as lists of their entries, from which the layouts are made.

use std::fmt;

/// An entry of a matrix: row, column, value.
pub type Entry = (usize, usize, f64);

/// Why a list of entries makes no matrix.
#[derive(Clone, Debug, PartialEq)]
pub enum EntryError {
    /// An entry lies outside of the matrix.
    Outside {
        /// Its place in the list.
        entry: usize,
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
        /// Rows of the matrix.
        size: usize,
    },
    /// A row has more entries than its layout holds.
    Long {
        /// The row.
        row: usize,
        /// Its entries.
        entries: usize,
        /// As many as a row can have.
        most: usize,
    },
    /// The system refuses the memory, or the extents are too large.
    Memory(String),
}

impl fmt::Display for EntryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside { entry, row, column, size } => {
                write!(f, "entry {entry} is at ({row}, {column}), outside of a matrix of {size} x {size}")
            }
            Self::Long { row, entries, most } => {
                write!(f, "row {row} has {entries} entries, and its layout holds at most {most}")
            }
            Self::Memory(fault) => f.write_str(fault),
        }
    }
}

impl std::error::Error for EntryError {}

/// The entries by rows and in them by columns, those of one place added up; and where each row starts, with the end of
/// the last behind them.
pub(super) fn by_rows(size: usize, entries: &[Entry]) -> Result<(Vec<Entry>, Vec<usize>), EntryError> {
    if let Some(entry) = entries.iter().position(|&(row, column, _)| row >= size || column >= size) {
        let (row, column, _) = entries[entry];
        return Err(EntryError::Outside { entry, row, column, size });
    }
    let mut sorted = entries.to_vec();
    // Stable: sums over entries of one place are in the order in which they were given.
    sorted.sort_by_key(|&(row, column, _)| (row, column));
    sorted.dedup_by(|next, first| {
        let same = (next.0, next.1) == (first.0, first.1);
        if same {
            first.2 += next.2;
        }
        same
    });
    let mut starts = vec![0; size + 1];
    sorted.iter().for_each(|&(row, ..)| starts[row + 1] += 1);
    for row in 0..size {
        starts[row + 1] += starts[row];
    }
    Ok((sorted, starts))
}
