//! Paths: what an access names of a record.

use core::marker::PhantomData;

use super::{At, ElementList, Record, sealed};

/// Names member `M` of a record whose members are the list `T`.
#[doc(hidden)]
pub struct Tag<T, const M: usize>(PhantomData<fn() -> T>);

impl<T, const M: usize> Tag<T, M> {
    /// The name.
    pub const NEW: Self = Self(PhantomData);
}
impl<T: At<M>, const M: usize> Tag<T, M> {
    /// A path that goes on among the members of the record that stands there.
    #[inline(always)]
    pub fn then<Q>(self, inner: impl FnOnce(<T::Entry as Record>::Tags) -> Q) -> Under<Self, Q> {
        Under(self, inner(<T::Entry as Record>::TAGS))
    }
}
impl<T, const M: usize> Clone for Tag<T, M> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T, const M: usize> Copy for Tag<T, M> {}
impl<T, const M: usize> core::fmt::Debug for Tag<T, M> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "member {M}")
    }
}

/// Names what the path `Q` does of the record that the path `P` names.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Under<P, Q>(P, Q);

/// Names a record as a whole: the empty path.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Whole;

/// What an access names: a member, a member of one, or the whole record.
#[doc(hidden)]
pub trait Path<R: Record>: Copy + Send + Sync + sealed::Path + 'static {
    /// The value there: an element, or a record.
    type Value: Record;
    /// The path itself.
    const PATH: Self;
    /// How many elements of the record come before it.
    const OFFSET: usize;
    /// The one element that holds the value, if it is one.
    const MEMBER: Option<usize> =
        if <Self::Value as Record>::Elements::MEMBERS.len() == 1 { Some(Self::OFFSET) } else { None };
    /// Reads the value; `at` gives an element's first component and the distance of its components.
    ///
    /// # Safety
    /// The components that the path names must be readable and hold values.
    #[inline(always)]
    unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize) + Copy) -> Self::Value {
        // SAFETY: the caller promises that the components of the value's elements are readable.
        Self::Value::from_elements(unsafe {
            <Self::Value as Record>::Elements::gather(
                #[inline(always)]
                |m| at(Self::OFFSET + m),
            )
        })
    }
    /// Writes the value; `at` gives an element's first component and the distance of its components.
    ///
    /// # Safety
    /// The components that the path names must be writable.
    #[inline(always)]
    unsafe fn scatter(value: Self::Value, at: impl Fn(usize) -> (*mut u8, usize) + Copy) {
        // SAFETY: the caller promises that the components of the value's elements are writable.
        unsafe {
            value.into_elements().scatter(
                #[inline(always)]
                |m| at(Self::OFFSET + m),
            )
        }
    }
}

impl<T, const M: usize> sealed::Path for Tag<T, M> {}
impl<R: Record<Elements = T>, T: At<M>, const M: usize> Path<R> for Tag<T, M> {
    type Value = T::Entry;
    const PATH: Self = Self::NEW;
    const OFFSET: usize = T::OFFSET;
}

impl<P, Q> sealed::Path for Under<P, Q> {}
impl<R: Record, P: Path<R>, Q: Path<P::Value>> Path<R> for Under<P, Q> {
    type Value = Q::Value;
    const PATH: Self = Self(P::PATH, Q::PATH);
    const OFFSET: usize = P::OFFSET + Q::OFFSET;
}

impl sealed::Path for Whole {}
impl<R: Record> Path<R> for Whole {
    type Value = R;
    const PATH: Self = Self;
    const OFFSET: usize = 0;
}
