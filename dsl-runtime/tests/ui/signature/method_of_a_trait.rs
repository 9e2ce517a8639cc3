//! A kernel has a body.
use allotrope::prelude::*;

trait Solver {
    #[kernel]
    fn step(&self, u: &mut Field<f32, _>);
}

fn main() {}
