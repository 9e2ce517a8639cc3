//! Which particles are near each other, in four layouts of one algorithm: space is cut into cells as wide as the distance
//! that is asked for, so that what is near a place lies in the cells around it.
//!
//! | | what is kept | [`Search`] | [`Walk`] |
//! | --- | --- | --- | --- |
//! | sorted cells | particles in the order of their cells, and where each cell begins (Green 2008) | [`SortedCells`] | [`Sorted`] |
//! | cells | a `dynamic` list of particles for each cell | [`CellLists`] | [`Listed`] |
//! | hashed cells | such a list for each cell that holds a particle, found by hashing, without bounds (Ihmsen et al. 2011) | [`HashedCells`] | [`Hashed`] |
//! | neighbour lists | for each particle the list of those near it, with a skin, so that it holds for some steps (Verlet 1967; Domínguez et al. 2011) | [`NeighbourLists`] | [`Stored`] |
//!
//! All are built in time proportional to the number of particles, and visit the same pairs. A kernel is written once, for any
//! [`Walk`]:
//!
//! ```
//! use allotrope::prelude::*;
//! use allotrope_solvers::sph::neighbours::{HashedCells, Options, Search, SortedCells, Walk};
//!
//! /// How many particles are nearer than 1, each itself included.
//! #[kernel]
//! fn count<W: Walk<Ij>>(x: &Field<Vec2, _>, near: &Field<u32, W::Layout, W::Axes>, walk: &W, found: &mut Field<u32, _>) {
//!     for p in x {
//!         let own = x[p];
//!         let mut count = 0;
//!         walk.each(near, p, own, |q| {
//!             count += u32::from((x[q] - own).length_squared() < 1.0);
//!         });
//!         found[p] = count;
//!     }
//! }
//!
//! fn counts<S: Search<Ij>>() -> Vec<u32> {
//!     let mut x = Field::<Vec2, Soa>::new([4]);
//!     x.copy_from_slice(&[vec2(0.1, 0.1), vec2(0.9, 0.1), vec2(1.7, 0.1), vec2(5.0, 3.0)]);
//!     let mut search = S::new(&Options { radius: 1.0, lower: vec2(0.0, 0.0), upper: vec2(6.0, 4.0), ..Options::new(4) }).unwrap();
//!     search.update(&x).unwrap();
//!     let mut found = Field::<u32, Soa>::new([4]);
//!     count(&x, search.near(), &search.walk(), &mut found);
//!     found.to_vec()
//! }
//! assert_eq!(counts::<SortedCells<Ij>>(), [2, 3, 2, 1]);
//! assert_eq!(counts::<HashedCells<Ij>>(), [2, 3, 2, 1]);
//! ```

mod cells;
mod hashed;
mod listed;
mod sorted;
mod stored;

use std::fmt;

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{Readable, ShapeError};

pub use cells::Cells;
pub use hashed::{Hashed, HashedCells};
pub use listed::{CellLists, Listed};
pub use sorted::{Sorted, SortedCells};
pub use stored::{NeighbourLists, Stored};

/// The most particles that a list of a cell holds.
pub const MOST_IN_CELL: usize = 128;

/// Goes through what may be near a place, as a [`Search`] keeps it in a field of the layout `Layout` over the axes `Axes`.
/// Kernels hand the field on, as for a `#[func]`.
pub trait Walk<X: Spatial>: Copy + Send + Sync {
    /// The axes of the field.
    type Axes: Axes;
    /// Its layout.
    type Layout: Layout<Self::Axes>;

    /// Calls `visit` with each particle that may be nearer to the particle `p` at `x` than the radius: with all that are,
    /// `p` among them, and with others, which are to be told by their distance; with none twice.
    fn each(
        &self,
        near: impl Readable<u32, Self::Axes, Layout = Self::Layout>,
        p: i32,
        x: X::Vec<f32>,
        visit: impl FnMut(i32),
    );
}

/// Finds neighbours in one of the four ways.
pub trait Search<X: Spatial>: Send + Sync + Sized {
    /// How kernels go through what was found.
    type Walk: Walk<X>;

    /// Whether particles must lie in memory in the order of their [`key`](Self::key) at each [`update`](Self::update).
    const SORTED: bool;

    /// Whether what was found holds until particles have moved by half of the skin, and is not found anew each step.
    const LASTS: bool;

    /// A search for so many particles.
    ///
    /// # Errors
    /// Where memory is refused.
    fn new(options: &Options<X>) -> Result<Self, ShapeError>;

    /// The number of the cell of a place: the order in which particles are sorted.
    fn key(&self, x: X::Vec<f32>) -> u32;

    /// Finds all neighbours anew. Where they must be [`SORTED`](Self::SORTED), the particles are.
    ///
    /// # Errors
    /// Where there are more particles in one place than a list holds.
    fn update(&mut self, x: &Field<X::Vec<f32>, Soa>) -> Result<(), Crowded>;

    /// What was found.
    #[allow(clippy::type_complexity, reason = "the field of a walk")]
    fn near(&self) -> &Field<u32, <Self::Walk as Walk<X>>::Layout, <Self::Walk as Walk<X>>::Axes>;

    /// How to go through it.
    fn walk(&self) -> Self::Walk;

    /// Bytes of its fields.
    fn bytes(&self) -> usize;
}

/// What a [`Search`] is made for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<X: Spatial> {
    /// Number of particles.
    pub particles: usize,
    /// How far neighbours are, in m: the support radius.
    pub radius: f32,
    /// How much farther those are that stored lists hold.
    pub skin: f32,
    /// The most neighbours that a stored list holds, those in the skin and the particle itself included.
    pub most: usize,
    /// The lowest corner of the box that particles are expected in. Beyond it they are found all the same, but slower the
    /// more they are; hashed cells need no box.
    pub lower: X::Vec<f32>,
    /// Its highest corner.
    pub upper: X::Vec<f32>,
}

impl<X: Spatial> Options<X> {
    /// A search for so many particles, with the radius 1 in the unit cube, without a skin.
    pub fn new(particles: usize) -> Self {
        let (lower, upper) = (X::Vec::<f32>::zero(), X::Vec::<f32>::splat(1.0));
        Self { particles, radius: 1.0, skin: 0.0, most: 128, lower, upper }
    }
}

/// More particles in one place than a list holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crowded {
    /// The particle, by its place in memory.
    pub particle: usize,
    /// How many there are around it, itself included.
    pub count: usize,
    /// How many its list holds at most.
    pub most: usize,
    /// Whether the list is that of its cell, not its own.
    pub in_cell: bool,
}

impl fmt::Display for Crowded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { particle, count, most, in_cell } = self;
        let list = if *in_cell { "in its cell, whose list" } else { "near it, itself included, and its list" };
        write!(f, "particle {particle} has {count} particles {list} holds at most {most}")
    }
}

impl std::error::Error for Crowded {}
