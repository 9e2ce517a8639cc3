//! A value read from a field is a copy: changing it in place would be lost (H25).
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Particle {
    near: [i32; 4],
    x: Vec2,
}

#[kernel]
fn sort(ps: &mut Field<Particle, _>) {
    for p in ps {
        ps.near[p].sort(); //~ E0596
        let x = &mut ps.x[p]; //~ E0596
        *x = Vec2::ZERO;
    }
    ps.near[0].sort(); //~ E0596
}

fn main() {}
