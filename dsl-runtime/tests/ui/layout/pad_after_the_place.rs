//! A place closes the layout.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).aos.pad(64));

fn main() {}
