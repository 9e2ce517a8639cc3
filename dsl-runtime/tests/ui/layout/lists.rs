//! A word that the language has and this version has not.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j, 1024, chunk = 32).aos);

fn main() {}
