//! What a parallel loop may run over.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, ids: &[usize], n: usize) {
    for i in (0..n).rev() {
        u[i] = 1.0;
    }
    for i in ids.iter() {
        u[*i] = 1.0;
    }
    for (i, x) in u.iter().enumerate() {
        u[i] = x;
    }
    for i in &u {
        u[i] = 1.0;
    }
    #[serial]
    for i in ids.iter() {
        u[*i] = 1.0;
    }
}

fn main() {}
