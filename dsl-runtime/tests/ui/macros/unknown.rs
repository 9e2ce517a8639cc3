//! Macros that the kernel does not know get no loop variable, field or reduction.
use allotrope::prelude::*;

macro_rules! skip {
    ($name:ident) => {
        let $name = 0;
    };
}

macro_rules! show {
    ($($any:tt)*) => {};
}

#[kernel]
fn wrong(u: &mut Field<f32, _>) -> f32 {
    let mut total = 0.0;
    for p in u {
        skip!(p);
        show!("{total}");
        total += 1.0;
        macro_rules! put {
            ($at:expr) => {
                u[$at] = 1.0
            };
        }
    }
    total
}

fn main() {}
