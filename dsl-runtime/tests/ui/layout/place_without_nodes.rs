//! A place stands after a node.
use allotrope::prelude::*;

type Grid = layout!(aos);

fn main() {}
