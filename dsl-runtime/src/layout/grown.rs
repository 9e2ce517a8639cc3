//! Sparse layouts: a root, the nodes that point to blocks, and the blocks.

use core::marker::PhantomData;

use super::levels::Levels;
use super::node::{Chain, Inner, Root, Tree};
use super::{ALL, Dense, Entry, Layout, Leaf, PlaceAos, Table};
use crate::axes::Axes;
use crate::element::Sealed;

/// A root of as many cells along the axes of `ORDER` as the shape needs.
#[derive(Clone, Copy, Debug)]
pub struct Grid<const ORDER: u32>;
/// `hash(ijk)`: a root without bounds, whose cells are found by hashing.
#[derive(Clone, Copy, Debug)]
pub struct Hash<const ORDER: u32>;

/// The root of a sparse layout.
#[doc(hidden)]
pub trait SparseRoot: Copy + Send + Sync + Sealed + 'static {
    /// The order of its axes.
    const ORDER: u32;
    /// Whether its cells are found by hashing.
    const HASHED: bool;
}
impl<const ORDER: u32> Sealed for Grid<ORDER> {}
impl<const ORDER: u32> SparseRoot for Grid<ORDER> {
    const ORDER: u32 = ORDER;
    const HASHED: bool = false;
}
impl<const ORDER: u32> Sealed for Hash<ORDER> {}
impl<const ORDER: u32> SparseRoot for Hash<ORDER> {
    const ORDER: u32 = ORDER;
    const HASHED: bool = true;
}

/// A layout whose memory follows what is active: the root `T`, the nodes `V` that point to blocks, and the block `N`.
#[derive(Clone, Copy, Debug)]
pub struct Grown<T, V, N>(PhantomData<(Type<T>, Type<V>, Type<N>)>);
/// A type that is named alone.
type Type<T> = fn() -> T;
impl<T, V, N> Sealed for Grown<T, V, N> {}
impl<T: SparseRoot, V: Levels<X>, N: Inner<X>, X: Axes> Layout<X> for Grown<T, V, N> {
    type Inner = N;
    type Rest = Self;
    type Levels = V;
    type Corners = crate::view::EightCorners;
    const BRANCHES: usize = 1;
    const CHAIN: Chain = chain::<T, V, N, X>();
}

/// A layout of lists over the axes `X`, one of which is the lists' own.
#[derive(Clone, Copy, Debug)]
pub struct Listed<X, T, V, N>(PhantomData<(Type<X>, Grown<T, V, N>)>);
impl<X, T, V, N> Sealed for Listed<X, T, V, N> {}
impl<T: SparseRoot, V: Levels<X>, N: Inner<X>, X: Axes> Layout<X> for Listed<X, T, V, N> {
    type Inner = N;
    type Rest = Self;
    type Levels = V;
    type Corners = crate::view::EightCorners;
    const BRANCHES: usize = 1;
    const CHAIN: Chain = chain::<T, V, N, X>();
}

const fn chain<T: SparseRoot, V: Levels<X>, N: Inner<X>, X: Axes>() -> Chain {
    let root = if T::HASHED { Root::Hash } else { Root::Grid };
    let tree = Tree { root, span: V::SPAN, list: V::LIST, grain: N::GRAIN };
    Chain { tree: Some(tree), ..Chain::of::<N, X>(T::ORDER) }
}

/// A layout with lists, whose fields are appended to.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no lists: a field in this layout cannot be appended to",
    label = "a layout without a `dynamic` node",
    note = "`append`, `remove` and `row` are for layouts with a `dynamic` node: `layout!(dense(i).dynamic(j, 64).aos)`"
)]
pub trait ListLayout<X: Axes>: Layout<X> {}
impl<T: SparseRoot, V: Levels<X>, N: Inner<X>, X: Axes> ListLayout<X> for Listed<X, T, V, N> {}

/// Pointers to blocks of `N` cells along every axis, record after record within a block: `pointer(ij).dense(ij, N).aos`.
pub type Sparse<const N: usize> = Grown<Grid<ALL>, Table<Entry, Leaf>, Dense<ALL, N, N, N, N, PlaceAos>>;
/// Blocks of `N` cells along every axis, found by hashing: `hash(ij).dense(ij, N).aos`.
pub type SparseHash<const N: usize> = Grown<Hash<ALL>, Leaf, Dense<ALL, N, N, N, N, PlaceAos>>;
