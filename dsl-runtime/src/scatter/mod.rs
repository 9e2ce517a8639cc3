//! Scatter strategies: how the jobs of an accumulating loop share a field. A file a strategy.

mod combine;
mod private;
mod target;

pub use combine::Op;
pub use target::{Scattered, Target};

use crate::launch::{Options, run_jobs};
use crate::schedule::{Scatter, Schedule};

/// How many jobs share an accumulation that must not depend on the threads.
const FIXED_JOBS: usize = 8;

/// The most bytes that private copies may take, all together.
const MOST_PRIVATE: usize = 1 << 30;

/// From so many threads on, compare-and-swap is worth its cost of 8 to 10 plain updates.
const MANY_THREADS: usize = 10;

/// What was decided for a launch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    threads: usize,
    /// How many jobs have private copies; 1 if none.
    jobs: usize,
    /// Whether updates are compare-and-swap.
    pub(crate) atomic: bool,
}

/// Decides how a launch runs.
///
/// # Panics
/// Where `Atomic` is asked for under `deterministic`.
pub(crate) fn plan(options: &Options<'_>, schedule: &Schedule, threads: usize, elements: usize, blocks: usize) -> Plan {
    let serial = Plan { threads: 1, jobs: 1, atomic: false };
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
    let private = Plan { threads, jobs, atomic: false };
    // A component that lies at no multiple of its size cannot be updated atomically.
    let aligned = options.targets.iter().all(|t| t.aligned());
    let atomic = if aligned { Plan { threads: threads.min(blocks), jobs: 1, atomic: threads > 1 } } else { serial };
    match asked {
        Scatter::Serial => serial,
        Scatter::Private => private,
        Scatter::Atomic => atomic,
        Scatter::Auto => {
            // Copying and combining costs a few operations a cell, an element of the loop some tens.
            let cells: usize = options.targets.iter().map(|t| t.cells()).sum();
            let worth = elements.saturating_mul(16) > cells.saturating_mul(jobs - 1);
            let alone = threads == 1 && !schedule.deterministic;
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

/// Runs all blocks as planned. `block` is called once with each number and the roots that its job accumulates in.
pub(crate) fn execute(
    plan: &Plan,
    targets: &[&dyn Scattered],
    blocks: usize,
    block: &(dyn Fn(usize, &[*mut u8]) + Sync),
) {
    if plan.jobs > 1 {
        private::execute(plan.threads, plan.jobs, targets, blocks, block);
        return;
    }
    let roots = Roots::fields(targets);
    run_jobs(plan.threads, blocks, &|b| block(b, roots.get()));
}

/// The most fields that one loop accumulates into.
const MOST_TARGETS: usize = 16;

/// Where a job accumulates, by slot.
#[derive(Clone, Copy)]
struct Roots {
    roots: [*mut u8; MOST_TARGETS],
    count: usize,
}

// SAFETY: addresses alone; what may be done with them is settled by the strategy that hands them out.
unsafe impl Send for Roots {}
// SAFETY: as above.
unsafe impl Sync for Roots {}

impl Roots {
    /// The fields themselves.
    fn fields(targets: &[&dyn Scattered]) -> Self {
        Self::from(targets.iter().map(|t| t.root()))
    }

    fn from(list: impl Iterator<Item = *mut u8>) -> Self {
        let mut this = Self { roots: [core::ptr::null_mut(); MOST_TARGETS], count: 0 };
        for root in list {
            assert!(this.count < MOST_TARGETS, "one loop accumulates into at most {MOST_TARGETS} fields");
            this.roots[this.count] = root;
            this.count += 1;
        }
        this
    }

    fn get(&self) -> &[*mut u8] {
        &self.roots[..self.count]
    }
}
