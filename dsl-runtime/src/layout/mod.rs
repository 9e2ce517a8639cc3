//! Layouts: how a space of records lies in memory. Index to address, and the order of memory.

mod bitmasked;
mod branches;
pub(crate) mod dense;
pub(crate) mod dynamic;
pub(crate) mod geometry;
mod grown;
pub(crate) mod levels;
pub(crate) mod map;
pub(crate) mod morton;
pub(crate) mod node;
pub(crate) mod place;
pub(crate) mod plan;
mod pointer;
mod sparse;

#[doc(hidden)]
pub use crate::store::list::Head;
pub use bitmasked::Masked;
pub use branches::Both;
pub use dense::Dense;
pub use dynamic::List;
pub(crate) use geometry::Geometry;
#[doc(hidden)]
pub use grown::SparseRoot;
pub use grown::{Grid, Grown, Hash, ListLayout, Listed, Sparse, SparseHash};
pub use levels::Leaf;
pub(crate) use levels::{Block, Levels};
#[doc(hidden)]
pub use levels::{Brick, ListSpec};
pub(crate) use map::Map;
pub use morton::Curve;
pub(crate) use node::order;
pub use node::{ALL, LAST};
#[doc(hidden)]
pub use node::{Chain, Digit, Inner};
#[doc(hidden)]
pub use node::{Root, Tree as TreeSpec};
pub use place::{Entry, Padded, PlaceAos, PlaceGroups, PlaceSoa, PlaceSome, PlaceSplit};
#[doc(hidden)]
pub use place::{GroupEntry, Named, Place, Spec, Taken};
pub use pointer::Table;

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
    /// The nodes of the first branch that point to blocks.
    #[doc(hidden)]
    type Levels: Levels<X>;
    /// What is remembered of the blocks around a base.
    #[doc(hidden)]
    type Corners: crate::view::Corners;
    /// How many branches it has.
    #[doc(hidden)]
    const BRANCHES: usize;
    /// The first branch.
    #[doc(hidden)]
    const CHAIN: Chain;
    /// Whether memory follows what is active, in the first branch where there are several.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// assert!(<Sparse<8> as Layout<Ij>>::SPARSE && !<Blocked<8> as Layout<Ij>>::SPARSE);
    /// ```
    const SPARSE: bool = Self::CHAIN.is_sparse();
    /// Whether its fields have no bounds, since its outermost node is `hash`: they are made by
    /// [`unbounded`](crate::Field::unbounded) and not by [`new`](crate::Field::new).
    const UNBOUNDED: bool = matches!(&Self::CHAIN.tree, Some(tree) if matches!(tree.root, Root::Hash));
}

/// The root of a layout: as many cells along the axes of `ORDER` as the shape needs, each a chain `N`.
#[derive(Clone, Copy, Debug)]
pub struct Tree<const ORDER: u32, N>(core::marker::PhantomData<fn() -> N>);
impl<const ORDER: u32, N> Sealed for Tree<ORDER, N> {}
impl<const ORDER: u32, N: Inner<X>, X: Axes> Layout<X> for Tree<ORDER, N> {
    type Inner = N;
    type Rest = Self;
    type Levels = Leaf;
    type Corners = ();
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

/// A layout in which a field is made from extents along the axes `G`. `K` tells the two kinds of layouts apart and is always inferred.
#[diagnostic::on_unimplemented(
    message = "no field in the layout `{Self}` is made from extents along `{G}`",
    label = "not a layout for so many extents",
    note = "a layout serves the axes that it names: `dense(ij)` takes two extents; where it has a `dynamic` node, that axis is left out"
)]
pub trait Opens<G: Axes, K>: Layout<Self::X> {
    /// The axes of the field.
    type X: Axes;
    #[doc(hidden)]
    fn extents(given: crate::axes::PerAxis) -> Result<crate::axes::PerAxis, crate::field::ShapeError>;
}

/// Marks layouts whose fields have as many axes as extents.
#[derive(Clone, Copy, Debug)]
pub struct AllAxes;
/// Marks layouts whose fields have an axis more, which the entries of lists are counted along.
#[derive(Clone, Copy, Debug)]
pub struct ListAxis;

impl<L: Layout<X>, X: Axes> Opens<X, AllAxes> for L {
    type X = X;
    fn extents(given: crate::axes::PerAxis) -> Result<crate::axes::PerAxis, crate::field::ShapeError> {
        match L::CHAIN.tree.and_then(|tree| tree.list) {
            Some(list) => Err(crate::field::ShapeError::ListExtent { axis: crate::axes::AXIS_NAMES[list.axis] }),
            None => Ok(given),
        }
    }
}
impl<T: SparseRoot, V: Levels<X>, N: Inner<X>, X: Axes<Outer = G>, G: Axes> Opens<G, ListAxis> for Listed<X, T, V, N> {
    type X = X;
    fn extents(given: crate::axes::PerAxis) -> Result<crate::axes::PerAxis, crate::field::ShapeError> {
        let list = V::LIST.expect("such a layout has lists");
        Ok(core::array::from_fn(|a| match a {
            _ if a == list.axis => list.most,
            _ if a < list.axis => given[a],
            _ => given[a - 1],
        }))
    }
}
