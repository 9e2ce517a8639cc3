//! A slice is no other than a field.
use allotrope::prelude::*;

#[kernel]
fn wrong(list: &mut [f32]) {
    for i in list {
        list[i] = list[0];
    }
}

fn main() {}
