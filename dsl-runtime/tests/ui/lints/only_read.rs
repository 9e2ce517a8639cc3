//! A value that is read is a copy: changing it changes no field.
#![deny(deprecated)]
use allotrope::prelude::*;

#[kernel]
fn wrong(v: &mut Field<Vec3, _>) {
    for p in v {
        let mut value = v[p];
        value /= value.length();
    }
}

fn main() {}
