//! The words of a layout are a chain.
use allotrope::prelude::*;

type Grid = layout!(dense(ij) * dense(ij, 8));

fn main() {}
