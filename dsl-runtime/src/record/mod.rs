//! Records: what one element of a field holds.

mod lists;
mod names;
mod paths;

use core::mem::size_of;

use crate::element::{Element, Kind, Scalar};
use crate::field::{Handle, Member, MemberMut};
pub(crate) use names::Names;
pub use paths::{Path, Tag, Under, Whole};

/// The most members that a record can have, those of the records in it counted one by one.
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

/// What one element of a field holds: a plain struct of elements and of other records, made by `#[derive(Record)]`, or a bare
/// element.
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
///
/// A record in a record is taken apart as if its members stood in the outer one. Paths name them: an index of the path of an inner record is that record,
/// an index of a longer path one of its members.
///
/// ```
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
/// struct Node {
///     v: Vec2,
///     m: f32,
/// }
///
/// #[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
/// struct Cell {
///     node: Node,
///     wall: bool,
/// }
///
/// #[kernel]
/// fn settle(cells: &mut Field<Cell, _, Ij>) {
///     for ij in cells {
///         if cells.wall[ij] {
///             cells.node[ij] = Node::default();
///         } else {
///             cells.node.v[ij] *= 0.5;
///         }
///     }
/// }
///
/// let mut cells = Field::<Cell, Soa>::new([4, 4]);
/// cells.members_mut().node.v.fill(vec2(2.0, 4.0));
/// cells.members_mut().wall.set([1, 2], true);
/// settle(&mut cells);
/// assert_eq!(cells.get([1, 2]).node, Node::default());
/// assert_eq!(cells.members().node.v.get([3, 3]), vec2(1.0, 2.0));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is neither an element nor a record: a field cannot hold it",
    label = "neither an element nor a record",
    note = "elements are f32, f64, i8..i64, u8..u64, bool, glam's vectors, matrices and quaternions (Vec2, DVec3, IVec2, Mat3, Quat, ..), arrays [T; N] of elements, and enums without fields that have #[derive(Element)]",
    note = "a struct of such values with named members is a record: write `#[derive(Record, Clone, Copy)]` on it"
)]
pub trait Record: Copy + Send + Sync + 'static {
    /// Its members, in declared order.
    #[doc(hidden)]
    type Elements: ElementList;
    /// Their names, in the same order.
    const NAMES: &'static [&'static str];
    /// A struct with one public field a member: how expansions name members.
    #[doc(hidden)]
    type Tags: Copy;
    #[doc(hidden)]
    const TAGS: Self::Tags;
    /// A struct with one public field a member: `field.members().x`. The field is of records `R`, where this one stands at the path `P`.
    #[doc(hidden)]
    type Members<'a, R, P, L, X>;
    /// The same, to change them: `field.members_mut().x`.
    #[doc(hidden)]
    type MembersMut<'a, R, P, L, X>;
    #[doc(hidden)]
    fn members<'a, R, P, L, X>(all: MemberRefs<'a, Self, R, P, L, X>) -> Self::Members<'a, R, P, L, X>;
    #[doc(hidden)]
    fn members_mut<'a, R, P, L, X>(all: MemberMuts<'a, Self, R, P, L, X>) -> Self::MembersMut<'a, R, P, L, X>;
    #[doc(hidden)]
    fn from_elements(elements: Self::Elements) -> Self;
    #[doc(hidden)]
    fn into_elements(self) -> Self::Elements;
}

/// The members of the record `T` at the path `P` of a field, as a tuple.
#[doc(hidden)]
pub type MemberRefs<'a, T, R, P, L, X> = <<T as Record>::Elements as ElementList>::Members<'a, R, P, L, X>;
/// The same to change: each stands once, so that no two of them alias.
#[doc(hidden)]
pub type MemberMuts<'a, T, R, P, L, X> = <<T as Record>::Elements as ElementList>::MembersMut<'a, R, P, L, X>;
/// What stands for a member of type `T` at the path `P` of a field: a view of an element, or the members of a record.
#[doc(hidden)]
pub type PartRef<'a, T, R, P, L, X> = <<T as Record>::Elements as ElementList>::Part<'a, T, R, P, L, X>;
/// The same to change.
#[doc(hidden)]
pub type PartMut<'a, T, R, P, L, X> = <<T as Record>::Elements as ElementList>::PartMut<'a, T, R, P, L, X>;

/// A bare element is a record of one unnamed member.
#[diagnostic::do_not_recommend]
impl<E: Element> Record for E {
    type Elements = Bare<E>;
    const NAMES: &'static [&'static str] = &["0"];
    type Tags = NoMembers<E>;
    const TAGS: NoMembers<E> = NoMembers(core::marker::PhantomData);
    type Members<'a, R, P, L, X> = MemberRefs<'a, E, R, P, L, X>;
    type MembersMut<'a, R, P, L, X> = MemberMuts<'a, E, R, P, L, X>;
    fn members<'a, R, P, L, X>(all: MemberRefs<'a, E, R, P, L, X>) -> Self::Members<'a, R, P, L, X> {
        all
    }
    fn members_mut<'a, R, P, L, X>(all: MemberMuts<'a, E, R, P, L, X>) -> Self::MembersMut<'a, R, P, L, X> {
        all
    }
    #[inline(always)]
    fn from_elements(Bare(value): Bare<E>) -> E {
        value
    }
    #[inline(always)]
    fn into_elements(self) -> Bare<E> {
        Bare(self)
    }
}

/// The members of an element, of which there are none: what an error about one names.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct NoMembers<E>(core::marker::PhantomData<fn() -> E>);

pub(crate) mod sealed {
    pub trait List {}
    pub trait Path {}
}

/// A member as a list of members knows it: an element, or a record with members of its own.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What its members are, or what it is itself.
    pub(crate) members: &'static [MemberSpec],
    /// Its members' names; none for an element.
    pub(crate) names: &'static [&'static str],
}

impl Entry {
    /// The facts of a member's type.
    pub(crate) const fn of<T: Record>() -> Self {
        let names = if T::Elements::BARE { &[] } else { Names::<T>::ALL };
        Self { members: T::Elements::MEMBERS, names }
    }
}

/// A record's members: a bare element, or a tuple of records. Implemented for tuples of 1 to 24, here alone.
#[doc(hidden)]
#[diagnostic::on_unimplemented(message = "`{Self}` is no list of members")]
pub trait ElementList: Copy + Send + Sync + sealed::List + 'static {
    /// Whether it is a bare element.
    const BARE: bool;
    /// Whether it lies in memory as its components, one after another.
    const PACKED: bool;
    /// The members as they are declared.
    const ENTRIES: &'static [Entry];
    /// What each element is, those of inner records in their place.
    const MEMBERS: &'static [MemberSpec];
    /// Host views of all members.
    type Members<'a, R, P, L, X>;
    /// Host views of all members, to change them.
    type MembersMut<'a, R, P, L, X>;
    /// What stands for such a record, `T`, among the members of another.
    type Part<'a, T: Record, R, P, L, X>;
    /// The same to change.
    type PartMut<'a, T: Record, R, P, L, X>;
    /// Views of the members at the path `P` of a field.
    fn members<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::Members<'a, R, P, L, X>;
    /// The same to change; the caller holds that path of the field exclusively.
    fn members_mut<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::MembersMut<'a, R, P, L, X>;
    /// What stands for the record at the path `P` of a field.
    fn part<'a, T: Record<Elements = Self>, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::Part<'a, T, R, P, L, X>;
    /// The same to change; the caller holds that path of the field exclusively.
    fn part_mut<'a, T: Record<Elements = Self>, R, P, L, X>(
        handle: Handle<'a, R, L, X>,
    ) -> Self::PartMut<'a, T, R, P, L, X>;
    /// Reads all members; `at` gives each element's first component and the distance of components.
    ///
    /// # Safety
    /// All components must be readable and hold values.
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize) + Copy) -> Self;
    /// Writes all members; `at` gives each element's first component and the distance of components.
    ///
    /// # Safety
    /// All components must be writable.
    unsafe fn scatter(self, at: impl Fn(usize) -> (*mut u8, usize) + Copy);
    /// What the bytes of an element's components hold that is no value of its type.
    fn wrong(member: usize, bytes: &[u8]) -> Option<i64>;
}

/// A member of a tuple.
#[doc(hidden)]
pub trait At<const M: usize>: ElementList {
    /// Its type.
    type Entry: Record;
    /// How many elements come before it.
    const OFFSET: usize;
}

/// The list of a bare element.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Bare<E>(E);

impl<E: Element> sealed::List for Bare<E> {}
impl<E: Element> ElementList for Bare<E> {
    const BARE: bool = true;
    const PACKED: bool = E::PACKED;
    const ENTRIES: &'static [Entry] = &[Entry { members: Self::MEMBERS, names: &[] }];
    const MEMBERS: &'static [MemberSpec] = &[MemberSpec::of::<E>()];
    type Members<'a, R, P, L, X> = (Member<'a, R, L, X, P>,);
    type MembersMut<'a, R, P, L, X> = (MemberMut<'a, R, L, X, P>,);
    type Part<'a, T: Record, R, P, L, X> = Member<'a, R, L, X, P>;
    type PartMut<'a, T: Record, R, P, L, X> = MemberMut<'a, R, L, X, P>;
    fn members<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::Members<'a, R, P, L, X> {
        (Member::new(handle),)
    }
    fn members_mut<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::MembersMut<'a, R, P, L, X> {
        (MemberMut::new(handle),)
    }
    fn part<'a, T: Record<Elements = Self>, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::Part<'a, T, R, P, L, X> {
        Member::new(handle)
    }
    fn part_mut<'a, T: Record<Elements = Self>, R, P, L, X>(
        handle: Handle<'a, R, L, X>,
    ) -> Self::PartMut<'a, T, R, P, L, X> {
        MemberMut::new(handle)
    }
    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize) + Copy) -> Self {
        let (from, component) = at(0);
        // SAFETY: the caller promises that the components are readable; `at` names the first and their distance.
        Self(unsafe { E::gather(from, component) })
    }
    #[inline(always)]
    unsafe fn scatter(self, at: impl Fn(usize) -> (*mut u8, usize) + Copy) {
        let (to, component) = at(0);
        // SAFETY: the caller promises that the components are writable; `at` names the first and their distance.
        unsafe { self.0.scatter(to, component) }
    }
    fn wrong(_: usize, bytes: &[u8]) -> Option<i64> {
        E::wrong(bytes)
    }
}
