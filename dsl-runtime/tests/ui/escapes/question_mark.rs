//! No iteration ends the kernel.
use allotrope::prelude::*;

#[kernel]
fn check(u: &mut Field<f32, _>, names: &[&str]) -> Option<usize> {
    for p in u {
        u[p] = names.first()?.len() as f32;
    }
    None
}

fn main() {}
