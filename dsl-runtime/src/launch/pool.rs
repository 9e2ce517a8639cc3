//! Threads: jobs are numbers, which the calling thread and a pool's workers take in turn.

use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::OnceLock;

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::schedule::{Inside, MAX_THREADS, Schedule, inherit};

/// One pool for each number of helping threads, made when it is first used.
static POOLS: [OnceLock<ThreadPool>; MAX_THREADS] = [const { OnceLock::new() }; MAX_THREADS];

fn pool(helpers: usize) -> &'static ThreadPool {
    POOLS[helpers].get_or_init(|| {
        ThreadPoolBuilder::new()
            .num_threads(helpers)
            .thread_name(|n| format!("allotrope-{}", n + 1))
            .build()
            .unwrap_or_else(|error| panic!("cannot start {helpers} threads: {error}"))
    })
}

/// Jobs to be taken, in order.
struct Queue<'a> {
    next: AtomicUsize,
    jobs: usize,
    stopped: AtomicBool,
    job: &'a (dyn Fn(usize) + Sync),
}

/// Stops the other threads when a job panics.
struct Stop<'a>(&'a AtomicBool);
impl Drop for Stop<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.store(true, Ordering::Relaxed);
        }
    }
}

impl Queue<'_> {
    fn work(&self) {
        let _inside = Inside::enter();
        let _stop = Stop(&self.stopped);
        while !self.stopped.load(Ordering::Relaxed) {
            let job = self.next.fetch_add(1, Ordering::Relaxed);
            if job >= self.jobs {
                break;
            }
            (self.job)(job);
        }
    }
}

/// Runs `jobs` jobs on at most `threads` threads, the calling one included. A panic in a job is passed on after all
/// threads have stopped.
pub(super) fn run(threads: usize, jobs: usize, job: &(dyn Fn(usize) + Sync)) {
    let queue = Queue { next: AtomicUsize::new(0), jobs, stopped: AtomicBool::new(false), job };
    let helpers = threads.min(jobs).saturating_sub(1);
    if helpers == 0 {
        queue.work();
        return;
    }
    let schedule = Schedule::current();
    pool(helpers).in_place_scope(|scope| {
        for _ in 0..helpers {
            scope.spawn(|_| inherit(schedule, || queue.work()));
        }
        queue.work();
    });
}
