//! Own indices may be in another order, if all are.
use allotrope::prelude::*;

#[kernel]
fn transpose(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>) {
    for (i, j) in u {
        v[(j, i)] = u[(i, j)];
        v[(j, i)] += 1;
    }
}

fn main() {
    let mut u = Field::<i32, Aos>::new([2, 3]);
    let mut v = Field::<i32, Soa>::new([3, 2]);
    u.set([1, 2], 7);
    transpose(&u, &mut v);
    assert_eq!(v.to_vec(), [1, 1, 1, 1, 1, 8]);
}
