//! Two parameters never alias.
use allotrope::prelude::*;

#[kernel]
fn add(u: &mut Field<f32, _>, v: &Field<f32, _>) {
    for p in u {
        u[p] += v[p];
    }
}

fn main() {
    let mut line = Field::<f32, Aos>::new([8]);
    add(&mut line, &line); //~ E0502
}
