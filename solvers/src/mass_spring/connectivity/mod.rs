//! Which masses are joined, in four layouts of the same sums over springs.
//!
//! | layout | a spring lies | forces are |
//! | --- | --- | --- |
//! | [`Matrix`] over a dense layout | twice in a table of all pairs, which is mostly empty | added to the row's mass |
//! | [`Matrix`] over a sparse layout | twice in the blocks of the table that are not empty | added to the row's mass |
//! | [`Rows`] | twice, in a list of each of its masses | added to the list's mass |
//! | [`List`] | once, in one list of all | added to both masses |

mod list;
mod matrix;
mod rows;

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::records::{Mass, Rates, Spring};

pub use list::List;
pub(super) use matrix::MOST_DENSE;
pub use matrix::Matrix;
pub use rows::Rows;

/// A vector of space for each mass.
pub type Vectors = Field<DVec3, Aos>;

/// The springs in some layout, and sums over them; masses lie in the layout `M`.
pub trait Connectivity<M: Layout<I>>: Send + Sync + Sized {
    /// More masses than this are too many for the layout.
    const MOST_MASSES: usize = u32::MAX as usize;

    /// The springs between so many masses. Each pair is joined once, and the numbers of masses are in range.
    ///
    /// # Errors
    /// If memory is refused, or a mass has more springs than the layout holds.
    fn new(masses: usize, springs: &[Spring]) -> Result<Self, String>;

    /// Adds the forces of springs to those of masses.
    fn add_forces(&self, masses: &mut Field<Mass, M>);

    /// Adds to `q` what springs resist the displacements `p` with.
    fn add_resistance(&self, masses: &Field<Mass, M>, p: &Vectors, q: &mut Vectors, rates: Rates);

    /// Adds the diagonal of the matrix by which they resist.
    fn add_diagonal(&self, masses: &Field<Mass, M>, diagonal: &mut Vectors, rates: Rates);

    /// Bytes of all fields.
    fn bytes(&self) -> usize;

    /// What its records are, and where they lie.
    fn memory_map(&self) -> (&'static str, MemoryMap<'_>);
}
