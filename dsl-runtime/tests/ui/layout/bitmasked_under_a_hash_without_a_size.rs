//! A node below `hash` without a size.
use allotrope::prelude::*;

type Wrong = layout!(hash(ij).bitmasked(ij).aos);

fn main() {}
