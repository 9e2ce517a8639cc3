//! A kernel is a function.
use allotrope::prelude::*;

#[kernel]
struct Smooth;

fn main() {}
