//! Arms bind names and access elements.
use allotrope::prelude::*;

#[kernel]
fn classify(u: &mut Field<i32, _>, v: &Field<i32, _>) {
    for p in u {
        u[p] = match v[p] {
            x if x < 0 && v[0] < 0 => -1,
            0 => v[p] + u[p],
            x @ 1..=9 => x,
            x => match (x, u[p]) {
                (big, 0) if big > v[1] => 2,
                _ => 3,
            },
        };
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([4]), Field::<i32, Soa>::new([4]));
    [-5, 0, 7, 50].into_iter().enumerate().for_each(|(i, x)| v.set(i, x));
    u.set(1, 8);
    classify(&mut u, &v);
    assert_eq!(u.to_vec(), [-1, 8, 7, 2]);
}
