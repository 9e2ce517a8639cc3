//! Records with parameters are not available yet.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node<T, const N: usize> {
    v: [T; N],
    m: f32,
}

fn main() {}
