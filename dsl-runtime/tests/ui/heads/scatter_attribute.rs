//! `#[scatter(..)]` names a schedule of a parallel loop.
use allotrope::prelude::*;

#[kernel]
fn wrong(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Fast)]
    for p in keys {
        bins[keys[p]] += 1;
    }
    #[scatter(Atomic)]
    #[serial]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
