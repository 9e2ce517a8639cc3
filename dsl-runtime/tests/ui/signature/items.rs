//! A kernel is a function with a body.
use allotrope::prelude::*;

#[kernel]
struct Smooth;

trait Solver {
    #[kernel]
    fn step(&self, u: &mut Field<f32, _>);
}

#[kernel(lanes = 16)]
fn later(u: &mut Field<f32, _>) {}

#[kernel(fast)]
fn unknown(u: &mut Field<f32, _>) {}

fn main() {}
