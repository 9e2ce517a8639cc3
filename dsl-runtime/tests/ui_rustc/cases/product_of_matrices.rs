//! Accumulation is by components: products of matrices are none (H15).
use allotrope::prelude::*;

#[kernel]
fn matrices(u: &Field<Mat2, _>, v: &mut Field<Mat2, _>, at: &Field<u32, _>) {
    for p in u {
        v[at[p]] *= u[p]; //~ E0277
    }
}

fn main() {}
