//! Blocks that several threads make, lists that several append to and a hash that grows, under every order in which threads could do
//! so, and everything that memory may show them meanwhile.

/// As in the library.
mod axes {
    pub(crate) const MAX_AXES: usize = 4;
}

/// What slots, lists and the hash are made of, here as loom models it.
mod sync {
    pub(crate) use loom::sync::Mutex;
    use loom::sync::MutexGuard;
    pub(crate) use loom::sync::atomic::{AtomicPtr, AtomicU32, AtomicUsize, Ordering};

    pub(crate) const SHARDS: usize = 1;
    pub(crate) const FIRST: usize = 2;

    pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
        mutex.lock().expect("no thread has panicked")
    }

    pub(crate) fn pause() {
        loom::thread::yield_now();
    }

    /// A value of which loom tells where one thread reads it while another writes.
    #[derive(Debug)]
    pub(crate) struct Shared<T>(loom::cell::UnsafeCell<T>);

    impl<T: Copy> Shared<T> {
        pub(crate) fn new(value: T) -> Self {
            Self(loom::cell::UnsafeCell::new(value))
        }
        pub(crate) unsafe fn get(&self) -> T {
            // SAFETY: as the caller promises, which loom checks.
            self.0.with(|value| unsafe { *value })
        }
        pub(crate) unsafe fn set(&self, value: T) {
            // SAFETY: as above.
            self.0.with_mut(|old| unsafe { *old = value });
        }
    }
}

#[path = "../src/store/hash.rs"]
#[allow(dead_code, clippy::modulo_one, reason = "the rest is for one thread")]
mod hash;
#[path = "../src/store/list.rs"]
#[allow(dead_code, unreachable_pub, reason = "the rest is for one thread, or for the library's layouts")]
mod list;
#[path = "../src/store/slot.rs"]
#[allow(dead_code, reason = "the rest is for one thread")]
mod slot;

use hash::Hash;
use list::Head;
use loom::sync::Arc;
use loom::thread;
use slot::Slot;
use sync::Shared;

/// A block, whose contents are written before it is put.
fn block(content: u32) -> *mut u8 {
    Box::into_raw(Box::new(Shared::new(content))).cast()
}

/// What a block holds.
fn content(block: *mut u8) -> u32 {
    // SAFETY: made by `block`, and freed when all threads are joined.
    unsafe { (*block.cast::<Shared<u32>>()).get() }
}

fn free(block: *mut u8) {
    // SAFETY: made by `block`, and nobody's any more.
    drop(unsafe { Box::from_raw(block.cast::<Shared<u32>>()) });
}

#[test]
fn a_block_is_made_once_and_seen_whole() {
    loom::model(|| {
        let slot = Arc::new(Slot::empty());
        let threads: Vec<_> = (1..3)
            .map(|n| {
                let slot = Arc::clone(&slot);
                thread::spawn(move || {
                    let made = slot.get_or_make(|| block(n));
                    let held = content(made);
                    assert!(held == 1 || held == 2);
                    (made.addr(), held)
                })
            })
            .collect();
        // Whoever only looks sees nothing, or all of it.
        let seen = slot.get();
        if !seen.is_null() {
            assert!(content(seen) > 0);
        }
        let made: Vec<_> = threads.into_iter().map(|thread| thread.join().expect("no panic")).collect();
        assert_eq!(made[0], made[1], "one block for both");
        free(slot.take());
    });
}

#[test]
fn places_of_a_list_are_taken_once_and_no_more_than_there_are() {
    loom::model(|| {
        let head = Arc::new(Head::empty());
        let threads: Vec<_> = (0..2)
            .map(|_| {
                let head = Arc::clone(&head);
                thread::spawn(move || [head.reserve(3), head.reserve(3)])
            })
            .collect();
        assert!(head.len(3) <= 3);
        let mut places: Vec<usize> =
            threads.into_iter().flat_map(|thread| thread.join().expect("no panic")).flatten().collect();
        places.sort_unstable();
        assert_eq!(places, [0, 1, 2]);
        assert_eq!(head.len(3), 3);
    });
}

#[test]
fn a_hash_grows_under_those_who_look_things_up() {
    loom::model(|| {
        let hash = Arc::new(Hash::new());
        let first = hash.get_or_make(&[7, 0, 0, 0], || block(7));
        let writer = {
            let hash = Arc::clone(&hash);
            thread::spawn(move || {
                // The table has two cells, and is never more than half full.
                assert_eq!(content(hash.get_or_make(&[8, 0, 0, 0], || block(8))), 8);
            })
        };
        let maker = {
            let hash = Arc::clone(&hash);
            thread::spawn(move || content(hash.get_or_make(&[8, 0, 0, 0], || block(8))))
        };
        assert_eq!(hash.get(&[7, 0, 0, 0]), first, "what is there stays there");
        let seen = hash.get(&[8, 0, 0, 0]);
        assert!(seen.is_null() || content(seen) == 8);
        writer.join().expect("no panic");
        assert_eq!(maker.join().expect("no panic"), 8);
        let mut all = Vec::new();
        hash.each(|key, block| all.push((key[0], content(block))));
        all.sort_unstable();
        assert_eq!(all, [(7, 7), (8, 8)]);
        hash.each(|_, block| free(block));
    });
}
