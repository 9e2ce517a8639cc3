//! The queue of jobs under every order in which threads could take them, and everything that memory may show them meanwhile.

/// What the queue is made of, here as loom models it.
mod sync {
    pub(crate) use loom::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
}

#[path = "../src/launch/queue.rs"]
mod queue;

use loom::cell::UnsafeCell;
use loom::sync::Arc;
use loom::thread;
use queue::Queue;

/// Jobs and what each has left behind.
struct Work<const JOBS: usize> {
    queue: Queue,
    done: [UnsafeCell<usize>; JOBS],
}

// SAFETY: each cell is written by the thread that has taken its job, and read when all threads are joined; loom reports where that
// does not hold.
unsafe impl<const JOBS: usize> Sync for Work<JOBS> {}
// SAFETY: numbers and atomic numbers.
unsafe impl<const JOBS: usize> Send for Work<JOBS> {}

impl<const JOBS: usize> Work<JOBS> {
    fn new() -> Arc<Self> {
        Arc::new(Self { queue: Queue::new(JOBS), done: std::array::from_fn(|_| UnsafeCell::new(0)) })
    }

    /// Does a job: two threads in one cell at a time are a fault that loom reports.
    fn run(&self, job: usize) {
        self.done[job].with_mut(|done| {
            // SAFETY: as above.
            unsafe { *done += 1 }
        });
    }

    /// How often each job was done.
    fn done(&self) -> [usize; JOBS] {
        std::array::from_fn(|job| {
            self.done[job].with(|done| {
                // SAFETY: as above.
                unsafe { *done }
            })
        })
    }
}

/// Runs `work` on so many threads besides this one, and joins them.
fn on_threads<const JOBS: usize>(helpers: usize, all: &Arc<Work<JOBS>>, work: fn(&Work<JOBS>)) {
    let threads: Vec<_> = (0..helpers)
        .map(|_| {
            let all = Arc::clone(all);
            thread::spawn(move || work(&all))
        })
        .collect();
    work(all);
    for thread in threads {
        thread.join().expect("no panic");
    }
}

#[test]
fn every_job_is_done_once() {
    fn all_of<const JOBS: usize>(helpers: usize) {
        loom::model(move || {
            let work = Work::<JOBS>::new();
            on_threads(helpers, &work, |work| {
                while let Some(job) = work.queue.take() {
                    work.run(job);
                }
            });
            assert_eq!(work.done(), [1; JOBS]);
        });
    }
    all_of::<0>(1);
    all_of::<1>(2);
    all_of::<3>(1);
    all_of::<2>(2);
}

#[test]
fn after_a_stop_no_job_is_done_twice_and_none_is_left_to_take() {
    loom::model(|| {
        let work = Work::<3>::new();
        on_threads(1, &work, |work| {
            if let Some(job) = work.queue.take() {
                work.run(job);
                work.queue.stop();
            }
        });
        assert!(work.done().iter().all(|&done| done <= 1));
        assert_eq!(work.queue.take(), None);
    });
}
