//! A function reads plainly what it is handed, though the loop is relaxed.
use allotrope::prelude::*;

#[func]
fn first(q: Read<f32, _>) -> f32 {
    q[0]
}

#[kernel]
fn wrong(u: &mut Field<f32, _>, at: &Field<u32, _>) {
    #[relaxed]
    for p in at {
        u[at[p]] = first(u);
    }
}

fn main() {}
