//! Variables from outside are accumulated into, not assigned.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &Field<f32, _>, out: &mut f32) -> f32 {
    let mut last = 0.0;
    let mut ratio = 1.0;
    let mut bins = [0; 4];
    let mut centre = Vec2::ZERO;
    for p in u {
        last = u[p];
        ratio /= u[p];
        *out += u[p];
        bins[p as usize % 4] += 1;
        centre.x += u[p];
    }
    last + ratio + bins[0] as f32 + centre.x
}

fn main() {}
