//! A node below `dynamic`.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 64).dense(j, 8).aos);

fn main() {}
