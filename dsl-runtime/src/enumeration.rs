//! Enums without fields as elements: stored as their integers.

use core::mem::size_of;

use crate::element::{Kind, Scalar, Sealed};
use crate::index::Integer;

/// An enum without fields that members of records, and bare fields, may have as their type.
///
/// [`#[derive(Element)]`](macro@crate::Element) implements it. The integer is that of `#[repr(..)]`, or else the smallest
/// of `u8`, `i8`, `u16`, `i16`, `u32` and `i32` that holds all values. One variant has the value 0: a new field holds it.
///
/// Memory holds integers and is read through [`from_code`](Enumeration::from_code), a match that gives every integer a variant, so that
/// no bytes make an invalid enum and the trait is safe to implement. An enum has no sum: it is written, not accumulated.
///
/// ```
/// use allotrope::Enumeration;
/// use allotrope::prelude::*;
///
/// #[derive(Element, Clone, Copy, Debug, PartialEq)]
/// enum Phase {
///     Water,
///     Ice,
/// }
///
/// #[derive(Record, Clone, Copy)]
/// struct Parcel {
///     heat: f32,
///     phase: Phase,
/// }
///
/// #[kernel]
/// fn freeze(parcels: &mut Field<Parcel, _>) {
///     for p in parcels {
///         match parcels.phase[p] {
///             Phase::Water if parcels.heat[p] < 0.0 => parcels.phase[p] = Phase::Ice,
///             Phase::Water | Phase::Ice => {}
///         }
///     }
/// }
///
/// let mut parcels = Field::<Parcel, Soa>::new([2]);
/// parcels.set(1, Parcel { heat: -1.0, phase: Phase::Water });
/// freeze(&mut parcels);
/// assert_eq!(parcels.members().phase.to_vec(), [Phase::Water, Phase::Ice]);
/// assert_eq!(Phase::from_code(77), Phase::Water);
/// ```
///
/// An element is copied in and out of fields:
///
/// ```compile_fail,E0277
/// use allotrope::prelude::*;
///
/// #[derive(Element)]
/// enum Phase {
///     Water,
///     Ice,
/// }
/// ```
///
/// What the derive calls makes no element of anything else:
///
/// ```compile_fail,E0277
/// #[derive(Clone, Copy)]
/// struct Whatever;
/// allotrope::__enumeration! { Whatever }
/// ```
pub trait Enumeration: Copy + Send + Sync + 'static {
    /// The integer that it is stored as.
    type Code: Representation;
    /// The variant of an integer; of an integer that no variant has, the variant of 0.
    fn from_code(code: Self::Code) -> Self;
    /// The integer of a variant.
    fn code(self) -> Self::Code;
}

/// An integer that an enum may be stored as: `u8 i8 u16 i16 u32 i32`.
pub trait Representation: Scalar + Integer + PartialEq {}

macro_rules! representations {
    ($($integer:ty)*) => { $(impl Representation for $integer {})* };
}
representations!(u8 i8 u16 i16 u32 i32);

/// The scalar of an enum: an integer without arithmetic, so that enums cannot be accumulated.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Code<I>(I);

impl<I: Representation> Sealed for Code<I> {}
// SAFETY: the same size, alignment and bit patterns as the integer, which is a scalar.
unsafe impl<I: Representation> Scalar for Code<I> {
    const KIND: Kind = I::KIND;
    #[inline(always)]
    fn blend(mask: u32, new: Self, old: Self) -> Self {
        Self(I::blend(mask, new.0, old.0))
    }
}

/// Makes an [`Enumeration`] an [`Element`]: the name of a type, and nothing else that could slip into what is unsafe. What `#[derive(Element)]` calls, so that `unsafe` stands here. No blanket
/// implementation does it, since rustc would then explain every type that is no element by its not being an enumeration.
#[doc(hidden)]
#[macro_export]
macro_rules! __enumeration {
    ($name:ident) => {
        // SAFETY: one component, an integer; it is not packed, since its own bytes need not be those of its code.
        #[automatically_derived]
        unsafe impl $crate::Element for $name {
            type Scalar = $crate::__private::Code<<Self as $crate::Enumeration>::Code>;
            const COMPONENTS: usize = 1;
            const PACKED: bool = false;
            #[inline(always)]
            unsafe fn gather(at: *const u8, _: usize) -> Self {
                // SAFETY: as the caller promises.
                unsafe { $crate::__private::Code::gather(at) }.variant()
            }
            #[inline(always)]
            unsafe fn scatter(self, at: *mut u8, _: usize) {
                // SAFETY: as the caller promises.
                unsafe { $crate::__private::Code::of(self).scatter(at) }
            }
            #[inline(always)]
            fn combine(a: Self, b: Self, f: impl Fn(Self::Scalar, Self::Scalar) -> Self::Scalar + Copy) -> Self {
                f($crate::__private::Code::of(a), $crate::__private::Code::of(b)).variant()
            }
            #[inline(always)]
            fn of_scalar(scalar: Self::Scalar) -> Self {
                scalar.variant()
            }
            fn wrong(bytes: &[u8]) -> ::core::option::Option<i64> {
                $crate::__private::Code::wrong::<Self>(bytes)
            }
        }
    };
}

impl<I: Representation> Code<I> {
    /// The integer of a variant.
    #[inline(always)]
    pub fn of<E: Enumeration<Code = I>>(variant: E) -> Self {
        Self(variant.code())
    }

    /// The variant of an integer.
    #[inline(always)]
    pub fn variant<E: Enumeration<Code = I>>(self) -> E {
        E::from_code(self.0)
    }

    /// Reads an integer.
    ///
    /// # Safety
    /// As many bytes as it has must be readable and initialised.
    #[inline(always)]
    pub unsafe fn gather(at: *const u8) -> Self {
        // SAFETY: the caller promises initialised bytes, and every pattern of bits is an integer.
        Self(unsafe { at.cast::<I>().read_unaligned() })
    }

    /// Writes the integer.
    ///
    /// # Safety
    /// As many bytes as it has must be writable.
    #[inline(always)]
    pub unsafe fn scatter(self, at: *mut u8) {
        // SAFETY: the caller promises that the bytes are writable.
        unsafe { at.cast::<I>().write_unaligned(self.0) }
    }

    /// The integer in these bytes, where no variant has it.
    pub fn wrong<E: Enumeration<Code = I>>(bytes: &[u8]) -> Option<i64> {
        assert_eq!(bytes.len(), size_of::<I>(), "the bytes of one code");
        // SAFETY: as many initialised bytes as the integer has.
        let Self(code) = unsafe { Self::gather(bytes.as_ptr()) };
        (E::from_code(code).code() != code).then(|| code.wide())
    }
}
