//! Loops in lanes write their own elements alone.
use allotrope::prelude::*;

#[kernel(lanes = 16)]
fn deposit(keys: &Field<u32, _>, bins: &mut Field<f32, _>, most: &mut Field<u32, _>) {
    for i in keys {
        let mut weight = 1.0;
        for _ in 0..keys[i] {
            weight *= 0.5;
        }
        bins[keys[i]] += weight;
        let before = most[keys[i]].fetch_max(3);
    }
}

fn main() {}
