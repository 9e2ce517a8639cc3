//! A layout has a node and a place.
use allotrope::prelude::*;

type Grid = layout!();

fn main() {}
