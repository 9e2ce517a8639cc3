//! A small lock for what is held for a few instructions.
//!
//! The standard library's would do, but for the thread sanitizer, which does not see into it: where two threads meet in one, it would
//! tell of races that are none.

use core::cell::UnsafeCell;
use core::ops::{Deref, DerefMut};
use core::sync::atomic::{AtomicBool, Ordering};

/// A value that one thread has at a time.
#[derive(Debug, Default)]
pub(crate) struct Lock<T> {
    held: AtomicBool,
    value: UnsafeCell<T>,
}

// SAFETY: whoever reaches the value through `&Lock` has the lock, which one thread has at a time.
unsafe impl<T: Send> Sync for Lock<T> {}

/// The value, until this is dropped.
#[derive(Debug)]
pub(crate) struct Held<'a, T>(&'a Lock<T>);

impl<T> Lock<T> {
    pub(crate) const fn new(value: T) -> Self {
        Self { held: AtomicBool::new(false), value: UnsafeCell::new(value) }
    }

    /// The value, as soon as no other thread has it.
    #[inline]
    pub(crate) fn lock(&self) -> Held<'_, T> {
        while self.held.compare_exchange_weak(false, true, Ordering::Acquire, Ordering::Relaxed).is_err() {
            self.wait();
        }
        Held(self)
    }

    #[cold]
    fn wait(&self) {
        // Whoever has it may need this processor to go on.
        for _ in 0..32 {
            if !self.held.load(Ordering::Relaxed) {
                return;
            }
            core::hint::spin_loop();
        }
        std::thread::yield_now();
    }

    /// The value, which nobody else can reach.
    pub(crate) fn get_mut(&mut self) -> &mut T {
        self.value.get_mut()
    }
}

impl<T> Deref for Held<'_, T> {
    type Target = T;
    fn deref(&self) -> &T {
        // SAFETY: this thread has the lock.
        unsafe { &*self.0.value.get() }
    }
}
impl<T> DerefMut for Held<'_, T> {
    fn deref_mut(&mut self) -> &mut T {
        // SAFETY: this thread has the lock.
        unsafe { &mut *self.0.value.get() }
    }
}
impl<T> Drop for Held<'_, T> {
    fn drop(&mut self) {
        self.0.held.store(false, Ordering::Release);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_thread_at_a_time() {
        let lock = Lock::new(0u64);
        std::thread::scope(|scope| {
            let threads: Vec<_> = (0..4).map(|_| scope.spawn(|| (0..10_000).for_each(|_| *lock.lock() += 1))).collect();
            // The thread sanitizer sees a thread end where it is joined, not where the scope does.
            threads.into_iter().for_each(|thread| thread.join().expect("no thread panics"));
        });
        assert_eq!(*lock.lock(), 40_000);
    }
}
