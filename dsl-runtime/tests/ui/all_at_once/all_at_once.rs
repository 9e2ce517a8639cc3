//! All errors of a kernel come at once, and nothing follows from them.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, v: &Field<f32, _, Ij>, n: usize) -> f32 {
    for i in 0..=n {
        u[i] = 1.0;
    }
    for p in u {
        let p = 3;
        u[p + 1] = v[p];
        break;
    }
    u[0]
}

fn caller() -> f32 {
    let (mut u, v) = (Field::<f32, Aos>::new([3]), Field::<f32, Soa>::new([3, 3]));
    wrong(&mut u, &v, 2)
}

fn main() {}
