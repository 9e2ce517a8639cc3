//! A record holds values.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Point {
    name: &'static str, //~ E0277
}

fn main() {}
