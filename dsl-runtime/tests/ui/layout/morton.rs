//! Blocks in Z-order: sizes are powers of two, and never left out.
use allotrope::prelude::*;

type Odd = layout!(morton(ij, 12).aos);
type OneOdd = layout!(dense(ij).morton(ij, (4, 6)).soa);
type Zero = layout!(morton(ij, 0).aos);
type Open = layout!(morton(ij).aos);
type OpenInside = layout!(dense(ij).morton(ij).aos);
type Named = layout!(dense(ij).Morton(8));

fn main() {}
