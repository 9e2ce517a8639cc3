//! `+=` and `-=` are one group.
use allotrope::prelude::*;

#[kernel]
fn flow(from: &Field<u32, _>, to: &Field<u32, _>, balance: &mut Field<i32, _>) -> i32 {
    let mut total = 0;
    for p in from {
        balance[from[p]] -= 1;
        balance[to[p]] += 1;
        total -= 1;
        total += 2;
    }
    total
}

fn main() {
    let (mut from, mut to) = (Field::<u32, Soa>::new([3]), Field::<u32, Soa>::new([3]));
    from.fill(1);
    to.set(0, 2);
    let mut balance = Field::<i32, Soa>::new([3]);
    assert_eq!(flow(&from, &to, &mut balance), 3);
    assert_eq!(balance.to_vec(), [2, -3, 1]);
}
