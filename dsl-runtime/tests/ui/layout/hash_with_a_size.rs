//! `hash` with a size.
use allotrope::prelude::*;

type Wrong = layout!(hash(ij, 16).dense(ij, 8).aos);

fn main() {}
