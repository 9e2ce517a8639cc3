//! What threads cannot share may enter a serial loop.
use allotrope::prelude::*;
use std::cell::Cell;

#[kernel]
fn on_one_thread(u: &mut Field<i32, _>, count: &Cell<i32>) {
    #[serial]
    for p in u {
        count.set(count.get() + 1);
        u[p] = count.get();
    }
}

fn main() {
    let (mut u, count) = (Field::<i32, Soa>::new([3]), Cell::new(0));
    on_one_thread(&mut u, &count);
    assert_eq!((u.to_vec(), count.get()), (vec![1, 2, 3], 3));
}
