//! A member that is accumulated into at any index is not read, at the own index neither.
use allotrope::prelude::*;

#[kernel]
fn spread(u: &mut Field<f32, _>, at: &Field<u32, _>) {
    for p in u {
        let x = u[p];
        u[at[p]] += x;
    }
}

fn main() {}
