//! Named layouts are types of their own.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).Morton(8));

fn main() {}
