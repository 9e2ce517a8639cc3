//! What an element can be indexed by: any integers, converted with a check.

use crate::axes::{Axes, I, Ij, Ijk, Ijkl, MAX_AXES, O, per_axis};
use crate::element::Sealed;
use crate::layout::Geometry;

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

/// The place of logical coordinates, where they lie within the shape.
#[inline(always)]
pub(crate) fn within<X: Axes>(at: [i64; MAX_AXES], geometry: &Geometry) -> Option<[u32; MAX_AXES]> {
    let place = per_axis(
        #[inline(always)]
        |a| place(at[a], geometry.origin[a]),
    );
    inside::<X>(place, &geometry.shape)
}

/// How far a coordinate lies beyond the origin. What lies below it becomes, as an unsigned number, larger than any extent; so do
/// coordinates at the ends of an `i64`, where the difference wraps around, since an origin is an `i32`.
#[inline(always)]
fn place(at: i64, origin: i32) -> i64 {
    at.wrapping_sub(i64::from(origin))
}

/// Places that lie within the shape, as unsigned numbers.
#[inline(always)]
pub(crate) fn inside<X: Axes>(place: [i64; MAX_AXES], shape: &[u32; MAX_AXES]) -> Option<[u32; MAX_AXES]> {
    crate::axes::all::<X>(
        #[inline(always)]
        |a| (place[a] as u64) < u64::from(shape[a]),
    )
    .then(
        #[inline(always)]
        || [place[0] as u32, place[1] as u32, place[2] as u32, place[3] as u32],
    )
}

/// The place of the element that is nearest to the logical coordinates; `None` where there is no element.
#[inline(always)]
pub(crate) fn clamped<X: Axes>(at: [i64; MAX_AXES], geometry: &Geometry) -> Option<[u32; MAX_AXES]> {
    let near = per_axis(
        #[inline(always)]
        |a| {
            let first = i64::from(geometry.origin[a]);
            at[a].min(first + i64::from(geometry.shape[a]) - 1).max(first) - first
        },
    );
    inside::<X>(near, &geometry.shape)
}

/// The place of the element at the logical coordinates modulo the extents; `None` where there is no element, or where a coordinate
/// is none that an `i64` holds.
#[inline(always)]
pub(crate) fn wrapped<X: Axes>(at: [i64; MAX_AXES], geometry: &Geometry) -> Option<[u32; MAX_AXES]> {
    let near = per_axis(
        #[inline(always)]
        |a| {
            let (c, n) = (place(at[a], geometry.origin[a]), i64::from(geometry.shape[a]));
            // One extent away is what stencils reach, and needs no division.
            let near = if c < 0 { c + n } else { c - if c < n { 0 } else { n } };
            if (near as u64) < n as u64 { near } else { wrapped_far(at[a], geometry.origin[a], n) }
        },
    );
    inside::<X>(near, &geometry.shape)
}

/// The place of `c` modulo `n`; -1 where there is no such place.
#[cold]
fn wrapped_far(c: i64, origin: i32, n: i64) -> i64 {
    // `i64::MAX` stands for all that is larger (`Integer::wide`).
    if n == 0 || c == i64::MAX { -1 } else { (i128::from(c) - i128::from(origin)).rem_euclid(i128::from(n)) as i64 }
}

/// Puts places in row-major order. Sorting is much code: there is one copy of it for all layouts.
#[inline(never)]
pub(crate) fn sort(places: &mut [[u32; MAX_AXES]]) {
    places.sort_unstable();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::Aos;

    #[test]
    fn boundary_rules_at_the_ends_of_integers() {
        const LONGEST: u32 = i32::MAX as u32;
        let ends = [i64::MIN, i64::MIN + 1, -8, -7, -3, -1, 0, 1, 2, 3, 6, 7, 8, 20, i64::MAX - 1];
        for (n, origin) in [0u32, 1, 2, 3, 7, LONGEST]
            .into_iter()
            .flat_map(|n| [i32::MIN, -9, -3, 0, 5, i32::MAX - 7].map(|origin| (n, origin)))
            .filter(|&(n, origin)| origin.checked_add_unsigned(n).is_some())
        {
            let geometry = Geometry::new::<Aos, I>([n as usize, 1, 1, 1])
                .and_then(|geometry| geometry.with_origin::<I>([i64::from(origin), 0, 0, 0]))
                .expect("a geometry");
            let near = |by: i64| (i64::from(origin)).saturating_add(by);
            for c in ends.into_iter().chain(ends.map(near)).filter(|&c| c != i64::MAX) {
                let place = |place: i128| [place as u32, 0, 0, 0];
                let (beyond, extent) = (i128::from(c) - i128::from(origin), i128::from(n));
                let at = [c, 0, 0, 0];
                let expected = (0..extent).contains(&beyond).then(|| place(beyond));
                assert_eq!(within::<I>(at, &geometry), expected, "{c} within {n} from {origin}");
                let expected = (n > 0).then(|| place(beyond.rem_euclid(extent.max(1))));
                assert_eq!(wrapped::<I>(at, &geometry), expected, "{c} modulo {n} from {origin}");
                let expected = (n > 0).then(|| place(beyond.clamp(0, extent.max(1) - 1)));
                assert_eq!(clamped::<I>(at, &geometry), expected, "{c} near {n} from {origin}");
            }
            assert_eq!(wrapped::<I>([u64::MAX.wide(), 0, 0, 0], &geometry), None);
            assert_eq!(within::<I>([u64::MAX.wide(), 0, 0, 0], &geometry), None);
        }
    }
}
