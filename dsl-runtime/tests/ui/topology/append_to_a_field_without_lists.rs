//! A layout without a `dynamic` node has no lists.
use allotrope::prelude::*;

#[kernel]
fn collect(keys: &Field<u32, _>, list: &mut Field<u32, _>) {
    for p in keys {
        list.append((), keys[p]);
    }
}

fn main() {
    let keys = Field::<u32, Aos>::new([10]);
    let mut list = Field::<u32, Aos>::new([10]);
    collect(&keys, &mut list);
}
