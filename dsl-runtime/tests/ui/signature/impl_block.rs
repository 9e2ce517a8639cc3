//! A kernel is one function.
use allotrope::prelude::*;

struct Solver;

#[kernel]
impl Solver {
    fn step(&self, u: &mut Field<f32, Soa>) {}
}

fn main() {}
