//! Values and indices are checked by rustc, at the user's tokens.
use allotrope::prelude::*;

#[kernel]
fn values(u: &mut Field<f32, _>, v: &Field<i32, _>) {
    for p in u {
        u[p] = v[p]; //~ E0308
        u[p] += "one"; //~ E0277
    }
    u[0] = true; //~ E0308
}

#[kernel]
fn indices(u: &mut Field<f32, _>, x: f32) {
    for p in u {
        u[p] = 1.0;
    }
    let _ = u[x]; //~ E0277
}

#[kernel]
fn scatter(u: &Field<f32, _>, at: &Field<Vec2, _>, v: &mut Field<f32, _, Ij>) {
    for p in u {
        v[at[p]] += u[p]; //~ E0277
    }
}

#[kernel]
fn grid(u: &mut Field<f32, _, Ij>) {
    for ij in u {
        u[ij] = 1.0;
    }
}

fn axes() {
    let mut line = Field::<f32, Aos>::new([8]);
    grid(&mut line); //~ E0308
}

fn main() {}
