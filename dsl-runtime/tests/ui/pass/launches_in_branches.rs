//! Loops stand in `if`, `while`, `match` and blocks of the top level.
use allotrope::prelude::*;

#[kernel]
fn branches(u: &mut Field<i32, _>, n: i32) {
    if n > 0 {
        for p in u {
            u[p] += 1;
        }
    } else {
        for p in u {
            u[p] -= 1;
        }
    }
    let mut turn = 0;
    while turn < n {
        for p in u {
            u[p] *= 2;
        }
        turn += 1;
    }
    match n {
        3 => {
            for p in u {
                u[p] += 100;
            }
        }
        _ => {}
    }
    'block: {
        for p in u {
            u[p] += 1000;
        }
        if turn > 2 {
            break 'block;
        }
        u[0] = 0;
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    branches(&mut u, 3);
    assert_eq!(u.to_vec(), [1108, 1108]);
    branches(&mut u, 0);
    assert_eq!(u.to_vec(), [0, 2107]);
}
