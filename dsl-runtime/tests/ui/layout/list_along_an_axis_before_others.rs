//! A list along an axis that is not the last.
use allotrope::prelude::*;

type Wrong = layout!(dense(j).dynamic(i, 64).aos);

fn main() {}
