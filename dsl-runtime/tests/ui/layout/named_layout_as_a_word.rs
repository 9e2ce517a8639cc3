//! Named layouts are types of their own.
use allotrope::prelude::*;

type Line = layout!(AoSoA(16));

fn main() {}
