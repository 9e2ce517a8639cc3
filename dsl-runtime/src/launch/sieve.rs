//! Loops over some elements of a space: a border, or those of one colour.

use core::marker::PhantomData;
use core::ops::Range;

use super::run::Run;
use super::space::Space;
use crate::axes::{Axes, MAX_AXES, PerAxis};
use crate::element::Sealed;
use crate::index::{Integer, IntoIndex};
use crate::layout::{Digit, Geometry};
use crate::scatter::Piece;

/// Which elements of a space are visited.
#[doc(hidden)]
pub trait Sieve: Copy + Send + Sync + Sealed + 'static {
    /// The sieve for that many axes.
    ///
    /// # Panics
    /// Where there is no such colour.
    #[track_caller]
    fn over(self, axes: usize) -> Self {
        let _ = axes;
        self
    }

    /// Calls `piece` with the first element and the length of each piece that is visited of a run: the elements
    /// `first..first + len` along `axis`, of which element 0 lies at `at`. Pieces do not overlap.
    fn pieces(&self, at: [i64; MAX_AXES], axis: usize, first: usize, len: usize, piece: impl FnMut(usize, usize));
}

/// The elements that lie outside of a box, in logical coordinates.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Border {
    first: [i64; MAX_AXES],
    end: [i64; MAX_AXES],
    axes: usize,
}

impl Border {
    /// The border of that width; all where the widths meet.
    pub(crate) fn new<X: Axes>(geometry: &Geometry, width: u32) -> Self {
        let (mut first, mut end) = ([0; MAX_AXES], [1; MAX_AXES]);
        for axis in 0..X::RANK {
            let size = geometry.shape[axis];
            let origin = i64::from(geometry.origin[axis]);
            first[axis] = origin + i64::from(width.min(size));
            end[axis] = (origin + i64::from(size.saturating_sub(width))).max(first[axis]);
        }
        Self { first, end, axes: X::RANK }
    }
}

impl Sealed for Border {}
impl Sieve for Border {
    #[inline(always)]
    fn pieces(&self, at: [i64; MAX_AXES], axis: usize, first: usize, len: usize, mut piece: impl FnMut(usize, usize)) {
        let beyond = |a: usize| a != axis && (at[a] < self.first[a] || at[a] >= self.end[a]);
        if (0..self.axes).any(beyond) {
            return piece(first, len);
        }
        // What lies before the box, and what lies behind it.
        let (from, to) = (at[axis] + first as i64, at[axis] + (first + len) as i64);
        let (before, behind) = (self.first[axis].min(to), self.end[axis].max(from));
        if from < before {
            piece(first, (before - from) as usize);
        }
        if behind < to {
            piece((behind - at[axis]) as usize, (to - behind) as usize);
        }
    }
}

/// The elements whose coordinates' sum has one parity.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Checkerboard {
    parity: usize,
}

impl Checkerboard {
    /// Those of colour 0 or 1.
    ///
    /// # Panics
    /// Where the colour is another number.
    #[track_caller]
    pub fn new(colour: impl Integer) -> Self {
        match colour.wide() {
            parity @ (0 | 1) => Self { parity: parity as usize },
            _ => panic!("`checkerboard({colour:?})`: its colours are 0 and 1"),
        }
    }
}

impl Sealed for Checkerboard {}
impl Sieve for Checkerboard {
    #[inline(always)]
    fn pieces(&self, at: [i64; MAX_AXES], _: usize, first: usize, len: usize, mut piece: impl FnMut(usize, usize)) {
        // The lowest bit of a sum, also of negative numbers.
        let odd = (at[0] ^ at[1] ^ at[2] ^ at[3]) as usize & 1;
        let mut k = first + ((odd ^ first ^ self.parity) & 1);
        while k < first + len {
            piece(k, 1);
            k += 2;
        }
    }
}

/// The elements whose coordinates modulo a number spell a colour, the first axis most significant.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Colored {
    modulus: i64,
    colour: i64,
    /// The colour's digits.
    digits: [i64; MAX_AXES],
    axes: usize,
}

impl Colored {
    /// Those of a colour below `modulus` to the power of the number of axes.
    ///
    /// # Panics
    /// Where the modulus is none.
    #[track_caller]
    pub fn new(modulus: impl Integer, colour: impl Integer) -> Self {
        let (n, c) = (modulus.wide(), colour.wide());
        assert!(n > 0, "`colored({modulus:?}, {colour:?})`: coordinates are taken modulo a positive number");
        Self { modulus: n, colour: c, digits: [0; MAX_AXES], axes: 0 }
    }
}

impl Sealed for Colored {}
impl Sieve for Colored {
    #[track_caller]
    fn over(mut self, axes: usize) -> Self {
        let (n, c) = (self.modulus, self.colour);
        let colours = n.saturating_pow(axes as u32);
        assert!(
            (0..colours).contains(&c),
            "`colored({n}, {c})`: over so many axes, {axes}, the colours are 0 to {}",
            colours - 1
        );
        let mut rest = c;
        for axis in (0..axes).rev() {
            self.digits[axis] = rest % n;
            rest /= n;
        }
        Self { axes, ..self }
    }

    #[inline(always)]
    fn pieces(&self, at: [i64; MAX_AXES], axis: usize, first: usize, len: usize, mut piece: impl FnMut(usize, usize)) {
        let differs = |a: usize| a != axis && at[a].rem_euclid(self.modulus) != self.digits[a];
        if (0..self.axes).any(differs) {
            return;
        }
        let skipped = (self.digits[axis] - at[axis] - first as i64).rem_euclid(self.modulus) as usize;
        let mut k = first.saturating_add(skipped);
        while k < first + len {
            piece(k, 1);
            k = k.saturating_add(self.modulus as usize);
        }
    }
}

/// Those elements of a space that a sieve lets through.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Sifted<S, F> {
    space: S,
    sieve: F,
}

/// The elements of a space that a sieve lets through.
///
/// # Panics
/// Where the space has no such colour.
#[doc(hidden)]
#[track_caller]
pub fn sift<S: Space, F: Sieve>(space: S, sieve: F) -> Sifted<S, F> {
    Sifted { space, sieve: sieve.over(S::RANK) }
}

/// The same in a serial loop.
///
/// # Panics
/// Where there is no such colour.
#[doc(hidden)]
#[track_caller]
pub fn sifted<X: Axes, T: IntoIndex<X>, F: Sieve>(
    indices: impl Iterator<Item = T>,
    sieve: F,
) -> impl Iterator<Item = T> {
    let sieve = sieve.over(X::RANK);
    indices.filter(move |index| {
        let mut passes = false;
        sieve.pieces(index.coordinates(), 0, 0, 1, |_, _| passes = true);
        passes
    })
}

impl<S, F> Sealed for Sifted<S, F> {}

/// A space whose elements are of one colour of a checkerboard: the sums of their coordinates have one parity.
#[doc(hidden)]
pub trait TwoColours: Space {}
impl<S: Space> TwoColours for Sifted<S, Checkerboard> {}
impl<S: TwoColours> TwoColours for Sifted<S, Border> {}
impl<S: TwoColours> TwoColours for Sifted<S, Colored> {}

impl<S: Space, F: Sieve> Space for Sifted<S, F> {
    const RANK: usize = S::RANK;
    type Index = S::Index;
    type Tuple = S::Tuple;
    const AXIS: usize = S::AXIS;
    const RUN: usize = S::RUN;
    const EXTENT: PerAxis = S::EXTENT;
    const DIGITS: &'static [Digit] = S::DIGITS;
    const SPARSE: bool = S::SPARSE;
    const BRANCH: usize = S::BRANCH;
    const DIVISIBLE: bool = S::DIVISIBLE;

    /// As many as there are to sift: what decides how they are dealt out.
    fn elements(&self) -> usize {
        self.space.elements()
    }

    fn units(&self) -> usize {
        self.space.units()
    }

    fn bounds(&self) -> ([i64; MAX_AXES], [i64; MAX_AXES]) {
        self.space.bounds()
    }

    fn origin(&self) -> [i32; MAX_AXES] {
        self.space.origin()
    }

    /// Each piece is a run of its own, a part of a run of the space: no element is visited twice.
    #[inline(always)]
    fn visit<const LIGHT: bool>(&self, units: Range<usize>, fits: bool, mut run: impl FnMut(Run<'_, Self>)) {
        self.space.visit::<false>(
            units,
            fits,
            #[inline(always)]
            |part| {
                self.sieve.pieces(
                    part.at,
                    S::AXIS,
                    part.first,
                    part.len,
                    #[inline(always)]
                    |first, len| {
                        let (mut at, mut first) = (part.at, first);
                        if const { S::RUN == 0 } {
                            // Element 0 of such a run is always one of its own.
                            at[S::AXIS] += first as i64;
                            first = 0;
                        }
                        let Run { block, inner, brick, root, fits, .. } = part;
                        run(Run {
                            at,
                            first,
                            len,
                            block,
                            inner,
                            brick,
                            root,
                            whole: false,
                            fits,
                            mask: None,
                            next: None,
                            owner: PhantomData,
                        });
                    },
                );
            },
        );
    }

    #[inline(always)]
    fn part(&self, piece: Piece) -> Self {
        Self { space: self.space.part(piece), sieve: self.sieve }
    }

    #[inline(always)]
    fn index(at: [i64; MAX_AXES]) -> S::Index {
        S::index(at)
    }

    #[inline(always)]
    fn tuple(at: [i64; MAX_AXES]) -> S::Tuple {
        S::tuple(at)
    }
}
