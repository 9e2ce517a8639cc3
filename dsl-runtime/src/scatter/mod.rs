//! Scatter strategies: how the jobs of an accumulating loop share a field. A file a strategy.

mod bins;
mod colored;
mod combine;
mod late;
mod private;
mod share;
mod target;
mod tiles;

pub(crate) use bins::{Bounds, PackedPiece, Piece};
pub use bins::{Coordinates, Sink};
pub(crate) use colored::Place;
pub use colored::{Key, key};
pub use combine::Op;
pub(crate) use late::Late;
pub(crate) use share::{Share, Window};
pub use target::{Scattered, Target};

use crate::launch::{Options, run_jobs};
use crate::schedule::{Scatter, Schedule};

/// How many jobs share an accumulation that must not depend on the threads.
const FIXED_JOBS: usize = 8;

/// The most bytes that private copies may take, all together.
const MOST_PRIVATE: usize = 1 << 30;

/// From so many threads on, compare-and-swap is worth its cost of 8 to 10 plain updates.
const MANY_THREADS: usize = 10;

/// Bytes that caches hold.
const CACHED: usize = 4 << 20;

/// What was decided for a launch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) threads: usize,
    /// How many jobs have private copies; 1 if none.
    jobs: usize,
    /// Whether updates are compare-and-swap.
    pub(crate) atomic: bool,
    /// Whether the loop goes by tiles in colours, if it can be sorted so.
    pub(crate) colored: bool,
}

/// A loop that can be sorted by where it accumulates.
#[derive(Clone, Copy)]
pub(crate) struct Tiled<'a> {
    /// Whether all of its updates are known to lie around there.
    pub(crate) certain: bool,
    /// Among how many cells elements accumulate, where neighbouring ones do far from each other.
    pub(crate) scattered: &'a dyn Fn() -> Option<usize>,
}

/// Decides how a launch runs.
///
/// # Panics
/// Where `Atomic` is asked for under `deterministic`.
pub(crate) fn plan(
    options: &Options<'_>,
    schedule: &Schedule,
    threads: usize,
    elements: usize,
    blocks: usize,
    tiles: Option<Tiled<'_>>,
) -> Plan {
    let serial = Plan { threads: 1, jobs: 1, atomic: false, colored: false };
    if options.targets.is_empty() {
        return Plan { threads: threads.min(blocks), ..serial };
    }
    let asked = options.scatter.unwrap_or(schedule.scatter);
    assert!(
        !(schedule.deterministic && asked == Scatter::Atomic),
        "kernel `{}`: `Scatter::Atomic` adds in no fixed order, which `deterministic` forbids; use `Private` or `Serial`",
        options.kernel
    );
    let jobs = if schedule.deterministic { FIXED_JOBS } else { threads }.min(blocks);
    let copies = |jobs: usize| (jobs - 1).saturating_mul(options.targets.iter().map(|t| t.bytes()).sum());
    let private = Plan { threads, jobs, atomic: false, colored: false };
    // A component that lies at no multiple of its size cannot be updated atomically.
    let aligned = options.targets.iter().all(|t| t.aligned());
    let atomic = if aligned {
        Plan { threads: threads.min(blocks), jobs: 1, atomic: threads > 1, colored: false }
    } else {
        serial
    };
    let colored = Plan { threads, jobs: 1, atomic: false, colored: true };
    match asked {
        Scatter::Serial => serial,
        Scatter::Colored if tiles.is_some() => colored,
        Scatter::Colored => private,
        Scatter::Private => private,
        Scatter::Atomic => atomic,
        Scatter::Auto => {
            let alone = threads == 1 && !schedule.deterministic;
            if tiles.is_some_and(|tiled| suits_tiles(options.targets, tiled, elements, if alone { 1 } else { jobs })) {
                return colored;
            }
            // Copying and combining costs a few operations a cell, an element of the loop some tens.
            let cells: usize = options.targets.iter().map(|t| t.cells()).sum();
            let worth = elements.saturating_mul(16) > cells.saturating_mul(jobs - 1);
            if alone || jobs == 1 || !worth {
                serial
            } else if copies(jobs) <= MOST_PRIVATE || schedule.deterministic {
                private
            } else if threads < MANY_THREADS {
                serial
            } else {
                atomic
            }
        }
    }
}

/// Whether tiles cost less than so many copies, or for one than plain updates, as far as it is known before they are sorted.
///
/// To find and sort keys costs about twice as much an element as to combine a copy does a cell, when neighbouring elements go together. When
/// they do not, what they update is best visited tile by tile, unless it lies in the caches anyway: of one thread, which has them for itself, more does.
fn suits_tiles(targets: &[&dyn Scattered], tiled: Tiled<'_>, elements: usize, jobs: usize) -> bool {
    let sum = |of: fn(&&dyn Scattered) -> usize| targets.iter().map(of).fold(0, usize::saturating_add);
    let (cells, bytes) = (sum(|t| t.cells()), sum(|t| t.bytes()));
    let cached = if jobs > 1 { CACHED } else { 4 * CACHED };
    // Small copies lie in a core's own caches, and are combined in no time.
    let together = jobs > 1 && bytes > CACHED / 4 && elements.saturating_mul(2) < cells.saturating_mul(jobs - 1);
    if !tiled.certain || !together && bytes <= cached {
        return false;
    }
    match (tiled.scattered)() {
        Some(around) => bytes as f64 * (around as f64 / cells as f64).min(1.0) > cached as f64,
        None => together,
    }
}

/// Runs all blocks as planned. `block` is called once with each number and what its job accumulates into.
pub(crate) fn execute(
    plan: &Plan,
    targets: &[&dyn Scattered],
    blocks: usize,
    block: &(dyn Fn(usize, &[Share<'_>]) + Sync),
) {
    if plan.jobs > 1 {
        private::execute(plan.threads, plan.jobs, targets, blocks, block);
        return;
    }
    run_jobs(plan.threads, blocks, &|b| block(b, Shares::of_fields(targets).get()));
}

/// The most fields that one loop accumulates into.
const MOST_TARGETS: usize = 16;

/// What a job accumulates into, by slot.
struct Shares<'t> {
    shares: [Share<'t>; MOST_TARGETS],
    count: usize,
}

impl<'t> Shares<'t> {
    fn new(list: impl Iterator<Item = Share<'t>>) -> Self {
        let mut this = Self { shares: [Share::NOTHING; MOST_TARGETS], count: 0 };
        for share in list {
            assert!(this.count < MOST_TARGETS, "one loop accumulates into at most {MOST_TARGETS} fields");
            this.shares[this.count] = share;
            this.count += 1;
        }
        this
    }

    /// The fields themselves, all of each.
    fn of_fields(targets: &[&dyn Scattered]) -> Self {
        Self::new(targets.iter().map(|target| Share::whole(*target, target.root())))
    }

    fn get(&self) -> &[Share<'t>] {
        &self.shares[..self.count]
    }
}
