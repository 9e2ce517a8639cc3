//! What a loop only reads may be read at any index.
use allotrope::prelude::*;

#[kernel]
fn transpose(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = u[(j, i)] - u[(i, i)] + u[(j, j)];
    }
}

fn main() {
    let mut u = Field::<i32, Aos>::new([3, 3]);
    let mut v = Field::<i32, Blocked<2>>::new([3, 3]);
    (0..3).for_each(|i| (0..3).for_each(|j| u.set([i, j], (10 * i + j) as i32)));
    transpose(&u, &mut v);
    assert_eq!(v.get([0, 2]), 20 + 22);
}
