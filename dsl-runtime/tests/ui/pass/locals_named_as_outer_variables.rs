//! A variable of the loop may hide one from outside that the loop does not accumulate.
use allotrope::prelude::*;

#[kernel]
fn hide(u: &mut Field<i32, _>, n: i32) -> i32 {
    let mut s = 10;
    let x = 3;
    for p in u {
        let before = s;
        let mut s = n + before;
        s += x;
        let x = s * 2;
        s -= 1;
        for n in 0..2 {
            s += n;
        }
        u[p] = s + x;
    }
    s += 1;
    s
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    assert_eq!(hide(&mut u, 1), 11);
    assert_eq!(u.to_vec(), [14 + 28, 14 + 28]);
}
