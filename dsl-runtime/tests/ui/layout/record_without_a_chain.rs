//! After a record comes a chain.
use allotrope::prelude::*;

type Grid = layout!(Node:);

fn main() {}
