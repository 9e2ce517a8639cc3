//! A list without an axis.
use allotrope::prelude::*;

type Wrong = layout!(dense(i).dynamic().aos);

fn main() {}
