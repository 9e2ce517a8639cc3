//! `Private`: every job but the first accumulates into a copy of its own; the copies are combined in the order of jobs.

use super::share::Share;
use super::{Scattered, Shares};
use crate::field::Storage;
use crate::launch::run_jobs;

/// Runs blocks in `jobs` jobs of neighbouring blocks each, then combines. Which blocks a job has, and the order of
/// combination, depend on the numbers alone: the result is the same for any number of threads.
pub(super) fn execute(
    threads: usize,
    jobs: usize,
    targets: &[&dyn Scattered],
    blocks: usize,
    block: &(dyn Fn(usize, &[Share<'_>]) + Sync),
) {
    // Copies of a launch that panics are dropped with it: they hold half of a sum.
    let copies: Vec<Vec<Storage>> = targets.iter().map(|t| (1..jobs).map(|_| t.borrow_copy()).collect()).collect();
    run_jobs(threads, jobs, &|job| {
        let shares = match job {
            0 => Shares::of_fields(targets),
            _ => {
                let own = targets.iter().zip(&copies);
                Shares::new(own.map(|(target, copies)| Share::whole(*target, copies[job - 1].start())))
            }
        };
        for b in blocks * job / jobs..blocks * (job + 1) / jobs {
            block(b, shares.get());
        }
    });
    for (target, copies) in targets.iter().zip(copies) {
        run_jobs(threads, target.parts(), &|part| {
            for copy in &copies {
                // SAFETY: no job accumulates any more; each part of the field and of the copies is taken by one job.
                unsafe { target.combine(copy, part) };
            }
        });
        for mut copy in copies {
            target.combine_blocks(&mut copy, threads);
            target.give_back(copy);
        }
    }
}
