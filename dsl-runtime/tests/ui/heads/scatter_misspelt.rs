//! `#[scatter(..)]` names a schedule.
use allotrope::prelude::*;

#[kernel]
fn count(keys: &Field<u32, _>, bins: &mut Field<u32, _>) {
    #[scatter(Fast)]
    for p in keys {
        bins[keys[p]] += 1;
    }
}

fn main() {}
