//! No iteration ends the kernel, and known macros are read as expressions.
use allotrope::prelude::*;

#[kernel]
fn check(u: &mut Field<f32, _>, names: &[&str]) -> Option<usize> {
    for p in u {
        println!("{}", names.first()?);
        u[p] = 1.0;
    }
    None
}

fn main() {}
