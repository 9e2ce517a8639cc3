//! Fields follow Rust's borrowing.
use allotrope::prelude::*;

fn reset(u: &Field<f32, Soa>) {
    u.fill(0.0); //~ E0596
}

fn main() {}
