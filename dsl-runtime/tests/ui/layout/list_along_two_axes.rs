//! A list along two axes.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(jk, 64).aos);

fn main() {}
