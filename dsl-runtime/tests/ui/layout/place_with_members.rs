//! Members are named by `place` alone.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).soa(v, m));

fn main() {}
