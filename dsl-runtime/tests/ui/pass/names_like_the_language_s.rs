//! The language's words are names elsewhere.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    len: i32,
    or: Option_,
}

type Option_ = i32;

fn unroll(x: i32) -> i32 {
    x + 1
}

fn clamped(x: i32) -> i32 {
    x.min(1)
}

#[kernel]
fn ordered(serial: &mut Field<Node, _>, interior: i32) {
    let relaxed = Some(interior);
    for shape in serial {
        let row = relaxed.or(None).unwrap_or(0);
        let append = [row, 2, 3];
        serial.len[shape] = unroll(clamped(append[1])) + serial.len() as i32;
        serial.or[shape] = append.len() as i32 + row.wrapping_add(1);
    }
}

fn main() {
    let mut u = Field::<Node, Soa>::new([2]);
    ordered(&mut u, 5);
    assert_eq!((u.get(0).len, u.get(0).or), (4, 9));
}
