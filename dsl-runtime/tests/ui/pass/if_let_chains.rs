//! Conditions bind names.
//@ edition 2024
use allotrope::prelude::*;

#[kernel]
fn pick(u: &mut Field<i32, _>, near: &[Option<i32>]) {
    for p in u {
        if let Some(q) = near[p as usize]
            && q > 1
            && let Some(r) = near.get(q as usize)
        {
            u[p] = q + r.unwrap_or(10);
        } else if let Some(q) = near[p as usize] {
            u[p] = -q;
        }
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([3]);
    pick(&mut u, &[Some(2), Some(1), None]);
    assert_eq!(u.to_vec(), [12, -1, 0]);
}
