//! A serial loop needs no schedule.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Atomic)]
    #[serial]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
