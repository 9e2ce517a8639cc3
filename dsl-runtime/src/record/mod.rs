//! Records: what one element of a field holds.

mod lists;

use core::marker::PhantomData;
use core::mem::size_of;

use crate::axes::Axes;
use crate::element::{Element, Kind, Scalar};
use crate::field::Handle;
use crate::layout::Layout;

/// The most members that a record can have.
pub const MAX_MEMBERS: usize = 24;

/// What a layout needs to know of a member.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemberSpec {
    /// How many components it has.
    pub components: usize,
    /// The bytes of one component, and their alignment.
    pub scalar: usize,
    /// Which scalar it is.
    pub kind: Kind,
}

impl MemberSpec {
    /// The facts of an element type.
    pub(crate) const fn of<E: Element>() -> Self {
        Self { components: E::COMPONENTS, scalar: size_of::<E::Scalar>(), kind: E::Scalar::KIND }
    }
}

/// What one element of a field holds: a plain struct of elements, made by `#[derive(Record)]`, or a bare element.
///
/// A layout takes records apart member by member or component by component; a kernel names members and never sees how
/// they lie.
///
/// ```
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
/// struct Point {
///     x: Vec2,
///     mass: f32,
/// }
/// let mut points = Field::<Point, Soa>::new([8]);
/// points.set(3, Point { x: vec2(1.0, 2.0), mass: 0.5 });
/// assert_eq!(points.get(3).mass, 0.5);
/// assert_eq!(points.get(4), Point::default());
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no record: a field cannot hold it",
    label = "not a record",
    note = "write `#[derive(Record, Clone, Copy)]` on a struct with named members, or use an element such as f32 or Vec2"
)]
pub trait Record: Copy + Send + Sync + 'static {
    /// The types of its members, in declared order.
    #[doc(hidden)]
    type Elements: ElementList;
    /// Their names, in the same order.
    const NAMES: &'static [&'static str];
    /// A struct with one public field a member: how expansions name members.
    #[doc(hidden)]
    type Tags: Copy;
    #[doc(hidden)]
    const TAGS: Self::Tags;
    /// A struct with one public field a member: `field.members().x`.
    type Members<'a, L: Layout<X>, X: Axes>;
    /// The same, to change them: `field.members_mut().x`.
    type MembersMut<'a, L: Layout<X>, X: Axes>;
    #[doc(hidden)]
    fn members<'a, L: Layout<X>, X: Axes>(all: MemberRefs<'a, Self, L, X>) -> Self::Members<'a, L, X>;
    #[doc(hidden)]
    fn members_mut<'a, L: Layout<X>, X: Axes>(all: MemberMuts<'a, Self, L, X>) -> Self::MembersMut<'a, L, X>;
    #[doc(hidden)]
    fn from_elements(elements: Self::Elements) -> Self;
    #[doc(hidden)]
    fn into_elements(self) -> Self::Elements;
}

/// The members of a field, as a tuple.
#[doc(hidden)]
pub type MemberRefs<'a, R, L, X> = <<R as Record>::Elements as ElementList>::Members<'a, R, L, X>;
/// The members of a field to change, as a tuple: each stands once, so that no two of them alias.
#[doc(hidden)]
pub type MemberMuts<'a, R, L, X> = <<R as Record>::Elements as ElementList>::MembersMut<'a, R, L, X>;

/// A bare element is a record of one unnamed member.
impl<E: Element> Record for E {
    type Elements = (E,);
    const NAMES: &'static [&'static str] = &["0"];
    type Tags = (Tag<E, 0>,);
    const TAGS: Self::Tags = (Tag::NEW,);
    type Members<'a, L: Layout<X>, X: Axes> = MemberRefs<'a, E, L, X>;
    type MembersMut<'a, L: Layout<X>, X: Axes> = MemberMuts<'a, E, L, X>;
    fn members<'a, L: Layout<X>, X: Axes>(all: MemberRefs<'a, Self, L, X>) -> Self::Members<'a, L, X> {
        all
    }
    fn members_mut<'a, L: Layout<X>, X: Axes>(all: MemberMuts<'a, Self, L, X>) -> Self::MembersMut<'a, L, X> {
        all
    }
    #[inline(always)]
    fn from_elements((value,): (E,)) -> E {
        value
    }
    #[inline(always)]
    fn into_elements(self) -> (E,) {
        (self,)
    }
}

pub(crate) mod sealed {
    pub trait List {}
    pub trait Path {}
}

/// A tuple of elements. Implemented for tuples of 1 to 24 elements, here alone.
#[doc(hidden)]
#[diagnostic::on_unimplemented(message = "`{Self}` is no list of elements")]
pub trait ElementList: Copy + Send + Sync + sealed::List + 'static {
    /// What each member is.
    const MEMBERS: &'static [MemberSpec];
    /// Host views of all members.
    type Members<'a, R, L, X>;
    /// Host views of all members, to change them.
    type MembersMut<'a, R, L, X>;
    /// Views of a field's members.
    fn members<'a, R, L, X>(handle: Handle<'a, R, L, X>) -> Self::Members<'a, R, L, X>;
    /// Views of a field's members to change them; the caller holds the field exclusively.
    fn members_mut<'a, R, L, X>(handle: Handle<'a, R, L, X>) -> Self::MembersMut<'a, R, L, X>;
    /// Reads all members; `at` gives each one's first component and the distance of components.
    ///
    /// # Safety
    /// All components must be readable and hold values.
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize)) -> Self;
    /// Writes all members; `at` gives each one's first component and the distance of components.
    ///
    /// # Safety
    /// All components must be writable.
    unsafe fn scatter(self, at: impl Fn(usize) -> (*mut u8, usize));
}

/// The type of member `M` of a tuple.
#[doc(hidden)]
pub trait At<const M: usize>: ElementList {
    /// That type.
    type Element: Element;
}

/// Names member `M` of a record.
#[doc(hidden)]
pub struct Tag<R, const M: usize>(PhantomData<fn() -> R>);

impl<R, const M: usize> Tag<R, M> {
    /// The name.
    pub const NEW: Self = Self(PhantomData);
    /// Which member it is, in declared order.
    pub const fn index(self) -> usize {
        M
    }
}
impl<R, const M: usize> Clone for Tag<R, M> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, const M: usize> Copy for Tag<R, M> {}
impl<R, const M: usize> core::fmt::Debug for Tag<R, M> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "member {M}")
    }
}

/// Names a record as a whole: the empty path.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Whole;

impl Whole {
    /// The one member of a bare element.
    pub const fn index(self) -> usize {
        0
    }
}

/// What an access names: a member, or the whole record.
#[doc(hidden)]
pub trait Path<R: Record>: Copy + Send + Sync + sealed::Path + 'static {
    /// The value there.
    type Value: Copy + Send + Sync + 'static;
    /// The one member that holds the value, if it is one.
    const MEMBER: Option<usize>;
    /// Reads the value; `at` gives a member's first component and the distance of its components.
    ///
    /// # Safety
    /// The components that the path names must be readable and hold values.
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize)) -> Self::Value;
    /// Writes the value; `at` gives a member's first component and the distance of its components.
    ///
    /// # Safety
    /// The components that the path names must be writable.
    unsafe fn scatter(value: Self::Value, at: impl Fn(usize) -> (*mut u8, usize));
}

impl<R, const M: usize> sealed::Path for Tag<R, M> {}
impl<R: Record, const M: usize> Path<R> for Tag<R, M>
where
    R::Elements: At<M>,
{
    type Value = <R::Elements as At<M>>::Element;
    const MEMBER: Option<usize> = Some(M);
    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize)) -> Self::Value {
        let (from, component) = at(M);
        // SAFETY: the caller promises that the member's components are readable.
        unsafe { Self::Value::gather(from, component) }
    }
    #[inline(always)]
    unsafe fn scatter(value: Self::Value, at: impl Fn(usize) -> (*mut u8, usize)) {
        let (to, component) = at(M);
        // SAFETY: the caller promises that the member's components are writable.
        unsafe { value.scatter(to, component) }
    }
}

impl sealed::Path for Whole {}
impl<R: Record> Path<R> for Whole {
    type Value = R;
    const MEMBER: Option<usize> = if R::Elements::MEMBERS.len() == 1 { Some(0) } else { None };
    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize)) -> R {
        // SAFETY: the caller promises that all members are readable.
        R::from_elements(unsafe { R::Elements::gather(at) })
    }
    #[inline(always)]
    unsafe fn scatter(value: R, at: impl Fn(usize) -> (*mut u8, usize)) {
        // SAFETY: the caller promises that all members are writable.
        unsafe { value.into_elements().scatter(at) }
    }
}
