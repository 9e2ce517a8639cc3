//! A layout has six nodes with a size at most.
use allotrope::prelude::*;

type Tower = layout!(dense(i, 2).dense(i, 2).morton(i, 2).dense(i, 2).dense(i, 2).dense(i, 2).dense(i, 2).aos);

fn main() {}
