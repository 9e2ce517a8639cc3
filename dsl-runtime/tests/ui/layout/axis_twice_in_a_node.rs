//! A node splits an axis once.
use allotrope::prelude::*;

type Grid = layout!(dense(iji).aos);

fn main() {}
