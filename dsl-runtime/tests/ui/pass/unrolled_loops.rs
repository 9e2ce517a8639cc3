//! `unroll!` stands in any inner loop, with jumps.
use allotrope::prelude::*;

#[kernel]
fn stencil(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>) {
    for (i, j) in v.interior(1) {
        for (a, b) in unroll!(-1..2, -1..=1) {
            if a == b {
                continue;
            }
            v[(i, j)] += u[(i + a, j + b)];
        }
        for k in unroll!(0..5) {
            if k == 3 {
                break;
            }
            for l in unroll!(0..2) {
                v[(i, j)] += k * l;
            }
        }
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([3, 3]), Field::<i32, Blocked<2>>::new([3, 3]));
    u.fill(10);
    stencil(&u, &mut v);
    assert_eq!(v.get([1, 1]), 63);
}
