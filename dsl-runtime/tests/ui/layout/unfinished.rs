//! A layout ends with a word.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).);

fn main() {}
