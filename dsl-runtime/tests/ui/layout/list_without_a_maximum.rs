//! A list without a maximum.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic(j).aos);

fn main() {}
