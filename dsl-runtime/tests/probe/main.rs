//! Recordings of what loops touch.
#![cfg(any(feature = "probe", debug_assertions))]

mod cachegrind;
mod counts;

use allotrope::prelude::*;

/// A node of a Jacobi iteration.
#[derive(Record, Clone, Copy, Default)]
struct Node {
    u: f32,
    v: f32,
    rhs: f32,
    mask: f32,
}

#[kernel]
fn jacobi(nodes: &mut Field<Node, _, Ij>) {
    for (i, j) in nodes.interior(1) {
        nodes.v[(i, j)] = 0.25
            * (nodes.u[(i - 1, j)]
                + nodes.u[(i + 1, j)]
                + nodes.u[(i, j - 1)]
                + nodes.u[(i, j + 1)]
                + nodes.rhs[(i, j)]);
    }
}
