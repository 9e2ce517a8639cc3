//! What a kernel takes as a field: a field, one member of it, or a slice.

use super::{Field, Handle, Member, MemberMut, OutOfRange};
use crate::axes::{Axes, I, MAX_AXES};
use crate::element::{Element, Packed, Sealed};
use crate::field::host::{Places, out_of_range};
use crate::index::IntoIndex;
use crate::layout::{Aos, Geometry, Layout};
use crate::record::{Path, Record, Whole};

/// What a kernel indexes: a field, one member of a field, or a slice. See [`AnyMember`], which says what values it holds.
///
/// ```
/// use allotrope::{Source, prelude::*};
///
/// /// Fields, members and slices over the same axes, of any values.
/// fn alike(_: &(impl Source<Axes = I> + ?Sized), _: &(impl Source<Axes = I> + ?Sized)) {}
/// alike(&Field::<Vec2, Soa>::new([3]), &[1.0f32][..]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be used as a field in a kernel",
    label = "neither a field, nor a member, nor a slice of elements",
    note = "a kernel's loops run over and write to `Field`s, members of them, and slices `[T]` of elements"
)]
pub trait Source: Sealed + Sync {
    /// The records that lie there.
    #[doc(hidden)]
    type Record: Record;
    /// How they lie.
    type Layout: Layout<Self::Axes>;
    /// The axes.
    type Axes: Axes;
    /// What an index names.
    type Value: Copy + Send + Sync + 'static;
    #[doc(hidden)]
    type Path: Path<Self::Record, Value = Self::Value>;
    #[doc(hidden)]
    const PATH: Self::Path;
    /// Whether a reference borrows all of the memory, rather than some members of records.
    #[doc(hidden)]
    const WHOLE: bool;
    #[doc(hidden)]
    fn handle(&self) -> Handle<'_, Self::Record, Self::Layout, Self::Axes>;
}

/// As [`Source`], to be changed: `&mut` of a field or a slice, or a member from `members_mut`.
///
/// ```
/// use allotrope::{SourceMut, prelude::*};
///
/// fn changed(_: &mut impl SourceMut<Axes = Ij, Value = f32>) {}
/// changed(&mut Field::<f32, Soa>::new([3, 4]));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be changed by a kernel",
    label = "only for reading",
    note = "members are changed through `field.members_mut()`"
)]
pub trait SourceMut: Source {
    #[doc(hidden)]
    fn handle_mut(&mut self) -> Handle<'_, Self::Record, Self::Layout, Self::Axes>;
}

/// Values `T` over the axes `X`, wherever they lie: one member of a field's records, a field of bare elements, or, over one
/// axis, a slice.
///
/// It is what a kernel's parameter `&Member<T, _, X>` stands for (`&impl AnyMember<T, X>`), so that a kernel is written once and
/// called with members of different records in different layouts. With a layout named, `&Member<T, L, X>`, it is
/// `&impl AnyMember<T, X, Layout = L>`.
///
/// ```
/// use allotrope::AnyMember;
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy, Default)]
/// struct Search {
///     x: f32,
///     r: f32,
/// }
///
/// #[kernel]
/// fn dot(a: &Member<f32, _, Ij>, b: &Member<f32, _, Ij>) -> f32 {
///     let mut sum = 0.0;
///     for ij in a {
///         sum += a[ij] * b[ij];
///     }
///     sum
/// }
///
/// /// A function around kernels takes the same.
/// fn norm(a: &impl AnyMember<f32, Ij>) -> f32 {
///     dot(a, a).sqrt()
/// }
///
/// let mut search = Field::<Search, Soa>::new([4, 4]);
/// search.members_mut().r.fill(2.0);
/// let ones = Field::<f32, Blocked<2>>::new([4, 4]).with_background(1.0);
/// assert_eq!(dot(&search.members().r, &ones), 32.0);
/// assert_eq!(norm(&search.members().r), 8.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no member that holds `{T}` over `{X}`",
    label = "not a member of such values",
    note = "hand in `&field.members().name`, `&mut field.members_mut().name`, a bare field `Field<{T}, _, {X}>`, or, over one axis, a slice"
)]
pub trait AnyMember<T: Element, X: Axes = I>: Source<Axes = X, Value = T> {
    /// Elements along each axis.
    fn shape(&self) -> X::Extents {
        self.handle().geometry.extents::<X>()
    }

    /// The first index along each axis: [`Field::origin`].
    fn origin(&self) -> X::Index {
        X::index(self.handle().geometry.origin)
    }

    /// Elements in all.
    fn len(&self) -> usize {
        self.handle().geometry.len()
    }

    /// Whether there is no element.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    fn get(&self, index: impl IntoIndex<X>) -> T {
        let at = find(self, index).unwrap_or_else(|error| out_of_range::<Self::Record>(&error));
        // SAFETY: `find` returns indices within the shape; `&self` keeps writers away.
        unsafe { self.handle().read::<Self::Path>(at) }
    }

    /// All values in logical row-major order.
    fn to_vec(&self) -> Vec<T> {
        let handle = self.handle();
        // SAFETY: places lie within the shape; `&self` keeps writers away.
        Places::<X>::new(handle.geometry.shape).map(|at| unsafe { handle.read::<Self::Path>(at) }).collect()
    }
}

/// As [`AnyMember`], to change the values: what a kernel's parameter `&mut Member<T, _, X>` stands for.
///
/// The members of one record that `members_mut` gives are apart from each other, so that a kernel may take several.
///
/// ```
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy, Default)]
/// struct Search {
///     x: f32,
///     p: f32,
/// }
///
/// #[kernel]
/// fn axpy(y: &mut Member<f32, _>, a: f32, x: &Member<f32, _>) {
///     for i in y {
///         y[i] += a * x[i];
///     }
/// }
///
/// let mut search = Field::<Search, Aos>::new([100]).with_background(Search { x: 1.0, p: 2.0 });
/// let mut members = search.members_mut();
/// axpy(&mut members.x, 0.5, &members.p);
/// assert_eq!(search.get(7).x, 2.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no member that holds `{T}` over `{X}` and may be changed",
    label = "not such a member",
    note = "hand in `&mut field.members_mut().name`, a bare field `&mut Field<{T}, _, {X}>`, or, over one axis, a slice"
)]
pub trait AnyMemberMut<T: Element, X: Axes = I>: AnyMember<T, X> + SourceMut {
    /// Puts a value at an index.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[track_caller]
    fn set(&mut self, index: impl IntoIndex<X>, value: T) {
        let at = find(self, index).unwrap_or_else(|error| out_of_range::<Self::Record>(&error));
        // SAFETY: `find` returns indices within the shape; `&mut self` is exclusive.
        unsafe { self.handle_mut().write::<Self::Path>(at, value) };
    }

    /// Puts the same value everywhere.
    fn fill(&mut self, value: T) {
        let handle = self.handle_mut();
        for at in Places::<X>::new(handle.geometry.shape) {
            // SAFETY: places lie within the shape; `&mut self` is exclusive.
            unsafe { handle.write::<Self::Path>(at, value) };
        }
    }
}

impl<T: Element, X: Axes, S: Source<Axes = X, Value = T> + ?Sized> AnyMember<T, X> for S {}
impl<T: Element, X: Axes, S: SourceMut + Source<Axes = X, Value = T> + ?Sized> AnyMemberMut<T, X> for S {}

/// The place of an index.
pub(crate) fn find<S: Source<Axes = X> + ?Sized, X: Axes>(
    source: &S,
    index: impl IntoIndex<X>,
) -> Result<[u32; MAX_AXES], OutOfRange> {
    let handle = source.handle();
    handle.locate(index).ok_or_else(|| OutOfRange::new(index, &handle.geometry))
}

impl<R, L, X> Sealed for Field<R, L, X> {}
impl<R: Record, L: Layout<X>, X: Axes> Source for Field<R, L, X> {
    type Record = R;
    type Layout = L;
    type Axes = X;
    type Value = R;
    type Path = Whole;
    const PATH: Whole = Whole;
    const WHOLE: bool = true;
    #[inline(always)]
    fn handle(&self) -> Handle<'_, R, L, X> {
        Field::handle(self)
    }
}
impl<R: Record, L: Layout<X>, X: Axes> SourceMut for Field<R, L, X> {
    #[inline(always)]
    fn handle_mut(&mut self) -> Handle<'_, R, L, X> {
        Field::handle_mut(self)
    }
}

macro_rules! members {
    ($($member:ident)*) => {$(
        impl<R, L, X, P> Sealed for $member<'_, R, L, X, P> {}
        impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Source for $member<'_, R, L, X, P> {
            type Record = R;
            type Layout = L;
            type Axes = X;
            type Value = P::Value;
            type Path = P;
            const PATH: P = P::PATH;
            const WHOLE: bool = false;
            #[inline(always)]
            fn handle(&self) -> Handle<'_, R, L, X> {
                *$member::handle(self)
            }
        }
    )*};
}
members!(Member MemberMut);
impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> SourceMut for MemberMut<'_, R, L, X, P> {
    #[inline(always)]
    fn handle_mut(&mut self) -> Handle<'_, R, L, X> {
        *MemberMut::handle(self)
    }
}

/// The geometry of a slice: that of an interleaved field over one axis.
#[inline]
fn geometry(len: usize) -> Geometry {
    Geometry::new::<Aos, I>([len, 1, 1, 1]).unwrap_or_else(|error| panic!("a slice in a kernel: {error}"))
}

impl<T> Sealed for [T] {}
impl<T: Packed> Source for [T] {
    type Record = T;
    type Layout = Aos;
    type Axes = I;
    type Value = T;
    type Path = Whole;
    const PATH: Whole = Whole;
    const WHOLE: bool = true;
    #[inline]
    fn handle(&self) -> Handle<'_, T, Aos, I> {
        // The address serves for reading alone: whoever writes has it from `handle_mut`.
        Handle::of_slice(self.as_ptr().cast_mut().cast(), geometry(self.len()))
    }
}
impl<T: Packed> SourceMut for [T] {
    #[inline]
    fn handle_mut(&mut self) -> Handle<'_, T, Aos, I> {
        Handle::of_slice(self.as_mut_ptr().cast(), geometry(self.len()))
    }
}
