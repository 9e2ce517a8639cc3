//! Threads: jobs are numbers, which the calling thread and a pool's workers take in turn.

#[cfg(not(allotrope_joined_threads))]
use std::sync::OnceLock;

#[cfg(not(allotrope_joined_threads))]
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::queue::Queue;
use crate::schedule::{Inside, Schedule, inherit};

/// One pool for each number of helping threads, made when it is first used.
#[cfg(not(allotrope_joined_threads))]
static POOLS: [OnceLock<ThreadPool>; crate::MAX_THREADS] = [const { OnceLock::new() }; crate::MAX_THREADS];

#[cfg(not(allotrope_joined_threads))]
fn pool(helpers: usize) -> &'static ThreadPool {
    POOLS[helpers].get_or_init(|| {
        ThreadPoolBuilder::new()
            .num_threads(helpers)
            .thread_name(|n| format!("allotrope-{}", n + 1))
            .build()
            .unwrap_or_else(|error| panic!("cannot start {helpers} threads: {error}"))
    })
}

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
    help(helpers, &work);
}

/// Works with so many threads of a pool, and returns when all have stopped.
#[cfg(not(allotrope_joined_threads))]
fn help(helpers: usize, work: &Work<'_>) {
    let schedule = Schedule::current();
    pool(helpers).in_place_scope(|scope| {
        for _ in 0..helpers {
            scope.spawn(|_| inherit(schedule, || work.run()));
        }
        work.run();
    });
}

/// The same with threads of the launch's own, which are joined. This is for the thread sanitizer: it sees what a join orders, but not
/// how a pool's threads sleep and wake, as the standard library is not instrumented.
#[cfg(allotrope_joined_threads)]
fn help(helpers: usize, work: &Work<'_>) {
    use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
    let schedule = Schedule::current();
    let results: Vec<std::thread::Result<()>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..helpers).map(|_| scope.spawn(|| inherit(schedule, || work.run()))).collect();
        let own = catch_unwind(AssertUnwindSafe(|| work.run()));
        std::iter::once(own).chain(threads.into_iter().map(|thread| thread.join())).collect()
    });
    if let Some(panic) = results.into_iter().find_map(Result::err) {
        resume_unwind(panic);
    }
}
