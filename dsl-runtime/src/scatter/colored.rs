//! `Colored`: the elements of a loop go with the tile that they update. Tiles of one colour cannot meet and run at the same time, one colour
//! after another. What an element updates beyond its tile's window waits until all have run.

use core::cell::RefCell;

use super::bins::{Bins, Bounds, Sink, Wanted, cells_around, span};
use super::late::Late;
use super::share::Share;
use super::tiles::Tiles;
use super::{Scattered, Shares};
use crate::axes::MAX_AXES;
use crate::launch::{Space, Task, results_of_jobs};

/// A field of so many cells an element may be empty for the most part: its tiles are cut where the keys are.
const ROOMY: usize = 8;

/// Loops of fewer blocks are not asked for their order.
const SAMPLED: usize = 8;

/// The body of a loop that finds the keys of a task's elements.
type Keys<'a, S> = &'a (dyn Fn(Task<'_, S>, &mut Sink) + Sync);

/// Where the elements of a loop update, before they do.
#[doc(hidden)]
pub struct Key<'a, S> {
    pub(crate) place: Place,
    pub(crate) keys: Keys<'a, S>,
}

/// What keys are indices of, and what is updated around them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// The field that keys are indices of.
    slot: usize,
    reach: ([i64; MAX_AXES], [i64; MAX_AXES]),
    /// Whether all updates are known to lie within the reach.
    pub(crate) certain: bool,
}

impl<S> core::fmt::Debug for Key<'_, S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Key of {:?}", self.place)
    }
}

/// The keys of a loop are indices of a slot's field; updates lie from `low` to `high` around them, with `N` = 1 along every axis.
#[doc(hidden)]
pub fn key<'a, const N: usize, S: Space>(
    _: &S,
    slot: usize,
    low: [i64; N],
    high: [i64; N],
    certain: bool,
    keys: Keys<'a, S>,
) -> Key<'a, S> {
    let wide =
        |offsets: [i64; N]| core::array::from_fn(|a| if N == 1 { offsets[0] } else { *offsets.get(a).unwrap_or(&0) });
    Key { place: Place { slot, reach: (wide(low), wide(high)), certain }, keys }
}

impl Place {
    /// Whether a loop can be sorted by keys of its field, whatever the keys are.
    pub(crate) fn is_possible(&self, bounds: &Bounds, targets: &[&dyn Scattered]) -> bool {
        let rank = targets[self.slot].rank();
        rank > 0 && targets.iter().all(|t| t.rank() == rank) && u32::try_from(bounds.elements).is_ok()
    }

    /// Among how many cells a loop of so many blocks accumulates, if neighbouring elements do far from each other, as some of the blocks tell.
    pub(crate) fn scattered_over(
        &self,
        bounds: &Bounds,
        targets: &[&dyn Scattered],
        blocks: usize,
        keys: &(dyn Fn(usize, &mut Sink) + Sync),
    ) -> Option<usize> {
        if blocks < SAMPLED {
            return None;
        }
        let asked = [1, 3, 5, 7].map(|n| blocks * n / 8);
        let keys = |n: usize, sink: &mut Sink| keys(asked[n], sink);
        let tiles = self.tiles(bounds, targets, 1, asked.len(), &keys);
        let mut sink = Sink::new(bounds, &tiles, Wanted::Pieces);
        (0..asked.len()).for_each(|n| keys(n, &mut sink));
        let rank = targets[self.slot].rank();
        sink.is_scattered().then(|| cells_around(bounds, &tiles, rank, asked.len(), &keys))?
    }

    /// The tiles for a loop of so many blocks, whose keys `keys` finds.
    fn tiles(
        &self,
        bounds: &Bounds,
        targets: &[&dyn Scattered],
        threads: usize,
        blocks: usize,
        keys: &(dyn Fn(usize, &mut Sink) + Sync),
    ) -> Tiles {
        let (target, elements) = (targets[self.slot], bounds.elements);
        let cut = |span| Tiles::new(target.rank(), target.geometry(), target.block(), elements, self.reach, span);
        let tiles = cut(None);
        let roomy = target.geometry().len() / ROOMY > elements;
        if roomy { cut(span(bounds, &tiles, threads, blocks, keys)) } else { tiles }
    }

    /// Sorts a loop of so many blocks by its keys, which `keys` finds.
    pub(crate) fn sort(
        &self,
        bounds: &Bounds,
        targets: &[&dyn Scattered],
        threads: usize,
        blocks: usize,
        keys: &(dyn Fn(usize, &mut Sink) + Sync),
    ) -> Bins {
        Bins::new(bounds, &self.tiles(bounds, targets, threads, blocks, keys), threads, blocks, keys)
    }
}

impl Bins {
    /// Runs all tiles. `run` is called once with each number and what the tile may accumulate into.
    pub(crate) fn execute(
        &self,
        threads: usize,
        targets: &[&dyn Scattered],
        run: &(dyn Fn(usize, &[Share<'_>]) + Sync),
    ) {
        let mut strays = Vec::new();
        for colour in self.colours() {
            let lates = results_of_jobs(threads, colour.len(), &|n| {
                let number = colour.start + n;
                let (late, tile) = (RefCell::new(Late::default()), self.tile(number));
                let share = |target: &&dyn Scattered| {
                    let window = self.tiles().window(tile, target.geometry());
                    Share { root: target.root(), window, late: Some(&late) }
                };
                run(number, Shares::new(targets.iter().map(share)).get());
                late.into_inner()
            });
            strays.extend(lates.into_iter().filter(|late| !late.is_empty()));
        }
        for late in strays {
            // SAFETY: no tile runs any more, and the updates were kept for these targets.
            unsafe { late.apply(targets) };
        }
    }
}
