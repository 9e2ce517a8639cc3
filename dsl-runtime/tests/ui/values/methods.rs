//! Methods that this version lacks, those that need the field, and those with other arguments than they take.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _, Ij>, bins: &mut Field<u32, _>, keys: &Field<u32, _>) {
    for (i, j) in u {
        let x = u.or((i - 1, j)) + u.clamped(i, j) + u.wrapped(i, j);
        u.fill(x);
    }
    for p in keys {
        let slot = bins[keys[p]].fetch_add(1);
        bins.append(slot);
    }
}

fn main() {}
