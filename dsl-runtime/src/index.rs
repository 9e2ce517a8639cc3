//! What an element can be indexed by: any integers, converted with a check.

use crate::axes::{Axes, I, Ij, Ijk, Ijkl, MAX_AXES, O, per_axis};
use crate::element::Sealed;

/// An integer that can index or bound a loop.
pub trait Integer: Copy + Send + Sync + core::fmt::Debug + Sealed + 'static {
    /// Its value; what an `i64` cannot hold becomes `i64::MAX`, which no field reaches.
    #[doc(hidden)]
    fn wide(self) -> i64;
    /// The integer of that value, which the caller has taken from values of this type.
    #[doc(hidden)]
    fn narrow(value: i64) -> Self;
}

/// An integer, or a reference to one.
#[doc(hidden)]
pub trait Whole: Copy + Sealed {
    /// Its value.
    fn value(self) -> i64;
}

/// The value of an integer, or of a reference to one.
#[doc(hidden)]
#[inline(always)]
pub fn wide(value: impl Whole) -> i64 {
    value.value()
}

macro_rules! integers {
    ($($integer:ty)*) => {$(
        impl Whole for $integer {
            #[inline(always)]
            fn value(self) -> i64 {
                self.wide()
            }
        }
        impl Whole for &$integer {
            #[inline(always)]
            fn value(self) -> i64 {
                self.wide()
            }
        }
        impl Integer for $integer {
            #[inline(always)]
            fn wide(self) -> i64 {
                #[allow(irrefutable_let_patterns, clippy::unnecessary_fallible_conversions, reason = "one text for all integers")]
                if let Ok(wide) = i64::try_from(self) { wide } else { i64::MAX }
            }
            #[inline(always)]
            fn narrow(value: i64) -> Self {
                value as $integer
            }
        }
    )*};
}
impl Sealed for usize {}
impl Sealed for isize {}
integers!(i8 i16 i32 i64 isize u8 u16 u32 u64 usize);

/// An index into a field over the axes `X`: an integer, a vector of integers, or a tuple or array of integers.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no index of a field over `{X}`",
    label = "not an index of this field",
    note = "`I` is indexed by an integer, `Ij` by an IVec2 or two integers, `Ijk` by an IVec3 or three integers, `Ijkl` by an IVec4 or four, `O` by `()`; write `x as i32` for a float"
)]
pub trait IntoIndex<X: Axes>: Copy + Sealed {
    /// Whether it must be checked against the shape. Only an index that was promised to lie within needs no check.
    #[doc(hidden)]
    const CHECKED: bool = true;
    /// The coordinates; what no field reaches stays out of reach.
    #[doc(hidden)]
    fn coordinates(self) -> [i64; MAX_AXES];
}

impl<T: Integer> IntoIndex<I> for T {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [self.wide(), 0, 0, 0]
    }
}
impl Sealed for () {}
impl IntoIndex<O> for () {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [0; MAX_AXES]
    }
}
impl<T> Sealed for (T,) {}
impl<T: Integer> IntoIndex<I> for (T,) {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [self.0.wide(), 0, 0, 0]
    }
}
impl<T, U> Sealed for (T, U) {}
impl<T: Integer, U: Integer> IntoIndex<Ij> for (T, U) {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [self.0.wide(), self.1.wide(), 0, 0]
    }
}
impl<T, U, V> Sealed for (T, U, V) {}
impl<T: Integer, U: Integer, V: Integer> IntoIndex<Ijk> for (T, U, V) {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [self.0.wide(), self.1.wide(), self.2.wide(), 0]
    }
}

impl<T, U, V, W> Sealed for (T, U, V, W) {}
impl<T: Integer, U: Integer, V: Integer, W: Integer> IntoIndex<Ijkl> for (T, U, V, W) {
    #[inline(always)]
    fn coordinates(self) -> [i64; MAX_AXES] {
        [self.0.wide(), self.1.wide(), self.2.wide(), self.3.wide()]
    }
}

macro_rules! vectors {
    (@place x) => { 0 };
    (@place y) => { 1 };
    (@place z) => { 2 };
    (@place w) => { 3 };
    ($($vector:ty => $axes:ty, $($component:ident)*;)*) => {$(
        impl IntoIndex<$axes> for $vector {
            #[inline(always)]
            fn coordinates(self) -> [i64; MAX_AXES] {
                let mut at = [0; MAX_AXES];
                $(at[vectors!(@place $component)] = i64::from(self.$component);)*
                at
            }
        }
    )*};
}
vectors! {
    glam::IVec2 => Ij, x y; glam::UVec2 => Ij, x y;
    glam::IVec3 => Ijk, x y z; glam::UVec3 => Ijk, x y z;
    glam::IVec4 => Ijkl, x y z w; glam::UVec4 => Ijkl, x y z w;
}

macro_rules! arrays {
    ($($integer:ty)*) => {$(
        impl IntoIndex<I> for [$integer; 1] {
            #[inline(always)]
            fn coordinates(self) -> [i64; MAX_AXES] {
                [self[0].wide(), 0, 0, 0]
            }
        }
        impl IntoIndex<Ij> for [$integer; 2] {
            #[inline(always)]
            fn coordinates(self) -> [i64; MAX_AXES] {
                [self[0].wide(), self[1].wide(), 0, 0]
            }
        }
        impl IntoIndex<Ijk> for [$integer; 3] {
            #[inline(always)]
            fn coordinates(self) -> [i64; MAX_AXES] {
                [self[0].wide(), self[1].wide(), self[2].wide(), 0]
            }
        }
        impl IntoIndex<Ijkl> for [$integer; 4] {
            #[inline(always)]
            fn coordinates(self) -> [i64; MAX_AXES] {
                self.map(Integer::wide)
            }
        }
    )*};
}
arrays!(i32 u32 i64 u64);

// `[usize; N]` is sealed on its own: `usize` is no element.
impl Sealed for [usize; 0] {}
impl Sealed for [usize; 1] {}
impl Sealed for [usize; 2] {}
impl Sealed for [usize; 3] {}
impl Sealed for [usize; 4] {}
arrays!(usize);

/// Whether the coordinates lie within the extents, and they as unsigned numbers.
#[inline(always)]
pub(crate) fn within<X: Axes>(at: [i64; MAX_AXES], shape: &[u32; MAX_AXES]) -> Option<[u32; MAX_AXES]> {
    crate::axes::all::<X>(
        #[inline(always)]
        |a| (at[a] as u64) < u64::from(shape[a]),
    )
    .then(
        #[inline(always)]
        || [at[0] as u32, at[1] as u32, at[2] as u32, at[3] as u32],
    )
}

/// The nearest element to the coordinates; `None` where there is no element.
#[inline(always)]
pub(crate) fn clamped<X: Axes>(at: [i64; MAX_AXES], shape: &[u32; MAX_AXES]) -> Option<[u32; MAX_AXES]> {
    let near = per_axis(
        #[inline(always)]
        |a| at[a].min(i64::from(shape[a]) - 1).max(0),
    );
    within::<X>(near, shape)
}

/// The element at the coordinates modulo the extents; `None` where there is no element, or where a coordinate is none that
/// an `i64` holds.
#[inline(always)]
pub(crate) fn wrapped<X: Axes>(at: [i64; MAX_AXES], shape: &[u32; MAX_AXES]) -> Option<[u32; MAX_AXES]> {
    let inside = per_axis(
        #[inline(always)]
        |a| {
            let (c, n) = (at[a], i64::from(shape[a]));
            // One extent away is what stencils reach, and needs no division.
            let near = if c < 0 { c + n } else { c - if c < n { 0 } else { n } };
            if (near as u64) < n as u64 { near } else { wrapped_far(c, n) }
        },
    );
    within::<X>(inside, shape)
}

/// `c` modulo `n`; -1 where there is no such place.
#[cold]
fn wrapped_far(c: i64, n: i64) -> i64 {
    // `i64::MAX` stands for all that is larger (`Integer::wide`).
    if n == 0 || c == i64::MAX { -1 } else { c.rem_euclid(n) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boundary_rules_at_the_ends_of_integers() {
        for n in [0u32, 1, 2, 3, 7, i32::MAX as u32] {
            let shape = [n, 1, 1, 1];
            for c in [i64::MIN, i64::MIN + 1, -8, -7, -3, -1, 0, 1, 2, 3, 6, 7, 8, 20, i64::MAX - 1] {
                let expected = (n > 0).then(|| [c.rem_euclid(i64::from(n).max(1)) as u32, 0, 0, 0]);
                assert_eq!(wrapped::<I>([c, 0, 0, 0], &shape), expected, "{c} modulo {n}");
                let expected = (n > 0).then(|| [c.clamp(0, i64::from(n).max(1) - 1) as u32, 0, 0, 0]);
                assert_eq!(clamped::<I>([c, 0, 0, 0], &shape), expected, "{c} near {n}");
            }
            assert_eq!(wrapped::<I>([u64::MAX.wide(), 0, 0, 0], &shape), None);
        }
    }
}
