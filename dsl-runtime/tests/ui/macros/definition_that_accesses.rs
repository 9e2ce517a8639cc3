//! A macro could hide an access.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        macro_rules! put {
            ($at:expr) => {
                u[$at] = 1.0
            };
        }
        put!(0);
    }
}

fn main() {}
