//! Work on a field's records part by part, in parallel. Parts follow from the number of records alone, never from the
//! threads, so that whatever is combined part after part has the same bits for any number of them.

use core::ops::Range;
use std::sync::{Mutex, PoisonError};

use crate::launch::{results_of_jobs, run_jobs};
use crate::schedule::{Inside, Schedule};

/// Records that one job takes.
pub(super) const PART: usize = 1 << 15;

/// How many threads the schedule in force gives; one inside of a launch, whose threads are busy.
fn threads() -> usize {
    if Inside::now() { 1 } else { Schedule::current().thread_count() }
}

/// Works on the parts of a list. `work` is told where its part begins.
pub(super) fn in_parts<T: Send>(list: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
    let parts: Vec<Mutex<&mut [T]>> = list.chunks_mut(PART).map(Mutex::new).collect();
    run_jobs(threads(), parts.len(), &|part| {
        let mut list = parts[part].lock().unwrap_or_else(PoisonError::into_inner);
        work(part * PART, &mut list);
    });
}

/// Works on the parts of `0..len`, each once; returns their results in order.
pub(super) fn each_part<T: Send>(len: usize, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    each_part_of(PART, len, work)
}

/// The same with parts of another size.
pub(crate) fn each_part_of<T: Send>(part_len: usize, len: usize, work: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    results_of_jobs(threads(), len.div_ceil(part_len), &|part| work(part * part_len..len.min((part + 1) * part_len)))
}
