//! Axes are small letters: `I` is the type of one axis.
use allotrope::prelude::*;

type Line = layout!(dense(I).aos);

fn main() {}
