//! A kernel is a plain function.
use allotrope::prelude::*;

#[kernel]
async fn wait(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

#[kernel]
const fn constant(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

#[kernel]
unsafe fn promise(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

#[kernel]
extern "C" fn foreign(u: &mut Field<f32, _>) {
    u[0] = 1.0;
}

fn main() {}
