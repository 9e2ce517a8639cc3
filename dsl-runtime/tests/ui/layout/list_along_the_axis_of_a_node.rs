//! A list along the axis of another node.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(i, 64).aos);

fn main() {}
