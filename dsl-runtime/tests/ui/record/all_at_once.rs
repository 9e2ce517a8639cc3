//! All that is wrong with a record is told at once.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Pair<T>(T, T);

fn main() {}
