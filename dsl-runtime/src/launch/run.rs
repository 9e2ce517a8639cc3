//! Runs: neighbouring elements along one axis, and the cells of a run.

use core::marker::PhantomData;

use super::once;
use super::space::Space;
use crate::axes::{MAX_AXES, PerAxis, per_axis};
use crate::store::active::next_bit;
use crate::view::HELD;

/// Elements of a space that follow one another along its run axis.
///
/// A run is handed to a loop's body by the launch alone, once, on one thread: whoever holds it owns its elements.
#[doc(hidden)]
#[derive(Debug)]
pub struct Run<'t, S> {
    /// Logical coordinates of the run's element 0, which is the first of the run unless `first` is larger.
    pub(crate) at: [i64; MAX_AXES],
    /// The elements of the run: `first..first + len`.
    pub(crate) first: usize,
    pub(crate) len: usize,
    /// The block of the loop's field, and the place of element 0 in it.
    pub(crate) block: PerAxis,
    pub(crate) inner: PerAxis,
    /// Where the block begins, and the memory of the loop's field (sparse fields); else null.
    pub(crate) brick: *mut u8,
    pub(crate) root: *mut u8,
    /// Whether the run is a whole run of a block, its length a constant.
    pub(crate) whole: bool,
    /// Which elements of a whole run are the loop's: the others are passed by ([`Space::MASKED`]). None: all.
    pub(crate) mask: Option<Mask>,
    /// The number of the block of the loop's field that comes next, whose neighbours are fetched ahead; none where that is not worth it.
    pub(crate) next: Option<PerAxis>,
    /// Whether the loop's box with all offsets lies within every field that rows are taken from.
    pub(crate) fits: bool,
    /// Neither `Send` nor `Sync`: the elements belong to the thread that got the run.
    pub(crate) owner: PhantomData<(&'t S, *mut ())>,
}

/// The elements of a run that are a loop's, a bit each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mask(pub(crate) u64);

impl Mask {
    /// Whether element `slot` of a run of `S` is the loop's. Few bits are told apart in narrower vectors.
    #[inline(always)]
    pub(crate) fn has<S: Space>(self, slot: usize) -> bool {
        if const { S::RUN <= 32 } { self.0 as u32 & 1 << slot != 0 } else { self.0 & 1 << slot != 0 }
    }
}

/// One element of a run: the token without which nothing can be written.
#[doc(hidden)]
#[derive(Debug)]
pub struct Cell<'r, S> {
    pub(crate) run: &'r Run<'r, S>,
    pub(crate) k: usize,
    /// Its number among the run's elements.
    pub(crate) slot: usize,
    /// Whether neighbours within the loop's halo lie in the same run of the block.
    pub(crate) inside: bool,
    /// Whether it is the loop's: what is written to another is thrown away.
    pub(crate) chosen: bool,
}

/// Runs that are not worth a vector loop of their own, with its checks, where they are cut.
const SHORT: usize = 32;

/// A run so long fills a vector register; where shorter ones are cut into head, middle and tail nothing is lost.
const VECTOR: usize = 4;

/// Whole runs that are no longer are written out where rows of them are copied: a loop would be made one of vectors before the copies become
/// registers, and vectors that are read from memory behind the single values they were written as wait for those.
const WRITTEN_OUT: usize = 16;

/// Does something for each slot of such a run.
macro_rules! for_slots {
    ($space:ty, $slot:ident => $what:expr) => {
        for_slots!($space, $slot => $what; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    ($space:ty, $slot:ident => $what:expr; $($n:literal)*) => {
        $(if const { <$space>::RUN > $n } {
            const $slot: usize = $n;
            $what;
        })*
    };
}

/// Whether rows that lead into other blocks along the run's axis are copied, in loops over such a space: its cells then need not ask where
/// they stand, and a whole run is one vector loop.
pub(crate) const fn copies_rows<S: Space>() -> bool {
    S::RUN > 0 && S::RUN <= HELD && (S::SPARSE || S::RUN >= VECTOR)
}

/// Keeps the compiler from making a vector loop of the one that this stands in.
#[inline(always)]
pub(crate) fn stay_scalar() {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    // SAFETY: no instruction at all.
    unsafe {
        core::arch::asm!("", options(nomem, nostack, preserves_flags));
    }
}

/// An address of which the compiler no longer knows how far it lies from others.
#[inline(always)]
#[cfg_attr(
    all(target_arch = "x86_64", not(miri)),
    expect(clippy::pointers_in_nomem_asm_block, reason = "what it points to is not looked at")
)]
pub(crate) fn apart(address: *mut u8) -> *mut u8 {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    {
        let mut address = address;
        // SAFETY: no instruction at all.
        unsafe {
            core::arch::asm!("/* {0} */", inout(reg) address, options(pure, nomem, nostack, preserves_flags));
        }
        address
    }
    #[cfg(not(all(target_arch = "x86_64", not(miri))))]
    address
}

impl<S: Space> Run<'_, S> {
    #[inline(always)]
    pub(crate) fn cell(&self, slot: usize, inside: bool) -> Cell<'_, S> {
        Cell { run: self, slot, k: self.first + slot, inside, chosen: true }
    }

    /// As [`each`](Self::each); where a mask tells the loop's elements, and the body is arithmetic of floats alone, `body` is called for all elements of the
    /// run, so that the compiler makes vectors of them, and what it writes to the others is thrown away.
    #[inline(always)]
    pub fn each_or_all<const N: usize>(&self, halo: [u32; N], floats: bool, mut body: impl FnMut(Cell<'_, S>)) {
        if const { S::MASKED }
            && floats
            && self.fits
            && let Some(mask) = self.mask
        {
            for slot in 0..S::RUN {
                once(&mut body, Cell { run: self, slot, k: slot, inside: true, chosen: mask.has::<S>(slot) });
            }
        } else {
            self.each(halo, body);
        }
    }

    /// Calls `body` for each element. `halo` is how far along each axis rows reach; no axes where they do not.
    #[inline(always)]
    pub fn each<const N: usize>(&self, halo: [u32; N], mut body: impl FnMut(Cell<'_, S>)) {
        self.each_as::<true, N>(halo, &mut body);
    }

    /// As [`each`](Self::each) in the runs of [`Task::runs`](super::Task::runs), none of which counts as a whole one.
    #[inline(always)]
    pub fn each_of_pieces<const N: usize>(&self, halo: [u32; N], mut body: impl FnMut(Cell<'_, S>)) {
        self.each_as::<false, N>(halo, &mut body);
    }

    /// Conditions on types are blocks of their own wherever the body stands: what they leave out is then not even handed to the optimiser, which
    /// would write the body out there first. The body is borrowed: if it was owned, each call would have code that drops it should the call unwind.
    #[inline(always)]
    fn each_as<const LIGHT: bool, const N: usize>(&self, halo: [u32; N], body: &mut impl FnMut(Cell<'_, S>)) {
        let halo = if S::AXIS < N { halo[S::AXIS] as usize } else { 0 };
        if const { S::RUN == 0 } {
            for slot in 0..self.len {
                once(body, self.cell(slot, true));
            }
        } else if const { LIGHT && S::MASKED }
            && let Some(mask) = self.mask
        {
            // What the body reads has been copied and what it writes is held back, so that the compiler can do it for all and choose.
            for slot in 0..S::RUN {
                if mask.has::<S>(slot) {
                    once(body, self.cell(slot, true));
                }
            }
        } else if const { copies_rows::<S>() } {
            // Rows that lead into other blocks are copied, so that all cells are alike.
            if const { LIGHT && !S::SPARSE && S::RUN <= WRITTEN_OUT && N > 0 } && self.whole {
                for_slots!(S, SLOT => once(body, self.cell(SLOT, true)));
            } else if const { LIGHT && S::SPARSE } && self.whole {
                for slot in 0..S::RUN {
                    once(body, self.cell(slot, true));
                }
            } else {
                for slot in 0..self.len {
                    // In dense fields a run is whole or cut where this is written out, not where it runs.
                    if const { S::RUN <= SHORT } && !self.whole {
                        stay_scalar();
                    }
                    once(body, self.cell(slot, true));
                }
            }
        } else if const { LIGHT } && self.whole {
            // Head, middle and tail: only the ends reach into neighbouring runs, at constant places.
            let head = halo.min(S::RUN);
            let tail = S::RUN.saturating_sub(halo).max(head);
            for slot in 0..head {
                once(body, self.cell(slot, false));
            }
            for slot in head..tail {
                once(body, self.cell(slot, true));
            }
            for slot in tail..S::RUN {
                once(body, self.cell(slot, false));
            }
        } else if const { S::SPARSE } {
            let end = self.first + self.len;
            let head = halo.clamp(self.first, end);
            let tail = S::RUN.saturating_sub(halo).clamp(head, end);
            for k in self.first..head {
                once(body, self.cell(k - self.first, false));
            }
            for k in head..tail {
                once(body, self.cell(k - self.first, true));
            }
            for k in tail..end {
                once(body, self.cell(k - self.first, false));
            }
        } else {
            for slot in 0..self.len {
                once(body, self.cell(slot, halo == 0));
            }
        }
    }

    /// Cuts the run into strips that a reduction's buffer holds.
    #[inline(always)]
    pub fn strips(&self, mut body: impl FnMut(Run<'_, S>)) {
        let strip = |first, len, whole| Run { first, len, whole, mask: None, owner: PhantomData, ..*self };
        if const { S::MASKED }
            && let Some(Mask(mask)) = self.mask
        {
            let mut first = next_bit(&[mask], 0, S::RUN, true);
            while first < S::RUN {
                let end = next_bit(&[mask], first, S::RUN, false);
                body(strip(first, end - first, false));
                first = next_bit(&[mask], end, S::RUN, true);
            }
        } else if const { S::RUN > 0 && S::RUN <= super::reduction::STRIP } {
            body(strip(self.first, self.len, self.whole));
        } else {
            // Full strips have a constant length, so that their buffer becomes registers.
            let (mut first, end) = (self.first, self.first + self.len);
            while first + super::reduction::STRIP <= end {
                body(strip(first, super::reduction::STRIP, false));
                first += super::reduction::STRIP;
            }
            if first < end {
                body(strip(first, end - first, false));
            }
        }
    }
}

impl<S: Space> Cell<'_, S> {
    /// The element's logical coordinates.
    #[inline(always)]
    pub(crate) fn at(&self) -> [i64; MAX_AXES] {
        per_axis(
            #[inline(always)]
            |a| if a == S::AXIS { self.run.at[a].wrapping_add(self.k as i64) } else { self.run.at[a] },
        )
    }

    /// The place of the element in the blocks of the loop's field, which begin at its origin.
    #[inline(always)]
    pub(crate) fn place(&self) -> [i64; MAX_AXES] {
        let Run { block, inner, .. } = self.run;
        per_axis(
            #[inline(always)]
            |a| {
                let start = (block[a] * const { &S::EXTENT }[a] + inner[a]) as i64;
                if a == S::AXIS { start.wrapping_add(self.k as i64) } else { start }
            },
        )
    }

    /// The loop's variable.
    #[inline(always)]
    pub fn index(&self) -> S::Index {
        S::index(self.at())
    }

    /// The loop's variables.
    #[inline(always)]
    pub fn tuple(&self) -> S::Tuple {
        S::tuple(self.at())
    }
}
