//! A range's variable is an index of its own type.
use allotrope::prelude::*;

#[kernel]
fn ranges(u: &mut Field<u64, _>, n: usize, m: u64, l: i64) {
    for i in 0..n {
        u[i] = i as u64;
    }
    for i in 1..m {
        u[i] += i;
    }
    for i in (0..l - 1) {
        u[i] *= 2;
    }
    for i in 0u8..2 {
        u[i] += 100;
    }
    for i in 0..u.len() {
        u[i] += 1000;
    }
}

fn main() {
    let mut u = Field::<u64, Soa>::new([4]);
    ranges(&mut u, 4, 3, 4);
    assert_eq!(u.to_vec(), [1100, 1104, 1008, 1003]);
}
