//! Nothing leaves a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn find(u: &Field<f32, _>, names: &[&str]) -> Option<i32> {
    for p in u {
        if u[p] > 3.0 {
            return Some(p);
        }
        if u[p] < 0.0 {
            break;
        }
        let name = names.first()?;
        assert!(name.len() > 2);
    }
    None
}

#[kernel]
fn labelled(u: &Field<f32, _>) {
    'steps: loop {
        for p in u {
            for k in 0..3 {
                if u[p] > k as f32 {
                    continue 'steps;
                }
            }
        }
    }
}

fn main() {}
