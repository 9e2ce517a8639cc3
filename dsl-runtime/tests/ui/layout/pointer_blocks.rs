//! A word that the language has and this version has not.
use allotrope::prelude::*;

type Wrong = layout!(pointer(ij, 16).dense(ij, 8).aos);

fn main() {}
