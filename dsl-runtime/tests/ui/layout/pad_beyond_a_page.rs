//! Padding goes up to 4096 bytes.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).pad(8192).soa);

fn main() {}
