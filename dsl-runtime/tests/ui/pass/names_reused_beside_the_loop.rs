//! A loop variable's name is free before and after its loop.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<i32, _>) -> i32 {
    let p = 5;
    {
        let p = p + 1;
        u[0] = p;
    }
    for p in u {
        u[p] += p;
    }
    let Some(p) = Some(u[1] + p) else { return 0 };
    p
}

fn main() {
    let mut u = Field::<i32, Soa>::new([3]);
    assert_eq!(fill(&mut u), 6);
    assert_eq!(u.to_vec(), [6, 1, 2]);
}
