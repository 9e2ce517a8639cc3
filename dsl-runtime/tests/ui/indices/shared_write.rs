//! A field to be written is taken by `&mut`.
use allotrope::prelude::*;

#[kernel]
fn fill(u: &Field<f32, _>) {
    for p in u {
        u[p] = 1.0;
    }
}

#[kernel]
fn count(keys: &Field<u32, _>, bins: &Field<u32, Soa>) {
    for p in keys {
        bins[keys[p]] += 1;
    }
    bins[0] = 0;
}

fn main() {}
