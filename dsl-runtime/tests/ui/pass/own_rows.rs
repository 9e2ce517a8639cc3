//! An iteration owns its row, and may use all of it.
use allotrope::prelude::*;

#[kernel]
fn running_sums(u: &mut Field<i32, _, Ij>, n: i32, m: i32) {
    for i in 0..n {
        for k in 1..m {
            u[(i, k)] += u[(i, k - 1)];
        }
        u[(i, 0)] = u[(i, m - 1)];
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2, 4]);
    u.fill(1);
    running_sums(&mut u, 2, 4);
    assert_eq!(u.to_vec(), [4, 2, 3, 4, 4, 2, 3, 4]);
}
