//! Layouts: how a space of records lies in memory. Index to address, and the order of memory.

mod branches;
pub(crate) mod dense;
pub(crate) mod geometry;
pub(crate) mod map;
pub(crate) mod morton;
pub(crate) mod node;
pub(crate) mod place;

pub use branches::Both;
pub use dense::Dense;
pub(crate) use geometry::Geometry;
pub(crate) use map::Map;
pub use morton::Curve;
pub(crate) use node::order;
pub use node::{ALL, LAST};
#[doc(hidden)]
pub use node::{Chain, Digit, Inner};
#[doc(hidden)]
pub use place::{Entry, Named, Place, Spec, Taken};
pub use place::{Padded, PlaceAos, PlaceGroups, PlaceSoa, PlaceSome, PlaceSplit};

use crate::axes::Axes;
use crate::element::Sealed;

/// How a space over the axes `X` lies in memory: a named layout such as [`Soa`], or what [`layout!`](crate::layout!) makes.
///
/// A layout says nothing of the record: the same one serves any. It is a type, chosen where a field is made, and the
/// kernels that use the field do not see it.
///
/// ```
/// use allotrope::prelude::*;
/// let rows = Field::<f32, Aos>::new([100, 80]);
/// let tiles = Field::<f32, Blocked<4>>::new([100, 80]);
/// let columns = Field::<f32, layout!(dense(ji).aos)>::new([100, 80]);
/// assert_eq!(rows.len(), tiles.len());
/// assert_eq!(rows.shape(), columns.shape());
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no layout over the axes `{X}`",
    label = "not a layout over these axes",
    note = "a layout serves the axes that it names: `dense(ij)` a field over `Ij`; named layouts such as `Aos` serve all"
)]
pub trait Layout<X: Axes>: Copy + Send + Sync + Sealed + 'static {
    /// The nodes of constant size below the root of the first branch.
    #[doc(hidden)]
    type Inner: Inner<X>;
    /// The other branches; the layout itself, where it has one branch alone.
    #[doc(hidden)]
    type Rest: Layout<X>;
    /// How many branches it has.
    #[doc(hidden)]
    const BRANCHES: usize;
    /// The first branch.
    #[doc(hidden)]
    const CHAIN: Chain;
}

/// The root of a layout: as many cells along the axes of `ORDER` as the shape needs, each a chain `N`.
#[derive(Clone, Copy, Debug)]
pub struct Tree<const ORDER: u32, N>(core::marker::PhantomData<fn() -> N>);
impl<const ORDER: u32, N> Sealed for Tree<ORDER, N> {}
impl<const ORDER: u32, N: Inner<X>, X: Axes> Layout<X> for Tree<ORDER, N> {
    type Inner = N;
    type Rest = Self;
    const BRANCHES: usize = 1;
    const CHAIN: Chain = Chain::of::<N, X>(ORDER);
}

/// Record after record, the last axis fastest: `dense(..).aos`.
pub type Aos = Tree<ALL, PlaceAos>;
/// For each member, all its values: `dense(..).soa`.
pub type Soa = Tree<ALL, PlaceSoa>;
/// For each scalar component of each member, all its values: `dense(..).split`.
pub type Split = Tree<ALL, PlaceSplit>;
/// Blocks of `N` records along the last axis, each block member by member: `dense(i).dense(i, N).soa`.
pub type AoSoA<const N: usize> = Tree<ALL, Dense<LAST, N, N, N, N, PlaceSoa>>;
/// Blocks of `N` cells along every axis, record after record within a block: `dense(ij).dense(ij, N).aos`.
pub type Blocked<const N: usize> = Tree<ALL, Dense<ALL, N, N, N, N, PlaceAos>>;
/// Blocks of `N` cells along every axis in Z-order, record after record: `dense(ij).morton(ij, N).aos`. `N` is a power of two.
pub type Morton<const N: usize> = Tree<ALL, Curve<ALL, N, N, N, N, PlaceAos>>;
