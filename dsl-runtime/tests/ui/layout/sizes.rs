//! Sizes are positive integers, one for all axes or one each, and every inner node has one.
use allotrope::prelude::*;

type Zero = layout!(dense(ij).dense(ij, (4, 0)).aos);
type Negative = layout!(dense(ij).dense(ij, -8).aos);
type Broken = layout!(dense(ij).dense(ij, 2.5).aos);
type Typed = layout!(dense(ij).dense(ij, 8u32).aos);
type Huge = layout!(dense(i, 2_147_483_648).aos);
type HugeTogether = layout!(dense(ij).dense(i, 65_536).dense(ij, 65_536).aos);
type Unsized = layout!(dense(ij).dense(ij).aos);
type TooMany = layout!(dense(ij).dense(ij, (4, 2, 2)).aos);
type TooFew = layout!(dense(ijk).dense(ijk, (4, 2)).aos);
type NoTuple = layout!(dense(ij).dense(ij, 4, 2).aos);

fn main() {}
