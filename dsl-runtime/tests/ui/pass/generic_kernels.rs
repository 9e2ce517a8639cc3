//! Layouts, axes, records and values may be parameters.
use allotrope::prelude::*;
use std::ops::Mul;

#[kernel]
fn scale<T, const N: usize>(u: &mut Field<f32, _>, by: [T; N])
where
    T: Copy + Sync,
    f32: Mul<T, Output = f32>,
{
    for p in u {
        for k in 0..N {
            u[p] = u[p] * by[k];
        }
    }
}

#[kernel]
fn copy<R: Record, X: Axes, L: Layout<X>>(from: &Field<R, L, X>, to: &mut Field<R, L, X>) {
    for p in to {
        to[p] = from[p];
    }
}

fn main() {
    let mut u = Field::<f32, Soa>::new([2]);
    u.fill(1.0);
    scale::<f32, 2>(&mut u, [2.0, 3.0]);
    let mut v = Field::<f32, Soa>::new([2]);
    copy(&u, &mut v);
    assert_eq!(v.to_vec(), [6.0, 6.0]);
}
