//! A list has one order: its row is for inner loops.
use allotrope::prelude::*;

#[kernel]
fn wrong(lists: &Field<u32, _, Ij>, list: i32) -> u32 {
    let mut sum = 0;
    for q in lists.row(list) {
        sum += lists[q];
    }
    sum
}

fn main() {}
