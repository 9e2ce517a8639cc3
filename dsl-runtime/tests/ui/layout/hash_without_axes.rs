//! `hash` without axes.
use allotrope::prelude::*;

type Wrong = layout!(hash.dense(ij, 8).aos);

fn main() {}
