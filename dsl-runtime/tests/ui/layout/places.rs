//! One place, at the end.
use allotrope::prelude::*;

type Without = layout!(dense(ij).dense(ij, 8));
type InTheMiddle = layout!(dense(ij).soa.dense(ij, 8));
type Two = layout!(dense(ij).aos.soa);
type Alone = layout!(aos);
type Called = layout!(dense(ij).aos());
type Filled = layout!(dense(ij).soa(v, m));

fn main() {}
