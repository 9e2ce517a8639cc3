//! Axes have the names `i j k l`.
use allotrope::prelude::*;

type Grid = layout!(dense(xy).aos);

fn main() {}
