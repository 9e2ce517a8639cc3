//! What one member of a record may be: a fixed list of scalar components, so that a layout can take it apart.

use core::mem::{MaybeUninit, size_of};

mod sealed {
    pub trait Sealed {}
}
pub(crate) use sealed::Sealed;

/// A scalar component: what memory holds in the end.
///
/// `f32 f64 i8..i64 u8..u64 bool`. Zero bytes are a valid value of each of them.
///
/// # Safety
/// Implemented here alone: every bit pattern that a field can hold must be a value, and the size must equal the alignment.
pub unsafe trait Scalar: Copy + Send + Sync + PartialEq + core::fmt::Debug + Sealed + 'static {
    /// Which one it is, as data.
    #[doc(hidden)]
    const KIND: Kind;
    /// `new` where all bits of the mask are set, and `old` where none is: without a branch.
    #[doc(hidden)]
    fn blend(mask: u32, new: Self, old: Self) -> Self;
}

/// A scalar type as data.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "named after the types")]
pub enum Kind {
    F32,
    F64,
    I8,
    I16,
    I32,
    I64,
    U8,
    U16,
    U32,
    U64,
    Bool,
}

impl Kind {
    /// Whether it counts in whole numbers.
    pub(crate) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64 | Self::Bool)
    }
}

/// A type that a member of a record may have: scalars, glam's vectors, matrices and quaternions,
/// enums with `#[derive(Element)]` ([`Enumeration`](crate::Enumeration)), and arrays of elements.
///
/// An element is a fixed list of [`COMPONENTS`](Element::COMPONENTS) scalars of one type, so that a layout can place
/// them together or apart. Values move by components or by unaligned loads; no reference into a field is ever made.
///
/// ```
/// use allotrope::Element;
/// use allotrope::prelude::*;
/// assert_eq!(<Mat2 as Element>::COMPONENTS, 4);
/// assert_eq!(<[Vec3; 2] as Element>::COMPONENTS, 6);
/// ```
///
/// # Safety
/// Implemented here, and for enums by `#[derive(Element)]`. `PACKED` may be true only where `Self` is exactly `COMPONENTS` scalars in order, without padding.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no element: a field cannot hold it",
    label = "not an element type",
    note = "elements are f32, f64, i8..i64, u8..u64, bool, glam's vectors, matrices and quaternions (Vec2, DVec3, IVec2, Mat3, Quat, ..), arrays [T; N] of elements, and enums without fields that have #[derive(Element)]"
)]
pub unsafe trait Element: Copy + Send + Sync + 'static {
    /// The type of its components.
    type Scalar: Scalar;
    /// How many components it has.
    const COMPONENTS: usize;
    /// Whether it lies in memory as its components, one after another.
    #[doc(hidden)]
    const PACKED: bool;
    /// Reads the components `component` bytes apart, the first at `at`.
    ///
    /// # Safety
    /// Every component's bytes must be readable and hold a value of `Scalar`.
    #[doc(hidden)]
    unsafe fn gather(at: *const u8, component: usize) -> Self;
    /// Writes the components `component` bytes apart, the first at `at`.
    ///
    /// # Safety
    /// Every component's bytes must be writable.
    #[doc(hidden)]
    unsafe fn scatter(self, at: *mut u8, component: usize);
    /// Combines two elements component by component.
    #[doc(hidden)]
    fn combine(a: Self, b: Self, f: impl Fn(Self::Scalar, Self::Scalar) -> Self::Scalar + Copy) -> Self;
    /// The element all of whose components are the same.
    #[doc(hidden)]
    fn of_scalar(scalar: Self::Scalar) -> Self;
    /// What the bytes of all components, in the order of this machine, hold that is no value of the type: every pattern of bits is a number,
    /// but not every byte is a `bool`.
    #[doc(hidden)]
    fn wrong(_bytes: &[u8]) -> Option<i64> {
        None
    }
}

/// An element that lies in memory as its components, one after another: what a slice that a kernel writes may hold.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "a slice of `{Self}` cannot be used as a field in a kernel",
    label = "not an element without gaps",
    note = "slices hold f32, f64, i8..i64, u8..u64, bool, glam's vectors (but Vec3A), matrices and quaternions, and arrays of these; for records, write `Field<{Self}, _>`"
)]
pub trait Packed: Element {}
impl<T: Packed, const N: usize> Packed for [T; N] {}

macro_rules! scalars {
    ($($scalar:ty, $kind:ident, $bits:ty: $to:expr, $from:expr;)*) => {$(
        impl Sealed for $scalar {}
        impl Packed for $scalar {}
        // SAFETY: a primitive of equal size and alignment on the supported targets; fields hold only bytes written from values, or zeros.
        unsafe impl Scalar for $scalar {
            const KIND: Kind = Kind::$kind;
            #[inline(always)]
            fn blend(mask: u32, new: Self, old: Self) -> Self {
                let (to, from): (fn($scalar) -> $bits, fn($bits) -> $scalar) = ($to, $from);
                let mask = mask.cast_signed() as $bits;
                from((to(new) & mask) | (to(old) & !mask))
            }
        }
        // SAFETY: one component, itself.
        unsafe impl Element for $scalar {
            type Scalar = $scalar;
            const COMPONENTS: usize = 1;
            const PACKED: bool = true;
            #[inline(always)]
            unsafe fn gather(at: *const u8, _: usize) -> Self {
                // SAFETY: the caller promises that the bytes hold a value.
                unsafe { at.cast::<Self>().read_unaligned() }
            }
            #[inline(always)]
            unsafe fn scatter(self, at: *mut u8, _: usize) {
                // SAFETY: the caller promises that the bytes are writable.
                unsafe { at.cast::<Self>().write_unaligned(self) }
            }
            #[inline(always)]
            fn combine(a: Self, b: Self, f: impl Fn(Self, Self) -> Self + Copy) -> Self {
                f(a, b)
            }
            #[inline(always)]
            fn of_scalar(scalar: Self) -> Self {
                scalar
            }
            fn wrong(bytes: &[u8]) -> Option<i64> {
                let wrong = bytes.iter().find(|byte| Kind::$kind == Kind::Bool && **byte > 1);
                wrong.map(|byte| i64::from(*byte))
            }
        }
    )*};
}
scalars! {
    f32, F32, u32: f32::to_bits, f32::from_bits; f64, F64, u64: f64::to_bits, f64::from_bits;
    i8, I8, i8: |x| x, |x| x; i16, I16, i16: |x| x, |x| x; i32, I32, i32: |x| x, |x| x; i64, I64, i64: |x| x, |x| x;
    u8, U8, u8: |x| x, |x| x; u16, U16, u16: |x| x, |x| x; u32, U32, u32: |x| x, |x| x; u64, U64, u64: |x| x, |x| x;
    bool, Bool, u8: u8::from, |x| x != 0;
}

/// Elements that are their components in memory order: one unaligned move when the components lie together.
macro_rules! packed {
    ($($element:ty: $scalar:ty, $components:expr;)*) => {$(
        impl Sealed for $element {}
        impl Packed for $element {}
        const _: () = assert!(size_of::<$element>() == $components * size_of::<$scalar>());
        // SAFETY: glam lays these out as `COMPONENTS` scalars (columns for matrices), asserted by size above and by tests.
        unsafe impl Element for $element {
            type Scalar = $scalar;
            const COMPONENTS: usize = $components;
            const PACKED: bool = true;
            #[inline(always)]
            unsafe fn gather(at: *const u8, component: usize) -> Self {
                if component == size_of::<$scalar>() {
                    // SAFETY: the components lie together, as in `Self`, and the caller promises that they are readable.
                    return unsafe { at.cast::<Self>().read_unaligned() };
                }
                let mut value = core::mem::MaybeUninit::<Self>::uninit();
                let to = value.as_mut_ptr().cast::<$scalar>();
                times::<$components>(
                    // SAFETY: `c` counts the components of `Self`; the caller promises that each one's source is readable.
                    #[inline(always)]
                    |c| unsafe { to.add(c).write(at.add(c * component).cast::<$scalar>().read_unaligned()) },
                );
                // SAFETY: all components are written, and `Self` is nothing but its components.
                unsafe { value.assume_init() }
            }
            #[inline(always)]
            unsafe fn scatter(self, at: *mut u8, component: usize) {
                if component == size_of::<$scalar>() {
                    // SAFETY: the components lie together, as in `Self`, and the caller promises that they are writable.
                    return unsafe { at.cast::<Self>().write_unaligned(self) };
                }
                let from = (&raw const self).cast::<$scalar>();
                times::<$components>(
                    // SAFETY: `c` counts the components of `self`; the caller promises that each one's target is writable.
                    #[inline(always)]
                    |c| unsafe { at.add(c * component).cast::<$scalar>().write_unaligned(from.add(c).read()) },
                );
            }
            #[inline(always)]
            fn combine(mut a: Self, b: Self, f: impl Fn($scalar, $scalar) -> $scalar + Copy) -> Self {
                let (left, right) = ((&raw mut a).cast::<$scalar>(), (&raw const b).cast::<$scalar>());
                times::<$components>(
                    // SAFETY: `c` counts the components of both.
                    #[inline(always)]
                    |c| unsafe { left.add(c).write(f(left.add(c).read(), right.add(c).read())) },
                );
                a
            }
            #[inline(always)]
            fn of_scalar(scalar: $scalar) -> Self {
                let mut value = core::mem::MaybeUninit::<Self>::uninit();
                let to = value.as_mut_ptr().cast::<$scalar>();
                times::<$components>(
                    // SAFETY: `c` counts the components of `Self`.
                    #[inline(always)]
                    |c| unsafe { to.add(c).write(scalar) },
                );
                // SAFETY: all components are written, and `Self` is nothing but its components.
                unsafe { value.assume_init() }
            }
        }
    )*};
}
packed! {
    glam::Vec2: f32, 2; glam::Vec3: f32, 3; glam::Vec4: f32, 4;
    glam::Mat2: f32, 4; glam::Mat3: f32, 9; glam::Mat4: f32, 16; glam::Quat: f32, 4;
    glam::DVec2: f64, 2; glam::DVec3: f64, 3; glam::DVec4: f64, 4;
    glam::DMat2: f64, 4; glam::DMat3: f64, 9; glam::DMat4: f64, 16; glam::DQuat: f64, 4;
    glam::IVec2: i32, 2; glam::IVec3: i32, 3; glam::IVec4: i32, 4;
    glam::UVec2: u32, 2; glam::UVec3: u32, 3; glam::UVec4: u32, 4;
}

impl Sealed for glam::Vec3A {}
// SAFETY: three components; the padding of `Vec3A` is never stored, so it is not packed.
unsafe impl Element for glam::Vec3A {
    type Scalar = f32;
    const COMPONENTS: usize = 3;
    const PACKED: bool = false;
    #[inline(always)]
    unsafe fn gather(at: *const u8, component: usize) -> Self {
        // SAFETY: as the caller promises for three components.
        unsafe { glam::Vec3::gather(at, component) }.into()
    }
    #[inline(always)]
    unsafe fn scatter(self, at: *mut u8, component: usize) {
        // SAFETY: as the caller promises for three components.
        unsafe { glam::Vec3::from(self).scatter(at, component) }
    }
    #[inline(always)]
    fn combine(a: Self, b: Self, f: impl Fn(f32, f32) -> f32 + Copy) -> Self {
        glam::Vec3::combine(a.into(), b.into(), f).into()
    }
    #[inline(always)]
    fn of_scalar(scalar: f32) -> Self {
        Self::splat(scalar)
    }
}

impl<T: Element, const N: usize> Sealed for [T; N] {}
// SAFETY: `N` elements one after another, each a list of `T::COMPONENTS` scalars.
unsafe impl<T: Element, const N: usize> Element for [T; N] {
    type Scalar = T::Scalar;
    const COMPONENTS: usize = N * T::COMPONENTS;
    const PACKED: bool = T::PACKED;
    #[inline(always)]
    unsafe fn gather(at: *const u8, component: usize) -> Self {
        let mut all = [const { MaybeUninit::uninit() }; N];
        times::<N>(
            #[inline(always)]
            |n| {
                // SAFETY: element `n` begins `n * T::COMPONENTS` components in; the caller promises them all.
                all[n].write(unsafe { T::gather(at.add(n * T::COMPONENTS * component), component) });
            },
        );
        // SAFETY: every element has been written.
        unsafe { all.as_ptr().cast::<Self>().read() }
    }
    #[inline(always)]
    unsafe fn scatter(self, at: *mut u8, component: usize) {
        for (n, value) in self.into_iter().enumerate() {
            // SAFETY: element `n` begins `n * T::COMPONENTS` components in; the caller promises them all.
            unsafe { value.scatter(at.add(n * T::COMPONENTS * component), component) };
        }
    }
    #[inline(always)]
    fn combine(a: Self, b: Self, f: impl Fn(T::Scalar, T::Scalar) -> T::Scalar + Copy) -> Self {
        let mut all = a;
        times::<N>(
            #[inline(always)]
            |n| all[n] = T::combine(a[n], b[n], f),
        );
        all
    }
    #[inline(always)]
    fn of_scalar(scalar: T::Scalar) -> Self {
        [T::of_scalar(scalar); N]
    }
    fn wrong(bytes: &[u8]) -> Option<i64> {
        bytes.chunks_exact((T::COMPONENTS * size_of::<T::Scalar>()).max(1)).find_map(T::wrong)
    }
}

/// Calls `f` with 0 to N - 1, written out up to 16: component loops must not be loops.
#[inline(always)]
pub(crate) fn times<const N: usize>(mut f: impl FnMut(usize)) {
    times_by::<N>(&mut f);
}

/// The same by reference: what is owned would be dropped, should a call unwind, and each call have code for it.
#[inline(always)]
fn times_by<const N: usize>(f: &mut impl FnMut(usize)) {
    macro_rules! written_out {
        ($($c:literal)*) => { $(if const { N > $c } { f($c); })* };
    }
    written_out!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
    if const { N > 16 } {
        for c in 16..N {
            f(c);
        }
    }
}

/// Reads component `c` of a value.
#[inline(always)]
pub(crate) fn component<E: Element>(value: &E, c: usize) -> E::Scalar {
    assert!(E::PACKED && c < E::COMPONENTS);
    // SAFETY: a packed element is `COMPONENTS` scalars in order, and `c` is one of them.
    unsafe { core::ptr::from_ref(value).cast::<E::Scalar>().add(c).read() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn round_trip<E: Element + PartialEq + core::fmt::Debug>(value: E) {
        for spread in [1, 3] {
            let component = spread * size_of::<E::Scalar>();
            let mut bytes = vec![0u8; component * E::COMPONENTS + 1];
            // SAFETY: the buffer holds all components `component` bytes apart, beginning one byte in.
            let back = unsafe {
                value.scatter(bytes.as_mut_ptr().add(1), component);
                E::gather(bytes.as_ptr().add(1), component)
            };
            assert_eq!(back, value);
        }
    }

    #[test]
    fn elements_survive_apart_and_together() {
        round_trip(3.5f32);
        round_trip(true);
        round_trip(glam::vec2(1.0, -2.0));
        round_trip(glam::Vec3A::new(1.0, 2.0, 3.0));
        round_trip(glam::Mat3::from_cols_array(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]));
        round_trip(glam::DQuat::from_xyzw(1.0, 2.0, 3.0, 4.0));
        round_trip([glam::ivec3(1, 2, 3), glam::ivec3(4, 5, 6)]);
        round_trip([[1u8, 2], [3, 4]]);
    }

    #[test]
    fn components_are_columns_in_order() {
        let m = glam::Mat2::from_cols(glam::vec2(1.0, 2.0), glam::vec2(3.0, 4.0));
        assert_eq!([0, 1, 2, 3].map(|c| component(&m, c)), [1.0, 2.0, 3.0, 4.0]);
    }
}
