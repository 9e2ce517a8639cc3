//! A layout is a chain of words.
use allotrope::prelude::*;

type Nothing = layout!();
type Unfinished = layout!(dense(ij).);
type List = layout!(dense(ij), dense(ij, 8), aos);
type Product = layout!(dense(ij) * dense(ij, 8));
type Turbofish = layout!(dense(ij).dense::<8>(ij).aos);
type Tuple = layout!(dense(ij).0);
type Record = layout!(Node:);

fn main() {}
