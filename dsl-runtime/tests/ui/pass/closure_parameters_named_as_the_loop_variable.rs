//! A closure beside the loop has names of its own.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<i32, _>) {
    let next = |p: i32| p + 1;
    for p in u {
        u[p] = next(p);
    }
    let last = |p: i32| u[p];
    assert_eq!(last(2), 3);
}

fn main() {
    let mut u = Field::<i32, Soa>::new([3]);
    fill(&mut u);
    assert_eq!(u.to_vec(), [1, 2, 3]);
}
