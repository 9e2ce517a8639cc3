//! A wrong address is not to be had in safe code (H21).
use allotrope::prelude::*;

struct Mine;

impl Layout<I> for Mine {} //~ E0046 E0277

fn main() {}
