//! A helper's post under every order in which launch and helper could come to it, and everything that memory may show them meanwhile.

/// What the post is made of, here as loom models it.
mod sync {
    pub(crate) use loom::sync::atomic::{AtomicPtr, Ordering};
}

#[path = "../src/launch/post.rs"]
mod post;

use loom::cell::UnsafeCell;
use loom::sync::Arc;
use loom::thread;
use post::Post;

/// What an order asks for, and what came of it.
struct Order {
    asked: UnsafeCell<usize>,
    answer: UnsafeCell<usize>,
}

/// A post and the orders that are put there.
struct Place {
    post: Post,
    orders: [Order; 2],
}

// SAFETY: an order's cells are the launch's until it is put and after the post is no longer busy, and the helper's between; loom reports where
// that does not hold.
unsafe impl Sync for Place {}
// SAFETY: numbers and an atomic address.
unsafe impl Send for Place {}

impl Place {
    fn new() -> Arc<Self> {
        let order = || Order { asked: UnsafeCell::new(0), answer: UnsafeCell::new(0) };
        Arc::new(Self { post: Post::new(), orders: [order(), order()] })
    }

    fn address(&self, n: usize) -> *mut () {
        core::ptr::from_ref(&self.orders[n]).cast_mut().cast()
    }

    /// A helper that looks so often whether there is an order, and leaves when there is none.
    fn serve(&self, looks: usize) {
        let mut looked = 0;
        loop {
            if let Some(order) = self.post.take() {
                // SAFETY: one of the orders of this place.
                let order = unsafe { &*order.cast::<Order>() };
                // SAFETY: as for `Sync`.
                let asked = order.asked.with(|asked| unsafe { *asked });
                // SAFETY: as above.
                order.answer.with_mut(|answer| unsafe { *answer += 10 * asked });
                self.post.finish();
            } else if looked >= looks && self.post.leave() {
                return;
            }
            looked += 1;
            thread::yield_now();
        }
    }
}

/// Puts an order, with a new helper if one has to be called, and looks what has come of it when nobody has it any more.
fn launch(place: &Arc<Place>, n: usize, helpers: &mut Vec<thread::JoinHandle<()>>) {
    // SAFETY: as for `Sync`.
    place.orders[n].asked.with_mut(|asked| unsafe { *asked = n + 1 });
    if place.post.put(place.address(n)) {
        let helper = Arc::clone(place);
        helpers.push(thread::spawn(move || helper.serve(1)));
    }
    let withdrawn = place.post.withdraw(place.address(n));
    while !withdrawn && place.post.is_busy() {
        thread::yield_now();
    }
    // SAFETY: as above.
    let answer = place.orders[n].answer.with(|answer| unsafe { *answer });
    assert_eq!(answer, if withdrawn { 0 } else { 10 * (n + 1) }, "order {n}, withdrawn: {withdrawn}");
}

#[test]
fn an_order_is_withdrawn_or_carried_out_once() {
    loom::model(|| {
        let (place, mut helpers) = (Place::new(), Vec::new());
        launch(&place, 0, &mut helpers);
        helpers.into_iter().for_each(|helper| helper.join().expect("no panic"));
    });
}

#[test]
fn a_helper_stays_for_the_next_order_or_another_is_called() {
    let mut model = loom::model::Builder::new();
    model.preemption_bound = Some(3);
    model.check(|| {
        let (place, mut helpers) = (Place::new(), Vec::new());
        launch(&place, 0, &mut helpers);
        launch(&place, 1, &mut helpers);
        helpers.into_iter().for_each(|helper| helper.join().expect("no panic"));
    });
}
