//! A macro could hide an access; its value is bound first.
use allotrope::prelude::*;

macro_rules! square {
    ($x:expr) => {
        $x * $x
    };
}

#[kernel]
fn fill(u: &mut Field<f32, _>) {
    for p in u {
        let y = square!(u[p]);
    }
}

fn main() {}
