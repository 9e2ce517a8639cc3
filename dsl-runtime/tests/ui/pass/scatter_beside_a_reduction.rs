//! Accumulations into fields and into variables stand together.
use allotrope::prelude::*;

#[kernel]
fn histogram(keys: &Field<u32, _>, bins: &mut Field<u32, _>) -> (u32, u32) {
    let (mut total, mut most) = (0, 0);
    for p in keys {
        bins[keys[p]] += 1;
        total += keys[p];
        most.max_assign(keys[p]);
    }
    (total, most)
}

fn main() {
    let mut keys = Field::<u32, Soa>::new([100]);
    (0..100).for_each(|i| keys.set(i, (i % 3) as u32));
    let mut bins = Field::<u32, Soa>::new([3]);
    assert_eq!(histogram(&keys, &mut bins), (99, 2));
    assert_eq!(bins.to_vec(), [34, 33, 33]);
}
