//! A word that the language has and this version has not.
use allotrope::prelude::*;

type Wrong = layout!(hash(ijk).dense(ijk, 8).aos);

fn main() {}
