//! Bodies over many neighbouring elements at once: `#[kernel(lanes = 16)]`.
//!
//! The expansion cuts a body at its inner loops and runs each stretch for all elements of a batch before the next, so that the compiler can
//! make vectors of them. What a body keeps from one stretch to the next is held here, an array a component; what has left a
//! loop or does not enter a branch is masked out.

use core::mem::{MaybeUninit, size_of};

use super::run::{Cell, Run, copies_rows};
use super::{Space, once};
use crate::element::{Element, Scalar};

/// So many neighbouring elements of a run.
#[doc(hidden)]
#[derive(Debug)]
pub struct Batch<'r, S, const W: usize> {
    run: &'r Run<'r, S>,
    slot: usize,
}

/// What a body gets: a batch, or an element alone.
#[doc(hidden)]
#[derive(Debug)]
#[allow(missing_docs, reason = "named after what they hold")]
pub enum Part<'r, S, const W: usize> {
    Batch(Batch<'r, S, W>),
    Cell(Cell<'r, S>),
}

/// The number of an element in its batch: less than `W`, which [`Batch::cells`] alone makes.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Lane<const W: usize>(usize);

impl<S: Space, const W: usize> Batch<'_, S, W> {
    /// The elements, each with its number.
    #[inline(always)]
    pub fn cells(&self) -> impl Iterator<Item = (Lane<W>, Cell<'_, S>)> {
        (0..W).map(
            #[inline(always)]
            |lane| (Lane(lane), self.run.cell(self.slot + lane, true)),
        )
    }
}

impl<S: Space> Run<'_, S> {
    /// Calls `body` for batches of `W` elements, and for each element that is left over. `halo` is as for [`each`](Self::each).
    #[inline(always)]
    pub fn batches<const W: usize, const N: usize>(
        &self,
        _: Width<W>,
        halo: [u32; N],
        mut body: impl FnMut(Part<'_, S, W>),
    ) {
        // Short blocks hold no batch: nothing is compiled for them.
        if const { S::RUN > 0 && S::RUN < W } {
            return self.each_of_pieces(
                halo,
                #[inline(always)]
                |cell| body(Part::Cell(cell)),
            );
        }
        let halo = if S::AXIS < N { halo[S::AXIS] as usize } else { 0 };
        // The elements whose rows do not leave the block.
        let (head, tail) = if const { S::RUN == 0 || copies_rows::<S>() } || halo == 0 {
            (0, self.len)
        } else {
            let inner = |k: usize| k.clamp(self.first, self.first + self.len) - self.first;
            let head = inner(halo);
            (head, inner(S::RUN.saturating_sub(halo)).max(head))
        };
        let full = head + (tail - head) / W * W;
        // Where rows stay in the block, not even the code for the ends is there.
        if const { S::RUN > 0 && !copies_rows::<S>() } {
            for slot in 0..head {
                once(&mut body, Part::Cell(self.cell(slot, false)));
            }
        }
        for slot in (head..full).step_by(W) {
            once(&mut body, Part::Batch(Batch { run: self, slot }));
        }
        for slot in full..tail {
            once(&mut body, Part::Cell(self.cell(slot, true)));
        }
        if const { S::RUN > 0 && !copies_rows::<S>() } {
            for slot in tail..self.len {
                once(&mut body, Part::Cell(self.cell(slot, false)));
            }
        }
    }
}

/// A number of lanes.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Width<const W: usize>;

/// What a variable of a body may be that is kept from one stretch to the next.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "a variable of type `{Self}` cannot be kept in lanes",
    label = "declared before an inner loop or a branch, and used in it or behind it",
    note = "lanes keep f32, f64, i8..i64, u8..u64, usize, isize, bool, glam's vectors, matrices and quaternions, arrays of these, and enums that have #[derive(Element)]; keep a record's members in variables of their own"
)]
pub trait InLanes: Copy {
    /// As what it is kept.
    type Kept: Element;
    /// The value to keep.
    fn keep(self) -> Self::Kept;
    /// The value that was kept.
    fn of(kept: Self::Kept) -> Self;
}

#[diagnostic::do_not_recommend]
impl<T: Element> InLanes for T {
    type Kept = T;
    #[inline(always)]
    fn keep(self) -> T {
        self
    }
    #[inline(always)]
    fn of(kept: T) -> T {
        kept
    }
}

impl InLanes for usize {
    type Kept = u64;
    #[inline(always)]
    fn keep(self) -> u64 {
        self as u64
    }
    #[inline(always)]
    fn of(kept: u64) -> usize {
        kept as usize
    }
}

impl InLanes for isize {
    type Kept = i64;
    #[inline(always)]
    fn keep(self) -> i64 {
        self as i64
    }
    #[inline(always)]
    fn of(kept: i64) -> isize {
        kept as isize
    }
}

/// A variable of a body, for each element of a batch.
#[doc(hidden)]
pub struct Lanes<T: InLanes, const W: usize> {
    /// Component `c` of lane `l` is scalar `c * W + l`.
    values: [MaybeUninit<T::Kept>; W],
}

impl<T: InLanes, const W: usize> core::fmt::Debug for Lanes<T, W> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Lanes").finish_non_exhaustive()
    }
}

impl<T: InLanes, const W: usize> Lanes<T, W> {
    const SCALAR: usize = size_of::<<T::Kept as Element>::Scalar>();
    /// How many bytes the components of an element lie apart.
    const APART: usize = {
        assert!(<T::Kept as Element>::COMPONENTS * Self::SCALAR <= size_of::<T::Kept>());
        W * Self::SCALAR
    };

    /// A variable that no element has set.
    #[inline(always)]
    pub fn new(_: Width<W>) -> Self {
        Self { values: [const { MaybeUninit::zeroed() }; W] }
    }

    /// The value of an element.
    #[inline(always)]
    pub fn get(&self, lane: Lane<W>) -> T {
        let at = self.values.as_ptr().cast::<u8>().wrapping_add(lane.0 * Self::SCALAR);
        // SAFETY: the lane is less than `W`, so that all components lie within the array; they are zeros or were set, and zeros are a
        // value of every scalar.
        T::of(unsafe { T::Kept::gather(at, Self::APART) })
    }

    /// Sets the value of an element.
    #[inline(always)]
    pub fn set(&mut self, lane: Lane<W>, value: T) {
        let at = self.values.as_mut_ptr().cast::<u8>().wrapping_add(lane.0 * Self::SCALAR);
        // SAFETY: the lane is less than `W`, so that all components lie within the array.
        unsafe { value.keep().scatter(at, Self::APART) }
    }

    /// Sets the value of an element that is not masked out.
    ///
    /// By the bits, and not by a branch: that would be a store under a condition, which vectors of many processors do not have.
    #[inline(always)]
    pub fn set_masked(&mut self, mask: &Mask<W>, lane: Lane<W>, value: T) {
        let (new, old) = (value.keep(), self.get(lane).keep());
        let on = mask.0[lane.0];
        let blended = T::Kept::combine(
            new,
            old,
            #[inline(always)]
            |new, old| Scalar::blend(on, new, old),
        );
        self.set(lane, T::of(blended));
    }

    /// A value that stands for one that is masked out.
    #[inline(always)]
    pub fn nothing(&self) -> T {
        // SAFETY: zeros are a value of every scalar.
        let zero = unsafe { MaybeUninit::<<T::Kept as Element>::Scalar>::zeroed().assume_init() };
        T::of(T::Kept::of_scalar(zero))
    }
}

/// Which elements of a batch take part: all bits of a lane, or none.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Mask<const W: usize>([u32; W]);

impl<const W: usize> Mask<W> {
    /// A mask that lets nothing through.
    #[inline(always)]
    pub fn new(_: Width<W>) -> Self {
        Self([0; W])
    }

    /// Whether an element takes part.
    #[inline(always)]
    pub fn lets(&self, lane: Lane<W>) -> bool {
        self.0[lane.0] != 0
    }

    /// Lets an element take part, or not, and tells so by its bits.
    #[inline(always)]
    pub fn set(&mut self, lane: Lane<W>, on: bool) -> u32 {
        let bits = u32::from(on).wrapping_neg();
        self.0[lane.0] = bits;
        bits
    }
}

/// The ends of a range, of one type.
#[doc(hidden)]
#[inline(always)]
pub fn ends<T>(range: core::ops::Range<T>) -> (T, T) {
    (range.start, range.end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Mat3, Vec3, Vec3A};

    fn lanes<const W: usize>() -> impl Iterator<Item = Lane<W>> {
        (0..W).map(Lane)
    }

    /// Keeps a value a lane, masks some out, and compares with an array.
    fn keeps<T: InLanes + PartialEq + core::fmt::Debug>(value: impl Fn(usize) -> T) {
        let (mut kept, mut mask) = (Lanes::<T, 8>::new(Width), Mask::new(Width));
        lanes().for_each(|lane| kept.set(lane, value(lane.0)));
        lanes().for_each(|lane| assert_eq!(kept.get(lane), value(lane.0)));
        let mut any = 0;
        lanes().for_each(|lane| any |= mask.set(lane, lane.0 % 3 == 0));
        assert_eq!(any, u32::MAX);
        lanes().for_each(|lane| kept.set_masked(&mask, lane, value(100 + lane.0)));
        for lane in lanes() {
            assert_eq!(kept.get(lane), value(if mask.lets(lane) { 100 + lane.0 } else { lane.0 }));
        }
        lanes().for_each(|lane| any &= mask.set(lane, false));
        assert_eq!(any, 0);
    }

    #[test]
    fn lanes_keep_what_they_are_given() {
        keeps(|n| n as f32 - 3.5);
        keeps(|n| n as f64 * 1e300);
        keeps(|n| n as u8);
        keeps(|n| n as i16 - 50);
        keeps(|n| -(n as i64) << 40);
        keeps(|n| usize::MAX - n);
        keeps(|n| n as isize - 50);
        keeps(|n| n % 2 == 0);
        keeps(|n| Vec3::new(n as f32, -1.0, 0.5 * n as f32));
        keeps(|n| Vec3A::new(n as f32, -1.0, 0.5 * n as f32));
        keeps(|n| Mat3::from_diagonal(Vec3::splat(n as f32)));
        keeps(|n| [[n as u16, 2], [3, n as u16 + 1], [5, 6]]);
    }
}
