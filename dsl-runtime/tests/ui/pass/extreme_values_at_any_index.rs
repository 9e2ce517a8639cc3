//! Extremes and bits accumulate too, one group a member.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Bin {
    least: i32,
    most: i32,
    seen: u32,
    odd: u32,
}

#[kernel]
fn bins(keys: &Field<i32, _>, bins: &mut Field<Bin, _>) {
    for p in keys {
        let at = keys[p] % 2;
        bins.least[at].min_assign(keys[p]);
        bins.most[at].max_assign(keys[p]);
        bins.seen[at] |= 1 << keys[p];
        bins.odd[at] ^= 1;
    }
}

fn main() {
    let (mut keys, mut all) = (Field::<i32, Soa>::new([5]), Field::<Bin, Aos>::new([2]));
    (0..5).for_each(|i| keys.set(i, i as i32 + 1));
    all.fill(Bin { least: 100, ..Bin::default() });
    bins(&keys, &mut all);
    let bin = all.get(1);
    assert_eq!((bin.least, bin.most, bin.seen, bin.odd), (1, 5, 0b101010, 1));
}
