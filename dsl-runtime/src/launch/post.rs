//! What a launch and a thread that helps it tell each other: one order at a time.

use core::ptr;

use super::sync::{AtomicPtr, Ordering};

/// Nobody waits at the post: whoever puts an order has to call a helper.
const ABSENT: *mut () = ptr::null_mut();
/// A helper waits, or has been called.
const READY: *mut () = ptr::without_provenance_mut(1);
/// The helper works on the order that it took.
const BUSY: *mut () = ptr::without_provenance_mut(2);

/// Where one launch at a time puts orders, which are addresses above 2, and one helper takes them.
///
/// What a launch has written before it puts an order is seen by the helper that takes it; what the helper has written before it is done is
/// seen by the launch that finds the post no longer busy.
#[derive(Debug)]
pub(crate) struct Post(AtomicPtr<()>);

impl Post {
    pub(crate) fn new() -> Self {
        Self(AtomicPtr::new(ABSENT))
    }

    /// Puts an order, after the last one was withdrawn or is done. Tells whether a helper has to be called.
    pub(crate) fn put(&self, order: *mut ()) -> bool {
        loop {
            for state in [READY, ABSENT] {
                if self.0.compare_exchange(state, order, Ordering::AcqRel, Ordering::Relaxed).is_ok() {
                    return state == ABSENT;
                }
            }
        }
    }

    /// Takes an order back; tells whether it was still there. If not, the helper is busy with it, or done.
    pub(crate) fn withdraw(&self, order: *mut ()) -> bool {
        self.0.compare_exchange(order, READY, Ordering::AcqRel, Ordering::Acquire).is_ok()
    }

    /// Whether the helper works on an order.
    pub(crate) fn is_busy(&self) -> bool {
        self.0.load(Ordering::Acquire) == BUSY
    }

    /// The helper's: takes an order, if there is one.
    pub(crate) fn take(&self) -> Option<*mut ()> {
        let order = self.0.load(Ordering::Relaxed);
        let taken = ![ABSENT, READY, BUSY].contains(&order)
            && self.0.compare_exchange(order, BUSY, Ordering::AcqRel, Ordering::Relaxed).is_ok();
        taken.then_some(order)
    }

    /// The helper's: is done with the order that it took.
    pub(crate) fn finish(&self) {
        self.0.store(READY, Ordering::Release);
    }

    /// The helper's: leaves the post, unless there is an order.
    pub(crate) fn leave(&self) -> bool {
        self.0.compare_exchange(READY, ABSENT, Ordering::AcqRel, Ordering::Relaxed).is_ok()
    }
}
