//! Methods that this version lacks, and those that need the field.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _, Ij>, bins: &mut Field<u32, _>, keys: &Field<u32, _>) {
    for (i, j) in u {
        let x = u.or((i - 1, j), 0.0) + u.clamped((i, j)) + u.wrapped((i, j));
        u.fill(x);
    }
    for p in keys {
        let slot = bins[keys[p]].fetch_add(1);
        bins.append(slot);
    }
}

fn main() {}
