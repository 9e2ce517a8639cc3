//! A kernel's axes are a type.
use allotrope::prelude::*;

#[kernel]
fn grid(u: &mut Field<f32, _, Ij>) {
    for ij in u {
        u[ij] = 1.0;
    }
}

fn main() {
    let mut line = Field::<f32, Aos>::new([8]);
    grid(&mut line); //~ E0308
}
