//! A copy of the loop variable reads what the loop does not write.
use allotrope::prelude::*;

#[kernel]
fn copy(u: &Field<i32, _>, v: &mut Field<i32, _>) {
    for p in v {
        let (q, here) = (p, p);
        v[p] = u[q] + u[here];
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([3]), Field::<i32, Soa>::new([3]));
    u.fill(2);
    copy(&u, &mut v);
    assert_eq!(v.to_vec(), [4; 3]);
}
