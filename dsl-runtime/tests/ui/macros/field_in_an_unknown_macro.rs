//! A macro could hide an access.
use allotrope::prelude::*;

macro_rules! put {
    ($field:ident, $at:expr) => {
        $field[$at] = 1.0
    };
}

#[kernel]
fn fill(u: &mut Field<f32, _>, k: i32) {
    for p in u {
        put!(u, k);
    }
}

fn main() {}
