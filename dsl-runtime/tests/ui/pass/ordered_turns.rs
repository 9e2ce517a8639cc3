//! The body of an `#[ordered]` loop is top level.
use allotrope::prelude::*;

#[kernel]
fn steps(u: &mut Field<i32, _>, v: &mut Field<i32, _>, n: usize) -> i32 {
    let mut sum = 0;
    #[ordered]
    for t in (0..n).rev() {
        for p in v {
            v[p] = u.clamped(p + 1) + t as i32;
        }
        for p in u {
            u[p] = v[p];
            sum += v[p];
        }
        u[0] = 0;
        if sum > 1000 {
            break;
        }
    }
    sum
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([3]), Field::<i32, Soa>::new([3]));
    u.fill(1);
    assert_eq!(steps(&mut u, &mut v, 2), 12);
    assert_eq!(u.to_vec(), [0, 2, 2]);
}
