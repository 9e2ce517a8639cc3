//! A record has a member at least.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Nothing;

fn main() {}
