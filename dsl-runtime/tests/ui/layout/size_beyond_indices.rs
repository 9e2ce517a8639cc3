//! Indices are `i32`.
use allotrope::prelude::*;

type Line = layout!(dense(i, 2_147_483_648).aos);

fn main() {}
