//! A loop variable means one thing in its loop.
use allotrope::prelude::*;

#[kernel]
fn wrong(u: &mut Field<f32, _>, near: &[Option<i32>]) {
    for p in u {
        let p = 0;
        for p in 0..3 {
            u[p] = 1.0;
        }
        let f = |p: i32| u[p];
        if let Some(p) = near[0] {
            u[p] = 1.0;
        }
        match near[1] {
            Some(p) => u[p] = 2.0,
            _ => {}
        }
    }
}

fn main() {}
