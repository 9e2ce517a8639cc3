//! `Readable`: what a `#[func]` reads, handed on by a kernel or by anyone who has borrowed a field.

use super::Read;
use crate::axes::{Axes, I};
use crate::element::Sealed;
use crate::field::Source;
use crate::index::IntoIndex;
use crate::layout::{Layout, ListLayout};
use crate::record::{Path, Record};

/// Values `T` over the axes `X`, to read at any index: what a parameter `Read<T, _, X>` of a [`#[func]`](macro@crate::func) stands for
/// (`impl Readable<T, X>`, and `impl Readable<T, X, Layout = L>` where a layout is named).
///
/// Inside of a kernel's loop it is a member that is handed on, `f(grid.mass, x)`, or a whole field, `f(u, x)`; outside `&field`, `&field.members().mass` or a
/// slice serves as well.
///
/// ```
/// use allotrope::prelude::*;
///
/// /// The value between the elements at `x` and `x + 1`.
/// #[func]
/// fn linear(q: Read<f32, _>, x: f32) -> f32 {
///     let i = x.floor();
///     let t = x - i;
///     q.clamped(i as i32) * (1.0 - t) + q.clamped(i as i32 + 1) * t
/// }
///
/// #[kernel]
/// fn shift(from: &Field<f32, _>, to: &mut Field<f32, _>, by: f32) {
///     for i in to {
///         to[i] = linear(from, i as f32 - by);
///     }
/// }
///
/// let mut from = Field::<f32, AoSoA<8>>::new([10]);
/// from.set(4, 8.0);
/// let mut to = from.clone();
/// shift(&from, &mut to, 0.25);
/// assert_eq!((to.get(4), to.get(5)), (6.0, 2.0));
/// assert_eq!(linear(&from, 3.5), 4.0);
/// assert_eq!(linear(&[1.0, 2.0][..], 0.5), 1.5);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be read as values `{T}` over `{X}`",
    label = "not a member of such values",
    note = "in a kernel's loop, hand on a member, `f(grid.mass, ..)`, or a bare field, `f(u, ..)`; elsewhere `&field.members().mass` or `&field`"
)]
pub trait Readable<T: Copy, X: Axes = I>: Copy + Sealed {
    /// How the values lie.
    type Layout: Layout<X>;

    /// The value at an index: in a `#[func]` written `q[index]`.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    fn get(self, index: impl IntoIndex<X>) -> T;

    /// The value of the element nearest to an index.
    ///
    /// # Panics
    /// Where there is no element.
    #[track_caller]
    fn clamped(self, index: impl IntoIndex<X>) -> T;

    /// The value at an index modulo the extents.
    ///
    /// # Panics
    /// Where there is no element, or the index is larger than an `i64`.
    #[track_caller]
    fn wrapped(self, index: impl IntoIndex<X>) -> T;

    /// The value at an index, or `value` where it lies outside of the shape.
    fn or(self, index: impl IntoIndex<X>, value: T) -> T;

    /// Elements along each axis.
    fn shape(self) -> X::Extents;

    /// The first index along each axis.
    fn origin(self) -> X::Index;

    /// Elements in all.
    fn len(self) -> usize;

    /// How many entries a list has, of a field of lists; the index leaves out the lists' axis. The entries are `q[(list, 0)]` and so on.
    ///
    /// ```
    /// use allotrope::prelude::*;
    ///
    /// type Cells = layout!(dense(i).dynamic(j, 8).aos);
    ///
    /// /// The largest entry of a list.
    /// #[func]
    /// fn largest(cells: Read<u32, Cells, Ij>, cell: i32) -> u32 {
    ///     (0..cells.row_len(cell)).map(|entry| cells[(cell, entry)]).max().unwrap_or(0)
    /// }
    ///
    /// #[kernel]
    /// fn around(cells: &Field<u32, Cells, Ij>, most: &mut Field<u32, _>) {
    ///     for i in most.interior(1) {
    ///         most[i] = largest(cells, i - 1).max(largest(cells, i + 1));
    ///     }
    /// }
    ///
    /// let mut cells = Field::<u32, Cells>::new([3]);
    /// [4, 7, 2].map(|id| cells.append(2, id));
    /// let mut most = Field::<u32, Soa>::new([3]);
    /// around(&cells, &mut most);
    /// assert_eq!(most.to_vec(), [0, 7, 0]);
    /// assert_eq!(largest(&cells, 2), 7);
    /// ```
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    fn row_len(self, list: impl IntoIndex<X::Outer>) -> usize
    where
        Self::Layout: ListLayout<X>;

    /// Whether there is no element.
    fn is_empty(self) -> bool {
        self.len() == 0
    }
}

impl<R, L, X, P> Sealed for Read<'_, R, L, X, P> {}
impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Readable<P::Value, X> for Read<'_, R, L, X, P> {
    type Layout = L;
    #[inline(always)]
    #[track_caller]
    fn get(self, index: impl IntoIndex<X>) -> P::Value {
        Read::get(&self, index)
    }
    #[inline(always)]
    #[track_caller]
    fn clamped(self, index: impl IntoIndex<X>) -> P::Value {
        Read::clamped(&self, index)
    }
    #[inline(always)]
    #[track_caller]
    fn wrapped(self, index: impl IntoIndex<X>) -> P::Value {
        Read::wrapped(&self, index)
    }
    #[inline(always)]
    fn or(self, index: impl IntoIndex<X>, value: P::Value) -> P::Value {
        Read::or(&self, index, value)
    }
    #[inline(always)]
    fn shape(self) -> X::Extents {
        self.handle().geometry.extents::<X>()
    }
    #[inline(always)]
    fn origin(self) -> X::Index {
        X::index(self.handle().geometry.origin)
    }
    #[inline(always)]
    fn len(self) -> usize {
        self.handle().geometry.len()
    }
    #[inline(always)]
    #[track_caller]
    fn row_len(self, list: impl IntoIndex<X::Outer>) -> usize
    where
        L: ListLayout<X>,
    {
        Read::row_len(&self, list)
    }
}

impl<S: ?Sized> Sealed for &S {}
impl<T: Copy, X: Axes, S: Source<Axes = X, Value = T> + ?Sized> Readable<T, X> for &S {
    type Layout = S::Layout;
    #[inline]
    #[track_caller]
    fn get(self, index: impl IntoIndex<X>) -> T {
        crate::serial::read(self, S::PATH, index)
    }
    #[inline]
    #[track_caller]
    fn clamped(self, index: impl IntoIndex<X>) -> T {
        crate::serial::clamped(self, S::PATH, index)
    }
    #[inline]
    #[track_caller]
    fn wrapped(self, index: impl IntoIndex<X>) -> T {
        crate::serial::wrapped(self, S::PATH, index)
    }
    #[inline]
    #[track_caller]
    fn or(self, index: impl IntoIndex<X>, value: T) -> T {
        crate::serial::or(self, S::PATH, index, value)
    }
    fn shape(self) -> X::Extents {
        self.handle().geometry.extents::<X>()
    }
    #[inline(always)]
    fn origin(self) -> X::Index {
        X::index(self.handle().geometry.origin)
    }
    fn len(self) -> usize {
        self.handle().geometry.len()
    }
    #[track_caller]
    fn row_len(self, list: impl IntoIndex<X::Outer>) -> usize
    where
        S::Layout: ListLayout<X>,
    {
        crate::serial::row_len(self, list)
    }
}
