//! Accumulation is by components: products of matrices are none (H15).
use allotrope::prelude::*;

#[kernel]
fn matrices(u: &Field<Mat2, _>, v: &mut Field<Mat2, _>, at: &Field<u32, _>) {
    for p in u {
        v[at[p]] *= u[p]; //~ E0277
    }
}

// Rustc blames the view here, and its label the operator's line.
#[kernel] //~ E0277
fn bits_of_floats(v: &mut Field<f32, _>, at: &Field<u32, _>) {
    for p in at {
        v[at[p]] |= 1.0;
    }
}

#[kernel] //~ E0599
fn strings(u: &Field<f32, _>) -> String {
    let mut all = String::new();
    for p in u {
        all += "x"; //~ E0277
        let _ = u[p];
    }
    all
}

fn main() {}
