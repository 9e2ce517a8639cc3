//! Closures inside a loop may access what the loop may.
use allotrope::prelude::*;

#[kernel]
fn sums(u: &Field<i32, _>, v: &mut Field<i32, _>) {
    for p in v {
        let at = |k: i32| u.clamped(p + k);
        let both = |k: i32| {
            let twice = |x: i32| 2 * x + v[p];
            twice(at(k)) + at(-k)
        };
        let x = both(1);
        let put = |x: i32| v[p] = x;
        put(x);
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([3]), Field::<i32, Soa>::new([3]));
    (0..3).for_each(|i| u.set(i, i as i32));
    v.fill(100);
    sums(&u, &mut v);
    assert_eq!(v.to_vec(), [102, 104, 105]);
}
