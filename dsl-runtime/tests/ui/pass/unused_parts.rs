//! Names that are not used, and loops that do nothing.
use allotrope::prelude::*;

#[kernel]
#[allow(unused_variables)]
fn nothing(u: &mut Field<i32, _>, v: &Field<f32, _, Ij>, n: i32) {
    for _ in u {}
    for (_, j) in v {
        let _ = j;
    }
    for _p in 0..n {}
}

#[kernel]
fn empty() {}

fn main() {
    let (mut u, v) = (Field::<i32, Soa>::new([2]), Field::<f32, Soa>::new([2, 2]));
    nothing(&mut u, &v, 3);
    empty();
    assert_eq!(u.to_vec(), [0, 0]);
}
