//! Fields outside of parallel loops: the kernel's top level and serial loops. Every access is checked.

use core::ops::Range;

use crate::axes::{Axes, MAX_AXES};
use crate::element::Element;
use crate::field::source::find;
use crate::field::{Entries, EntryTuples, Handle, Source, SourceMut, active_places};
use crate::index::{Integer, IntoIndex};
use crate::launch::Border;
use crate::layout::{Geometry, Layout, ListLayout, Map};
use crate::number::{Number, zip};
use crate::record::{Path, Record};
use crate::view::{Read, Site, View, shared};

/// Stands for a field's name in the body of a parallel loop, where fields are accessed by index alone.
#[derive(Clone, Copy, Debug)]
pub struct NotAnAccess;

/// The names of a field's members.
#[inline(always)]
pub fn tags<S: Source + ?Sized>(_: &S) -> <S::Record as Record>::Tags {
    <S::Record as Record>::TAGS
}

/// What an index of it names.
#[inline(always)]
pub fn path<S: Source + ?Sized>(_: &S) -> S::Path {
    S::PATH
}

/// A path of a field to be read by a function that it is handed to.
#[inline(always)]
pub fn lend<'a, S: Source + ?Sized, P: Path<S::Record>>(
    field: &'a S,
    path: P,
    site: &'static Site,
) -> Read<'a, S::Record, S::Layout, S::Axes, P> {
    shared(field, site).read(path)
}

/// A checked index: its place in the field.
#[derive(Clone, Copy, Debug)]
pub struct Located([u32; MAX_AXES]);

/// Checks an index.
///
/// # Panics
/// Where it lies outside of the shape.
#[inline]
#[track_caller]
pub fn locate<S: Source<Axes = X> + ?Sized, X: Axes>(field: &S, index: impl IntoIndex<X>) -> Located {
    match find(field, index) {
        Ok(at) => Located(at),
        Err(error) => crate::field::out_of_range::<S::Record>(&error),
    }
}

/// The value of a path at a checked index.
#[inline]
#[track_caller]
pub fn read_at<S: Source + ?Sized, P: Path<S::Record>>(field: &S, _: P, at: Located) -> P::Value {
    let at = recheck(field, at);
    // SAFETY: within this field's shape; the shared borrow keeps writers away.
    unsafe { field.handle().read::<P>(at) }
}

/// Puts a value at a checked index.
#[inline]
#[track_caller]
pub fn write_at<S: SourceMut + ?Sized, P: Path<S::Record>>(field: &mut S, _: P, at: Located, value: P::Value) {
    let at = recheck(field, at);
    // SAFETY: within this field's shape; `&mut` is exclusive.
    unsafe { field.handle_mut().write::<P>(at, value) }
}

/// An index that was checked against one field may be handed to another.
#[inline(always)]
#[track_caller]
fn recheck<S: Source + ?Sized>(field: &S, Located(at): Located) -> [u32; MAX_AXES] {
    let handle = field.handle();
    let shape = handle.geometry.shape;
    assert!(crate::axes::all::<S::Axes>(|a| at[a] < shape[a]), "an index of another field");
    at
}

/// The value of a path at an index, which is checked with debug assertions alone.
///
/// # Safety
/// The index lies within the shape.
#[inline]
#[track_caller]
pub unsafe fn get_unchecked<S: Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &S,
    path: P,
    index: impl IntoIndex<X>,
) -> P::Value {
    if cfg!(debug_assertions) {
        return read(field, path, index);
    }
    let handle = field.handle();
    let at = handle.geometry.place(index.coordinates());
    // SAFETY: as the caller promises; the shared borrow keeps writers away.
    unsafe { handle.read::<P>(at) }
}

/// Puts a value at an index, which is checked with debug assertions alone.
///
/// # Safety
/// The index lies within the shape.
#[inline]
#[track_caller]
pub unsafe fn set_unchecked<S: SourceMut + Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &mut S,
    path: P,
    index: impl IntoIndex<X>,
    value: P::Value,
) {
    if cfg!(debug_assertions) {
        return write(field, path, index, value);
    }
    let handle = field.handle_mut();
    let at = handle.geometry.place(index.coordinates());
    // SAFETY: as the caller promises; `&mut` is exclusive.
    unsafe { handle.write::<P>(at, value) }
}

/// The value of a path at an index.
///
/// # Panics
/// Where it lies outside of the shape.
#[inline]
#[track_caller]
pub fn read<S: Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &S,
    path: P,
    index: impl IntoIndex<X>,
) -> P::Value {
    read_at(field, path, locate(field, index))
}

/// The value of a path at the element nearest to an index.
///
/// # Panics
/// Where the field has no element.
#[inline]
#[track_caller]
pub fn clamped<S: Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &S,
    path: P,
    index: impl IntoIndex<X>,
) -> P::Value {
    // Where there is no such element, `locate` says so.
    match crate::index::clamped::<X>(index.coordinates(), &field.handle().geometry) {
        Some(at) => read_at(field, path, Located(at)),
        None => read(field, path, index),
    }
}

/// The value of a path at an index modulo the extents.
///
/// # Panics
/// Where the field has no element, or the index is larger than an `i64`.
#[inline]
#[track_caller]
pub fn wrapped<S: Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &S,
    path: P,
    index: impl IntoIndex<X>,
) -> P::Value {
    // Where there is no such element, `locate` says so.
    match crate::index::wrapped::<X>(index.coordinates(), &field.handle().geometry) {
        Some(at) => read_at(field, path, Located(at)),
        None => read(field, path, index),
    }
}

/// The value of a path at an index, or `value` where it lies outside of the shape.
#[inline]
#[track_caller]
pub fn or<S: Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &S,
    path: P,
    index: impl IntoIndex<X>,
    value: P::Value,
) -> P::Value {
    match field.handle().locate(index) {
        Some(at) => read_at(field, path, Located(at)),
        None => value,
    }
}

/// Puts a value at an index.
///
/// # Panics
/// Where it lies outside of the shape.
#[inline]
#[track_caller]
pub fn write<S: SourceMut + Source<Axes = X> + ?Sized, X: Axes, P: Path<S::Record>>(
    field: &mut S,
    path: P,
    index: impl IntoIndex<X>,
    value: P::Value,
) {
    let at = locate(field, index);
    write_at(field, path, at, value);
}

/// `min_assign`: the smaller, component by component.
#[inline(always)]
pub fn min<E: Element>(a: E, b: E) -> E
where
    E::Scalar: Number,
{
    zip::<crate::number::Min, E>(a, b)
}

/// `max_assign`: the larger, component by component.
#[inline(always)]
pub fn max<E: Element>(a: E, b: E) -> E
where
    E::Scalar: Number,
{
    zip::<crate::number::Max, E>(a, b)
}

/// The logical coordinates of a field's elements but a border, in the order of the memory of the branch that holds a member, blocks
/// aside: the last axis of the root fastest. Of a sparse branch, those of the elements that are active now.
fn walk<R: Record, L: Layout<X>, X: Axes>(
    handle: &Handle<'_, R, L, X>,
    m: usize,
    border: u32,
) -> impl Iterator<Item = [i32; MAX_AXES]> + use<R, L, X> {
    let geometry = handle.geometry;
    let is_sparse = Map::<R, L, X>::is_sparse(m);
    let active = if is_sparse { active_places(handle, m) } else { Vec::new() };
    let shape = geometry.shape;
    let inside = move |place: &[u32; MAX_AXES]| {
        (0..X::RANK).all(|a| place[a] >= border && place[a] < shape[a].saturating_sub(border))
    };
    let active = active.into_iter().filter(inside).map(move |place| geometry.logical(place));
    let all = (!is_sparse).then(|| walk_all::<X>(Map::<R, L, X>::chain(m).root, geometry, border));
    all.into_iter().flatten().chain(active)
}

fn walk_all<X: Axes>(order: u32, geometry: Geometry, border: u32) -> impl Iterator<Item = [i32; MAX_AXES]> {
    let shape = geometry.shape;
    let (named, count) = crate::layout::order::<X>(order);
    let mut axes: Vec<usize> = (0..X::RANK).filter(|a| !named[..count].contains(a)).collect();
    axes.extend_from_slice(&named[..count]);
    let first = |a: usize| border.min(shape[a]);
    let bounds: [(u32, u32); MAX_AXES] = core::array::from_fn(|a| {
        if a < X::RANK { (first(a), shape[a].saturating_sub(border).max(first(a))) } else { (0, 1) }
    });
    let mut left: usize = bounds[..X::RANK].iter().map(|&(first, end)| (end - first) as usize).product();
    let mut next = bounds.map(|(first, _)| first);
    core::iter::from_fn(move || {
        left = left.checked_sub(1)?;
        let at = geometry.logical(next);
        for &axis in axes.iter().rev() {
            next[axis] += 1;
            if next[axis] < bounds[axis].1 {
                break;
            }
            next[axis] = bounds[axis].0;
        }
        Some(at)
    })
}

/// The first member of what an index of a source names.
fn member<S: Source + ?Sized>(_: &S) -> usize {
    <S::Path as Path<S::Record>>::OFFSET
}

/// The indices of a field, which need not be borrowed meanwhile.
pub fn indices<S: Source<Axes = X> + ?Sized, X: Axes>(field: &S) -> impl Iterator<Item = X::Index> + use<S, X> {
    walk(&field.handle(), member(field), 0).map(X::index)
}

/// The indices of a field as tuples.
pub fn index_tuples<S: Source<Axes = X> + ?Sized, X: Axes>(field: &S) -> impl Iterator<Item = X::Tuple> + use<S, X> {
    walk(&field.handle(), member(field), 0).map(X::tuple)
}

/// The indices of a field but a border.
pub fn interior_indices<S: Source<Axes = X> + ?Sized, X: Axes>(
    field: &S,
    width: u32,
) -> impl Iterator<Item = X::Index> + use<S, X> {
    walk(&field.handle(), member(field), width).map(X::index)
}

/// The indices of a field but a border, as tuples.
pub fn interior_tuples<S: Source<Axes = X> + ?Sized, X: Axes>(
    field: &S,
    width: u32,
) -> impl Iterator<Item = X::Tuple> + use<S, X> {
    walk(&field.handle(), member(field), width).map(X::tuple)
}

/// The indices of a list's entries, as they are now.
///
/// # Panics
/// Where the index lies outside of the shape.
#[track_caller]
pub fn row<S: Source<Axes = X, Layout: ListLayout<X>> + ?Sized, X: Axes>(
    field: &S,
    index: impl IntoIndex<X::Outer>,
) -> Entries<X> {
    let handle = field.handle();
    let (at, logical) = handle.list(index);
    match at {
        Some(at) => handle.entries_at(at),
        None => crate::field::out_of_range::<S::Record>(&crate::field::OutOfRange::at::<X>(logical, &handle.geometry)),
    }
}

/// How many entries a list has.
///
/// # Panics
/// Where the index lies outside of the shape.
#[track_caller]
pub(crate) fn row_len<S: Source<Axes = X, Layout: ListLayout<X>> + ?Sized, X: Axes>(
    field: &S,
    index: impl IntoIndex<X::Outer>,
) -> usize {
    let handle = field.handle();
    let (at, logical) = handle.list(index);
    match at {
        Some(at) => handle.row_len_at(at),
        None => crate::field::out_of_range::<S::Record>(&crate::field::OutOfRange::at::<X>(logical, &handle.geometry)),
    }
}

/// The same as tuples.
///
/// # Panics
/// Where the index lies outside of the shape.
#[track_caller]
pub fn row_tuples<S: Source<Axes = X, Layout: ListLayout<X>> + ?Sized, X: Axes>(
    field: &S,
    index: impl IntoIndex<X::Outer>,
) -> EntryTuples<X> {
    let handle = field.handle();
    let (at, logical) = handle.list(index);
    match at {
        Some(at) => handle.entries_at(at).tuples(),
        None => crate::field::out_of_range::<S::Record>(&crate::field::OutOfRange::at::<X>(logical, &handle.geometry)),
    }
}

/// The border of a field.
pub fn border<S: Source + ?Sized>(field: &S, width: u32) -> Border {
    Border::new::<S::Axes>(&field.handle().geometry, width)
}

/// Serial loops inside parallel ones.
impl<R: Record, L: Layout<X>, X: Axes, const WRITE: bool> View<'_, R, L, X, WRITE> {
    /// The indices of the field.
    pub fn indices(&self) -> impl Iterator<Item = X::Index> + use<R, L, X, WRITE> {
        walk(&self.handle, 0, 0).map(X::index)
    }

    /// The indices of the field as tuples.
    pub fn index_tuples(&self) -> impl Iterator<Item = X::Tuple> + use<R, L, X, WRITE> {
        walk(&self.handle, 0, 0).map(X::tuple)
    }

    /// The indices of the field but a border.
    pub fn interior_indices(&self, width: u32) -> impl Iterator<Item = X::Index> + use<R, L, X, WRITE> {
        walk(&self.handle, 0, width).map(X::index)
    }

    /// The indices of the field but a border, as tuples.
    pub fn interior_tuples(&self, width: u32) -> impl Iterator<Item = X::Tuple> + use<R, L, X, WRITE> {
        walk(&self.handle, 0, width).map(X::tuple)
    }
}

/// Ranges that a serial loop runs over, the last fastest.
pub trait Ranges {
    /// A tuple of integers.
    type Item;
    /// All of them.
    fn walk(self) -> impl Iterator<Item = Self::Item>;
}
fn span<T: Integer>(range: Range<T>) -> impl Iterator<Item = T> + Clone {
    (range.start.wide()..range.end.wide()).map(T::narrow)
}
impl<T: Integer> Ranges for (Range<T>,) {
    type Item = (T,);
    fn walk(self) -> impl Iterator<Item = Self::Item> {
        span(self.0).map(|i| (i,))
    }
}
impl<T: Integer, U: Integer> Ranges for (Range<T>, Range<U>) {
    type Item = (T, U);
    fn walk(self) -> impl Iterator<Item = Self::Item> {
        let inner = span(self.1);
        span(self.0).flat_map(move |i| inner.clone().map(move |j| (i, j)))
    }
}
impl<T: Integer, U: Integer, V: Integer> Ranges for (Range<T>, Range<U>, Range<V>) {
    type Item = (T, U, V);
    fn walk(self) -> impl Iterator<Item = Self::Item> {
        let (middle, inner) = (span(self.1), span(self.2));
        span(self.0).flat_map(move |i| {
            let inner = inner.clone();
            middle.clone().flat_map(move |j| inner.clone().map(move |k| (i, j, k)))
        })
    }
}

impl<T: Integer, U: Integer, V: Integer, W: Integer> Ranges for (Range<T>, Range<U>, Range<V>, Range<W>) {
    type Item = (T, U, V, W);
    fn walk(self) -> impl Iterator<Item = Self::Item> {
        let (outer, inner) = ((self.0, self.1, self.2), span(self.3));
        outer.walk().flat_map(move |(i, j, k)| inner.clone().map(move |l| (i, j, k, l)))
    }
}

/// `ndrange!` in a serial loop.
pub fn ndrange<T: Ranges>(ranges: T) -> impl Iterator<Item = T::Item> {
    ranges.walk()
}

/// Tells the optimiser that what follows is rare.
#[cold]
#[inline(never)]
pub fn cold() {}

/// Bytes from a field's start to a component: for tests of layouts.
///
/// # Panics
/// Where the index, member or component does not exist.
pub fn byte_offset<R: Record, L: Layout<X>, X: Axes>(
    field: &crate::Field<R, L, X>,
    index: impl IntoIndex<X>,
    member: usize,
    component: usize,
) -> usize {
    use crate::record::ElementList;
    assert!(component < R::Elements::MEMBERS[member].components, "no such component");
    let Located(at) = locate(field, index);
    let geometry = field.handle().geometry;
    Map::<R, L, X>::offset(&geometry, member, at) + component * Map::<R, L, X>::component(&geometry, member)
}
