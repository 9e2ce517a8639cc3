//! `hash` below another node.
use allotrope::prelude::*;

type Wrong = layout!(dense(ij).hash(ij).dense(ij, 8).aos);

fn main() {}
