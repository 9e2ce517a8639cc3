//! Each loop may reduce by another operator, and the top level reads in between.
use allotrope::prelude::*;

#[kernel]
fn several(u: &Field<i32, _>, mut start: i32) -> i32 {
    for p in u {
        start += u[p];
    }
    let seen = start;
    for p in u {
        start.max_assign(u[p] * 100 + seen);
    }
    start = start * 2;
    for p in u {
        start ^= u[p];
    }
    start
}

fn main() {
    let mut u = Field::<i32, Soa>::new([3]);
    (0..3).for_each(|i| u.set(i, i as i32));
    assert_eq!(several(&u, 10), ((200 + 13) * 2) ^ 1 ^ 2);
}
