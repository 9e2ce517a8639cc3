//! `continue` skips an element, from inside an inner loop too.
use allotrope::prelude::*;

#[kernel]
fn odd(u: &mut Field<i32, _>) -> i32 {
    let mut visited = 0;
    'elements: for p in u {
        if p % 2 == 0 {
            continue;
        }
        for k in 0..p {
            if k == 2 {
                continue 'elements;
            }
            u[p] += 1;
        }
        visited += 1;
    }
    visited
}

fn main() {
    let mut u = Field::<i32, Soa>::new([6]);
    assert_eq!(odd(&mut u), 1);
    assert_eq!(u.to_vec(), [0, 1, 0, 2, 0, 2]);
}
