//! A list of more entries than an index counts.
use allotrope::prelude::*;

type Wrong = layout!(dynamic(i, 2_147_483_648).aos);

fn main() {}
