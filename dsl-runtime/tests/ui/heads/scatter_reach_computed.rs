//! The reach of `Colored` is known before the loop runs.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>, n: i32) {
    #[scatter(Colored, reach = n)]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
