//! The launch has the schedule.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    for p in keys {
        #[scatter(Atomic)]
        for k in 0..3 {
            bins[keys[p] + k] += 1;
        }
    }
}

fn main() {}
