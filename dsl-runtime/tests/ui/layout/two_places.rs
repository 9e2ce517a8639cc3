//! A layout has one place.
use allotrope::prelude::*;

type Grid = layout!(dense(ij).aos.soa);

fn main() {}
