//! A function takes a field to read by value.
use allotrope::prelude::*;

#[func]
fn bilinear(q: Read<f32, _>, x: f32) -> f32 {
    q[0] * x
}

#[kernel]
fn wrong(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for p in v {
        v[p] = bilinear(&u, 0.5);
    }
}

fn main() {}
