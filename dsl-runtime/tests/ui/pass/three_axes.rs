//! Three variables, in tuples and as one.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<i32, _, Ijk>, planes: &mut Field<i32, _>, n: i32) {
    for (i, j, k) in u {
        u[(i, j, k)] = 100 * i + 10 * j + k;
    }
    for ijk in u.interior(1) {
        u[ijk] = -u[ijk];
    }
    for i in 0..n {
        for (j, k) in ndrange!(0..n, 0..n) {
            planes[i] += u[(i, j, k)];
            u[(i, j, k)] = u[(i, k, j)];
        }
    }
}

fn main() {
    let (mut u, mut planes) = (Field::<i32, Blocked<2>>::new([3, 3, 3]), Field::<i32, Soa>::new([3]));
    fill(&mut u, &mut planes, 3);
    assert_eq!(planes.to_vec(), [99, 999 - 222, 1899]);
    assert_eq!(u.get([2, 0, 1]), 210);
}
