//! A function puts no least value into members.
use allotrope::prelude::*;

#[func]
fn wrong(q: Read<f32, _>, i: i32) {
    q[i].max_assign(2.0);
}

fn main() {}
