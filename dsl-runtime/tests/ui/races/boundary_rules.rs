//! A read with a boundary rule is a read of any element, so that the loop does not write the member that it reads.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Cell {
    heat: f32,
    flow: f32,
}

#[kernel]
fn smooth(u: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        u[(i, j)] = 0.5 * (u.clamped((i - 1, j)) + u.clamped((i + 1, j)));
    }
}

#[kernel]
fn spread(cells: &mut Field<Cell, _>, total: &mut Field<f32, _>) {
    for p in cells {
        cells.heat[p] = cells.flow.wrapped(p + 1) + cells.heat.wrapped(p + 1);
        total[0] += total.or(p, 1.0);
    }
}

fn main() {}
