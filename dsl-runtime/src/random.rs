//! Random numbers that are a function of a seed and a key.

use crate::axes::MAX_AXES;
use crate::element::Sealed;
use crate::index::Integer;

/// A random value of a seed and a key: always the same for the same two, whichever thread asks, and whenever.
///
/// Numbers of type `f32` and `f64` are uniform in 0 (included) to 1 (excluded), in steps of 2^-24 and 2^-53; vectors have such components; integers
/// and `bool` are uniform over all their values. The key is an integer, or several as a tuple, array or vector: the loop variable, say,
/// with the number of the step and of the draw, `(p, step, 0)`. Different keys give independent values, and so do different seeds.
///
/// The generator is Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011). Keys of three or four integers count
/// modulo 2^32 each; those of one or two modulo 2^64.
///
/// ```
/// use allotrope::prelude::*;
///
/// /// Throws darts at the unit square.
/// #[kernel]
/// fn hits(darts: u32, seed: u64) -> u32 {
///     let mut hits = 0;
///     for dart in 0..darts {
///         let at = random::<Vec2>(seed, dart);
///         hits += u32::from(at.length_squared() < 1.0);
///     }
///     hits
/// }
///
/// let pi = 4.0 * f64::from(hits(1_000_000, 7)) / 1e6;
/// assert!((pi - std::f64::consts::PI).abs() < 0.01);
/// assert_eq!(random::<u32>(7, 3), random::<u32>(7, 3));
/// assert_ne!(random::<u32>(7, (3, 0)), random::<u32>(7, (3, 1)));
/// ```
#[inline]
pub fn random<T: Random>(seed: u64, key: impl RandomKey) -> T {
    let (counter, tweak) = key.counter();
    T::draw(
        #[inline(always)]
        |block| philox(counter, [seed as u32, (seed >> 32) as u32 ^ tweak ^ block << 8]),
    )
}

/// A type of which [`random`] makes values: `f32`, `f64`, integers, `bool`, and glam's vectors of `f32` and `f64`.
#[diagnostic::on_unimplemented(
    message = "`random` makes no `{Self}`",
    note = "it makes f32, f64, i8..i64, u8..u64, bool, Vec2, Vec3, Vec3A, Vec4, DVec2, DVec3 and DVec4"
)]
pub trait Random: Copy + Sealed {
    /// The value of 128 random bits, or of several times as many: `bits` gives those of a number.
    #[doc(hidden)]
    fn draw(bits: impl Fn(u32) -> [u32; 4]) -> Self;
}

/// What [`random`] may be keyed by: an integer, or a tuple, array or vector of up to four.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no key of a random number",
    note = "a key is an integer, or several as a tuple, an array or an integer vector, up to four"
)]
pub trait RandomKey: Copy {
    /// The counter, and what tells it from those of other numbers of integers.
    #[doc(hidden)]
    fn counter(self) -> ([u32; 4], u32);
}

fn one(key: i64) -> ([u32; 4], u32) {
    ([key as u32, (key >> 32) as u32, 0, 0], 1)
}
fn two(a: i64, b: i64) -> ([u32; 4], u32) {
    ([a as u32, (a >> 32) as u32, b as u32, (b >> 32) as u32], 2)
}

impl<T: Integer> RandomKey for T {
    #[inline(always)]
    fn counter(self) -> ([u32; 4], u32) {
        one(self.wide())
    }
}
macro_rules! tuples {
    ($($name:ident $($others:ident)*;)*) => {$(
        #[allow(non_snake_case, reason = "values named as their types")]
        impl<$name: Integer, $($others: Integer),*> RandomKey for ($name, $($others,)*) {
            #[inline(always)]
            fn counter(self) -> ([u32; 4], u32) {
                let ($name, $($others,)*) = self;
                of(&[$name.wide(), $($others.wide()),*])
            }
        }
    )*};
}
tuples! { A; A B; A B C; A B C D; }
impl<T: Integer, const N: usize> RandomKey for [T; N] {
    #[inline(always)]
    fn counter(self) -> ([u32; 4], u32) {
        const { assert!(N > 0 && N <= MAX_AXES, "a key has one to four integers") }
        of(&self.map(Integer::wide))
    }
}
macro_rules! vector_keys {
    ($($vector:ty)*) => {$(
        impl RandomKey for $vector {
            #[inline(always)]
            fn counter(self) -> ([u32; 4], u32) {
                self.to_array().counter()
            }
        }
    )*};
}
vector_keys!(glam::IVec2 glam::IVec3 glam::IVec4 glam::UVec2 glam::UVec3 glam::UVec4);

/// The counter of one to four integers.
#[inline(always)]
fn of(keys: &[i64]) -> ([u32; 4], u32) {
    match *keys {
        [a] => one(a),
        [a, b] => two(a, b),
        _ => {
            let mut counter = [0; 4];
            counter.iter_mut().zip(keys).for_each(|(word, key)| *word = *key as u32);
            (counter, keys.len() as u32)
        }
    }
}

/// Ten rounds of Philox4x32.
#[inline(always)]
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    for _ in 0..10 {
        let a = u64::from(counter[0]) * 0xD251_1F53;
        let b = u64::from(counter[2]) * 0xCD9E_8D57;
        counter = [(b >> 32) as u32 ^ counter[1] ^ key[0], b as u32, (a >> 32) as u32 ^ counter[3] ^ key[1], a as u32];
        key = [key[0].wrapping_add(0x9E37_79B9), key[1].wrapping_add(0xBB67_AE85)];
    }
    counter
}

/// The number of 24 bits in 0 to 1.
#[inline(always)]
fn single(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / (1 << 24) as f32)
}

/// The number of 53 bits in 0 to 1.
#[inline(always)]
fn double(low: u32, high: u32) -> f64 {
    let bits = u64::from(high) << 32 | u64::from(low);
    (bits >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

macro_rules! random {
    ($($kind:ty: |$bits:ident| $value:expr;)*) => {$(
        impl Random for $kind {
            #[inline(always)]
            fn draw($bits: impl Fn(u32) -> [u32; 4]) -> Self {
                $value
            }
        }
    )*};
}
random! {
    f32: |bits| single(bits(0)[0]);
    f64: |bits| { let [a, b, ..] = bits(0); double(a, b) };
    bool: |bits| bits(0)[0] >> 31 == 1;
    u8: |bits| (bits(0)[0] >> 24) as u8;
    u16: |bits| (bits(0)[0] >> 16) as u16;
    u32: |bits| bits(0)[0];
    u64: |bits| { let [a, b, ..] = bits(0); u64::from(b) << 32 | u64::from(a) };
    i8: |bits| u8::draw(bits) as i8;
    i16: |bits| u16::draw(bits) as i16;
    i32: |bits| u32::draw(bits) as i32;
    i64: |bits| u64::draw(bits) as i64;
    glam::Vec2: |bits| { let [a, b, ..] = bits(0); glam::vec2(single(a), single(b)) };
    glam::Vec3: |bits| { let [a, b, c, _] = bits(0); glam::vec3(single(a), single(b), single(c)) };
    glam::Vec3A: |bits| glam::Vec3::draw(bits).into();
    glam::Vec4: |bits| { let [a, b, c, d] = bits(0); glam::vec4(single(a), single(b), single(c), single(d)) };
    glam::DVec2: |bits| { let [a, b, c, d] = bits(0); glam::dvec2(double(a, b), double(c, d)) };
    glam::DVec3: |bits| glam::DVec4::draw(bits).truncate();
    glam::DVec4: |bits| {
        let ([a, b, c, d], [e, f, g, h]) = (bits(0), bits(1));
        glam::dvec4(double(a, b), double(c, d), double(e, f), double(g, h))
    };
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn known_answers() {
        // `kat_vectors` of Random123, the authors' own implementation.
        assert_eq!(philox([0; 4], [0; 2]), [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]);
        assert_eq!(philox([!0; 4], [!0; 2]), [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]);
        let counter = [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344];
        let value = philox(counter, [0xa409_3822, 0x299f_31d0]);
        assert_eq!(value, [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1]);
    }

    #[test]
    fn different_keys_and_seeds_differ() {
        let mut seen = BTreeSet::new();
        let mut draws = 0;
        let mut note = |value: u64| {
            draws += 1;
            seen.insert(value);
        };
        for a in -3..3 {
            note(random(1, a));
            note(random(1, [i64::from(a) << 33 | 100]));
            for b in [0i64, 1, -1, 1 << 40] {
                note(random(1, (a, b)));
                note(random(2, (a, b)));
                note(random(1, (a, b as i32, 0)));
                note(random(1, glam::ivec4(a, b as i32 + 7, 0, 0)));
            }
        }
        // `1 << 40` is 0 as an `i32`.
        assert_eq!(seen.len(), draws - 6 * 2);
        assert_eq!(random::<u64>(5, 3u8), random::<u64>(5, (3i64,)));
        assert_eq!(random::<u64>(5, glam::ivec2(3, -1)), random::<u64>(5, (3i64, -1i8)));
    }

    #[test]
    fn values_are_uniform() {
        let n = 100_000;
        let mean = |value: &dyn Fn(i32) -> f64| (0..n).map(value).sum::<f64>() / f64::from(n);
        // The mean of n uniform numbers has a standard deviation of 0.289 / sqrt(n): 0.0009 here.
        assert!((mean(&|k| random::<f32>(3, k).into()) - 0.5).abs() < 0.004);
        assert!((mean(&|k| random::<f64>(3, k).powi(2)) - 1.0 / 3.0).abs() < 0.004);
        assert!((mean(&|k| random::<bool>(3, k).into()) - 0.5).abs() < 0.006);
        assert!((mean(&|k| random::<glam::DVec3>(3, k).z * random::<glam::DVec3>(3, k).x) - 0.25).abs() < 0.004);
        assert!((mean(&|k| f64::from(random::<i8>(3, k))) + 0.5).abs() < 1.0);
        let value = |k| random::<glam::Vec4>(9, k);
        assert!((0..n).all(|k| value(k).min_element() >= 0.0 && value(k).max_element() < 1.0));
    }
}
