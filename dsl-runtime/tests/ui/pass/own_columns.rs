//! An iteration owns its column, and may use all of it.
use allotrope::prelude::*;

#[kernel]
fn flip(u: &mut Field<i32, _, Ij>, n: i32, m: i32) {
    for j in 0..m {
        for k in 0..n / 2 {
            let above = u[(k, j)];
            u[(k, j)] = u[(n - 1 - k, j)];
            u[(n - 1 - k, j)] = above;
        }
    }
}

fn main() {
    let mut u = Field::<i32, Blocked<4>>::new([3, 2]);
    (0..3).for_each(|i| (0..2).for_each(|j| u.set([i, j], i as i32)));
    flip(&mut u, 3, 2);
    assert_eq!(u.to_vec(), [2, 2, 1, 1, 0, 0]);
}
