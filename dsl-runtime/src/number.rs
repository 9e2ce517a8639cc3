//! Operators of accumulation and reduction, component by component.

use crate::element::{Element, Scalar, Sealed};

/// A scalar that can be changed in one atomic step.
#[doc(hidden)]
pub trait Updated: Scalar {
    /// Replaces the value at `at` by `change` of it, in one atomic step.
    ///
    /// # Safety
    /// `at` is valid, aligned, and touched by nothing but atomic operations meanwhile.
    unsafe fn update(at: *mut Self, change: impl Fn(Self) -> Self + Copy);
}

/// A scalar that can be accumulated. Integers wrap around; NaN never wins a minimum or maximum.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be accumulated: it has no sum",
    note = "numbers and vectors and matrices of numbers can; `bool` takes `|=`, `&=` and `^=`"
)]
pub trait Number: Updated {
    /// What adding changes nothing, bit for bit.
    const EMPTY_SUM: Self;
    /// What multiplying changes nothing.
    const EMPTY_PRODUCT: Self;
    /// The largest value.
    const HIGHEST: Self;
    /// The smallest value.
    const LOWEST: Self;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The sum; `None` where it is an integer that the type cannot hold.
    fn checked_plus(self, other: Self) -> Option<Self>;
    /// The difference.
    fn minus(self, other: Self) -> Self;
    /// The product.
    fn times(self, other: Self) -> Self;
    /// The smaller.
    fn least(self, other: Self) -> Self;
    /// The larger.
    fn greatest(self, other: Self) -> Self;
}

/// A scalar of bits: an integer or a `bool`.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no bits to combine: `|=`, `&=` and `^=` are for integers and `bool`"
)]
pub trait Bits: Updated {
    /// No bit set.
    const NONE: Self;
    /// All bits set.
    const ALL: Self;
    /// The bits set in either.
    fn either(self, other: Self) -> Self;
    /// The bits set in both.
    fn both(self, other: Self) -> Self;
    /// The bits set in one of both.
    fn one(self, other: Self) -> Self;
}

macro_rules! update {
    ($scalar:ty, $atomic:ident, |$value:ident| $to:expr, |$bits:ident| $from:expr) => {
        impl Updated for $scalar {
            #[inline(always)]
            unsafe fn update(at: *mut Self, change: impl Fn(Self) -> Self + Copy) {
                use core::sync::atomic::{Ordering::Relaxed, $atomic};
                // SAFETY: as the caller promises; the scalar and the atomic have the same size.
                let cell = unsafe { $atomic::from_ptr(at.cast()) };
                let mut old = cell.load(Relaxed);
                loop {
                    let $bits = old;
                    let $value: $scalar = change($from);
                    match cell.compare_exchange_weak(old, $to, Relaxed, Relaxed) {
                        Ok(_) => return,
                        Err(now) => old = now,
                    }
                }
            }
        }
    };
}

macro_rules! floats {
    ($($scalar:ty, $atomic:ident;)*) => {$(
        impl Number for $scalar {
            const EMPTY_SUM: Self = -0.0;
            const EMPTY_PRODUCT: Self = 1.0;
            const HIGHEST: Self = <$scalar>::INFINITY;
            const LOWEST: Self = <$scalar>::NEG_INFINITY;
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }
            #[inline(always)]
            fn checked_plus(self, other: Self) -> Option<Self> {
                Some(self + other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self - other
            }
            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self * other
            }
            #[inline(always)]
            fn least(self, other: Self) -> Self {
                <$scalar>::min(self, other)
            }
            #[inline(always)]
            fn greatest(self, other: Self) -> Self {
                <$scalar>::max(self, other)
            }
        }
        update!($scalar, $atomic, |value| value.to_bits(), |bits| <$scalar>::from_bits(bits));
    )*};
}
floats!(f32, AtomicU32; f64, AtomicU64;);

macro_rules! integers {
    ($($scalar:ty;)*) => {$(
        impl Number for $scalar {
            const EMPTY_SUM: Self = 0;
            const EMPTY_PRODUCT: Self = 1;
            const HIGHEST: Self = <$scalar>::MAX;
            const LOWEST: Self = <$scalar>::MIN;
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline(always)]
            fn checked_plus(self, other: Self) -> Option<Self> {
                self.checked_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self.wrapping_mul(other)
            }
            #[inline(always)]
            fn least(self, other: Self) -> Self {
                Ord::min(self, other)
            }
            #[inline(always)]
            fn greatest(self, other: Self) -> Self {
                Ord::max(self, other)
            }
        }
    )*};
}
integers!(i8; i16; i32; i64; u8; u16; u32; u64;);

macro_rules! bits {
    ($($scalar:ty, $none:literal, $atomic:ident;)*) => {$(
        impl Bits for $scalar {
            const NONE: Self = $none;
            const ALL: Self = !$none;
            #[inline(always)]
            fn either(self, other: Self) -> Self {
                self | other
            }
            #[inline(always)]
            fn both(self, other: Self) -> Self {
                self & other
            }
            #[inline(always)]
            fn one(self, other: Self) -> Self {
                self ^ other
            }
        }
        update!($scalar, $atomic, |value| value, |bits| bits);
    )*};
}
bits! {
    i8, 0, AtomicI8; i16, 0, AtomicI16; i32, 0, AtomicI32; i64, 0, AtomicI64;
    u8, 0, AtomicU8; u16, 0, AtomicU16; u32, 0, AtomicU32; u64, 0, AtomicU64; bool, false, AtomicBool;
}

/// An associative and commutative operator on scalars, with its identity.
#[doc(hidden)]
pub trait Operator<S>: Copy + Send + Sync + Sealed + 'static {
    /// What changes nothing.
    const IDENTITY: S;
    /// The result.
    fn apply(a: S, b: S) -> S;
}

macro_rules! operators {
    ($($name:ident: $bound:ident, $identity:ident, $apply:ident, $doc:literal;)*) => {$(
        #[doc = $doc]
        #[doc(hidden)]
        #[derive(Clone, Copy, Debug)]
        pub struct $name;
        impl Sealed for $name {}
        impl<S: $bound> Operator<S> for $name {
            const IDENTITY: S = S::$identity;
            #[inline(always)]
            fn apply(a: S, b: S) -> S {
                a.$apply(b)
            }
        }
    )*};
}
operators! {
    Sum: Number, EMPTY_SUM, plus, "`+=` and `-=`.";
    Product: Number, EMPTY_PRODUCT, times, "`*=`.";
    Min: Number, HIGHEST, least, "`min_assign`.";
    Max: Number, LOWEST, greatest, "`max_assign`.";
    BitAnd: Bits, ALL, both, "`&=`.";
    BitOr: Bits, NONE, either, "`|=`.";
    BitXor: Bits, NONE, one, "`^=`.";
}

/// An operator that leaves alone what the identity is applied to: `min` would take the highest number for NaN.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kept<O>(O);
impl<O: Sealed> Sealed for Kept<O> {}
impl<S: Scalar + PartialEq, O: Operator<S>> Operator<S> for Kept<O> {
    const IDENTITY: S = O::IDENTITY;
    #[inline(always)]
    fn apply(a: S, b: S) -> S {
        if b == O::IDENTITY { a } else { O::apply(a, b) }
    }
}

/// The element whose components are the operator's identity.
#[inline(always)]
pub(crate) fn identity<O: Operator<E::Scalar>, E: Element>() -> E {
    E::of_scalar(O::IDENTITY)
}

/// Applies an operator component by component.
#[inline(always)]
pub(crate) fn zip<O: Operator<E::Scalar>, E: Element>(a: E, b: E) -> E {
    E::combine(
        a,
        b,
        #[inline(always)]
        |a, b| O::apply(a, b),
    )
}

/// `a *= b` by components: scalars by scalars, vectors by vectors or scalars. Matrix products are none.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`*=` of `{Self}` by `{Rhs}` is not component by component",
    note = "a matrix or quaternion product depends on the order of its factors, so that it cannot be accumulated"
)]
pub trait ComponentMul<Rhs>: Element {
    /// The factor as an element.
    fn factor(by: Rhs) -> Self;
}
macro_rules! component_mul {
    ($($scalar:ty: $($vector:ty)*;)*) => {$(
        impl ComponentMul<$scalar> for $scalar {
            #[inline(always)]
            fn factor(by: $scalar) -> Self {
                by
            }
        }
        $(
            impl ComponentMul<$vector> for $vector {
                #[inline(always)]
                fn factor(by: $vector) -> Self {
                    by
                }
            }
            impl ComponentMul<$scalar> for $vector {
                #[inline(always)]
                fn factor(by: $scalar) -> Self {
                    <$vector as Element>::of_scalar(by)
                }
            }
        )*
    )*};
}
component_mul! {
    f32: glam::Vec2 glam::Vec3 glam::Vec3A glam::Vec4; f64: glam::DVec2 glam::DVec3 glam::DVec4;
    i32: glam::IVec2 glam::IVec3 glam::IVec4; u32: glam::UVec2 glam::UVec3 glam::UVec4;
    i8: ; i16: ; i64: ; u8: ; u16: ; u64: ;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operators_work_by_components() {
        assert_eq!(zip::<Sum, _>(glam::vec2(1.0, 2.0), glam::vec2(3.0, 4.0)), glam::vec2(4.0, 6.0));
        assert_eq!(zip::<Max, _>([1u8, 9], [5, 2]), [5, 9]);
        assert_eq!(zip::<Min, _>(f32::NAN, 1.0), 1.0);
        assert_eq!(zip::<Sum, _>(u8::MAX, 1), 0);
        assert_eq!(zip::<Sum, _>(identity::<Sum, f32>(), 0.0).to_bits(), 0);
        assert_eq!(zip::<Sum, _>(glam::Vec3A::ONE, glam::Vec3A::ONE), glam::Vec3A::splat(2.0));
    }

    #[test]
    fn updates_are_atomic() {
        let mut cell = 0f32;
        let at = Address(&raw mut cell);
        std::thread::scope(|s| {
            let work = || {
                for _ in 0..1000 {
                    // SAFETY: aligned, and only updated atomically until the threads are joined.
                    unsafe { f32::update(at.get(), |x| x + 1.0) }
                }
            };
            for thread in [s.spawn(work), s.spawn(work)] {
                thread.join().expect("no panic");
            }
        });
        assert_eq!(cell, 2000.0);
    }

    #[derive(Clone, Copy)]
    struct Address(*mut f32);
    impl Address {
        fn get(&self) -> *mut f32 {
            self.0
        }
    }
    // SAFETY: the test touches the address atomically alone.
    unsafe impl Sync for Address {}
}
