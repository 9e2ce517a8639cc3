//! The axes of a node are a word of `i j k l`, each once, and a layout leaves none out.
use allotrope::prelude::*;

type Elsewhere = layout!(dense(xy).aos);
type Large = layout!(dense(I).aos);
type Other = layout!(dense(in_).aos);
type Twice = layout!(dense(iji).aos);
type Missing = layout!(dense(ik).dense(ik, 4).aos);
type Apart = layout!(dense(i, j).aos);
type Text = layout!(dense("ij").aos);
type Nowhere = layout!(dense.aos);

fn main() {}
