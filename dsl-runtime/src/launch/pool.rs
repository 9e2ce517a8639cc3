//! Threads: jobs are numbers, which the calling thread and a team's helpers take in turn.

#[cfg(not(allotrope_joined_threads))]
mod team;

use super::queue::Queue;
use crate::schedule::{Inside, Schedule};

/// Jobs, and what is done for each.
struct Work<'a> {
    queue: Queue,
    job: &'a (dyn Fn(usize) + Sync),
}

/// Stops the other threads when a job panics.
struct Stop<'a>(&'a Queue);
impl Drop for Stop<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.stop();
        }
    }
}

impl Work<'_> {
    fn run(&self) {
        let _inside = Inside::enter();
        let _stop = Stop(&self.queue);
        while let Some(job) = self.queue.take() {
            (self.job)(job);
        }
    }
}

/// Runs `jobs` jobs on at most `threads` threads, the calling one included. A panic in a job is passed on after all
/// threads have stopped.
pub(super) fn run(threads: usize, jobs: usize, job: &(dyn Fn(usize) + Sync)) {
    let work = Work { queue: Queue::new(jobs), job };
    let helpers = threads.min(jobs).saturating_sub(1);
    if helpers == 0 {
        work.run();
        return;
    }
    #[cfg(not(allotrope_joined_threads))]
    team::help(helpers, &work, Schedule::current());
    #[cfg(allotrope_joined_threads)]
    help(helpers, &work, Schedule::current());
}

/// Works with so many threads of the launch's own, which are joined, and returns when all have stopped. This is for the thread sanitizer: it
/// sees what a join orders, but not how a pool's threads sleep and wake, as the standard library is not instrumented.
#[cfg(allotrope_joined_threads)]
fn help(helpers: usize, work: &Work<'_>, schedule: Schedule) {
    use crate::schedule::inherit;
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
    let results: Vec<std::thread::Result<()>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..helpers).map(|_| scope.spawn(|| inherit(schedule, || work.run()))).collect();
        let own = catch_unwind(AssertUnwindSafe(|| work.run()));
        std::iter::once(own).chain(threads.into_iter().map(|thread| thread.join())).collect()
    });
    if let Some(panic) = results.into_iter().find_map(Result::err) {
        resume_unwind(panic);
    }
}
