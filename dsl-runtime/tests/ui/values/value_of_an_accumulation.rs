//! An accumulation has no value.
use allotrope::prelude::*;

#[kernel]
fn number(keys: &Field<u32, _>, bins: &mut Field<u32, _>, slots: &mut Field<u32, _>) {
    for p in keys {
        let old = (bins[keys[p]] += 1);
        slots[p] = old;
    }
}

fn main() {}
