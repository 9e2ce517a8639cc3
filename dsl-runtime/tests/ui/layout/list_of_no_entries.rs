//! A list of no entries.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 0).aos);

fn main() {}
