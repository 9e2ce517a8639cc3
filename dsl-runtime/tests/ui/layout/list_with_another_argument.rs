//! A named argument that `dynamic` does not have.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 64, block = 8).aos);

fn main() {}
