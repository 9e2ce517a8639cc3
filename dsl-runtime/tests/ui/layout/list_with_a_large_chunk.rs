//! Chunks larger than the list.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 64, chunk = 128).aos);

fn main() {}
