//! Accumulation is by components: products of quaternions are none (H15).
use allotrope::prelude::*;

#[kernel]
fn turns(u: &Field<Quat, _>, v: &mut Field<Quat, _>, at: &Field<u32, _>) {
    for p in u {
        v[at[p]] *= u[p]; //~ E0277
    }
}

fn main() {}
