//! A kernel runs to its end.
use allotrope::prelude::*;

#[kernel]
async fn wait(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
