//! No iteration waits.
use allotrope::prelude::*;

#[kernel]
fn wait(u: &mut Field<f32, _>) {
    for p in u {
        u[p] = std::future::ready(1.0).await;
    }
}

fn main() {}
