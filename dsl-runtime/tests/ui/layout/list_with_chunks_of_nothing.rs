//! Chunks of no entries.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 64, chunk = 0).aos);

fn main() {}
