//! Jobs, which are numbers, taken by threads in turn.

use super::sync::{AtomicBool, AtomicUsize, Ordering};

/// Jobs to be taken, in order, each once.
///
/// Nothing is handed over by it but numbers: what jobs have written is seen by whoever waits for their threads.
#[derive(Debug)]
pub(crate) struct Queue {
    next: AtomicUsize,
    jobs: usize,
    stopped: AtomicBool,
}

impl Queue {
    /// So many jobs, from zero on.
    pub(crate) fn new(jobs: usize) -> Self {
        Self { next: AtomicUsize::new(0), jobs, stopped: AtomicBool::new(false) }
    }

    /// The next job; none where all are taken, or after a stop.
    pub(crate) fn take(&self) -> Option<usize> {
        if self.stopped.load(Ordering::Relaxed) {
            return None;
        }
        let job = self.next.fetch_add(1, Ordering::Relaxed);
        (job < self.jobs).then_some(job)
    }

    /// Lets no thread take a job any more, once it has heard of it.
    pub(crate) fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }
}
