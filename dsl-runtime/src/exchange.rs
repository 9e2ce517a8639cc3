//! Operations on integers that return the old value in one step: `fetch_add` and its like.

use core::sync::atomic::Ordering::Relaxed;

use crate::element::Element;
use crate::number::{Bits, Number};

/// A scalar whose value can be exchanged in one step, so that what was there before is known.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "the old value of a `{Self}` cannot be taken in one step",
    note = "`swap`, `compare_exchange`, `fetch_or`, `fetch_and` and `fetch_xor` are for integers and `bool`: make it a member of its own of such a type"
)]
pub trait Exchange: Bits + Element<Scalar = Self> {
    /// Puts a value, and returns the old one.
    ///
    /// # Safety
    /// `at` is valid, aligned, and touched by nothing but atomic operations meanwhile. So for all that follow.
    unsafe fn swap(at: *mut Self, new: Self) -> Self;
    /// Puts a value where `current` is; returns what was there, as an error where it was something else.
    ///
    /// # Safety
    /// As for [`swap`](Self::swap).
    unsafe fn compare_exchange(at: *mut Self, current: Self, new: Self) -> Result<Self, Self>;
    /// `|=`, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Self::swap).
    unsafe fn fetch_or(at: *mut Self, by: Self) -> Self;
    /// `&=`, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Self::swap).
    unsafe fn fetch_and(at: *mut Self, by: Self) -> Self;
    /// `^=`, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Self::swap).
    unsafe fn fetch_xor(at: *mut Self, by: Self) -> Self;
}

/// An integer, which can be counted up and compared in one step.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "a `{Self}` cannot be counted with its old value in one step",
    note = "`fetch_add`, `fetch_sub`, `fetch_min` and `fetch_max` are for integers: make it a member of its own of such a type"
)]
pub trait Count: Exchange + Number {
    /// `+=`, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Exchange::swap).
    unsafe fn fetch_add(at: *mut Self, by: Self) -> Self;
    /// `-=`, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Exchange::swap).
    unsafe fn fetch_sub(at: *mut Self, by: Self) -> Self;
    /// The smaller of both, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Exchange::swap).
    unsafe fn fetch_min(at: *mut Self, by: Self) -> Self;
    /// The larger of both, and the old value.
    ///
    /// # Safety
    /// As for [`swap`](Exchange::swap).
    unsafe fn fetch_max(at: *mut Self, by: Self) -> Self;
}

macro_rules! atomically {
    ($atomic:ident: $($name:ident)*) => {$(
        #[inline(always)]
        unsafe fn $name(at: *mut Self, by: Self) -> Self {
            // SAFETY: as the caller promises; the scalar and the atomic have the same size.
            unsafe { core::sync::atomic::$atomic::from_ptr(at) }.$name(by, Relaxed)
        }
    )*};
}

macro_rules! exchange {
    ($($scalar:ty, $atomic:ident;)*) => {$(
        impl Exchange for $scalar {
            #[inline(always)]
            unsafe fn compare_exchange(at: *mut Self, current: Self, new: Self) -> Result<Self, Self> {
                // SAFETY: as the caller promises; the scalar and the atomic have the same size.
                unsafe { core::sync::atomic::$atomic::from_ptr(at) }.compare_exchange(current, new, Relaxed, Relaxed)
            }
            atomically!($atomic: swap fetch_or fetch_and fetch_xor);
        }
    )*};
}
exchange! {
    i8, AtomicI8; i16, AtomicI16; i32, AtomicI32; i64, AtomicI64;
    u8, AtomicU8; u16, AtomicU16; u32, AtomicU32; u64, AtomicU64; bool, AtomicBool;
}

macro_rules! count {
    ($($scalar:ty, $atomic:ident;)*) => {$(
        impl Count for $scalar {
            atomically!($atomic: fetch_add fetch_sub fetch_min fetch_max);
        }
    )*};
}
count! {
    i8, AtomicI8; i16, AtomicI16; i32, AtomicI32; i64, AtomicI64;
    u8, AtomicU8; u16, AtomicU16; u32, AtomicU32; u64, AtomicU64;
}

/// What replaces a value, as an operation that a thread makes alone: outside of parallel loops.
macro_rules! alone {
    ($($name:ident: $bound:ident, |$old:ident, $by:ident| $new:expr, $doc:literal;)*) => {$(
        #[doc = $doc]
        #[inline(always)]
        pub fn $name<T: $bound>(value: &mut T, $by: T) -> T {
            let $old = *value;
            *value = $new;
            $old
        }
    )*};
}
alone! {
    swap: Exchange, |old, by| by, "Puts a value, and returns the old one.";
    fetch_or: Exchange, |old, by| old.either(by), "`|=`, and the old value.";
    fetch_and: Exchange, |old, by| old.both(by), "`&=`, and the old value.";
    fetch_xor: Exchange, |old, by| old.one(by), "`^=`, and the old value.";
    fetch_add: Count, |old, by| old.plus(by), "`+=`, and the old value.";
    fetch_sub: Count, |old, by| old.minus(by), "`-=`, and the old value.";
    fetch_min: Count, |old, by| old.least(by), "The smaller of both, and the old value.";
    fetch_max: Count, |old, by| old.greatest(by), "The larger of both, and the old value.";
}

/// Puts a value where `current` is; returns what was there, as an error where it was something else.
#[inline(always)]
pub fn compare_exchange<T: Exchange>(value: &mut T, current: T, new: T) -> Result<T, T> {
    let old = *value;
    if old != current {
        return Err(old);
    }
    *value = new;
    Ok(old)
}
