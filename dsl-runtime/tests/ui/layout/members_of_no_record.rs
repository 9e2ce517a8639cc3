//! A layout that names members says whose they are.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).place([v], [m]));

fn main() {}
