//! Padding: a power of two of bytes, once, right before the place.
use allotrope::prelude::*;

type Odd = layout!(dense(ij).pad(48).aos);
type Wide = layout!(dense(ij).pad(8192).soa);
type Text = layout!(dense(ij).pad("64").aos);
type Open = layout!(dense(ij).pad.aos);
type Two = layout!(dense(ij).pad(64, 64).aos);
type Early = layout!(dense(ij).pad(64).dense(ij, 8).aos);
type Late = layout!(dense(ij).aos.pad(64));

fn main() {}
