//! Values of elements go into any of Rust's values.
use allotrope::prelude::*;

#[kernel]
fn exchange(u: &mut Field<i32, _>, v: &mut Field<i32, _>) {
    for p in u {
        let (a, b) = (u[p], v[p]);
        let mut both = [a, b];
        both.swap(0, 1);
        both[1] += 1;
        let [x, y] = both;
        (u[p], v[p]);
        u[p] = x;
        v[p] = y;
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([2]), Field::<i32, Soa>::new([2]));
    u.fill(1);
    v.fill(2);
    exchange(&mut u, &mut v);
    assert_eq!((u.to_vec(), v.to_vec()), (vec![2, 2], vec![2, 2]));
}
