//! A word that the language has and this version has not.
use allotrope::prelude::*;

type Wrong = layout!(dense(ij).bitmasked(ij, 8).soa);

fn main() {}
