//! A macro that gets values alone is left as it is.
use allotrope::prelude::*;

macro_rules! square {
    ($x:expr) => {
        $x * $x
    };
}

macro_rules! either {
    ($a:pat, $b:pat) => {
        $a | $b
    };
}

#[kernel]
fn squares(u: &mut Field<i32, _>) {
    let three = square!(3);
    for p in u {
        let x = u[p];
        u[p] = square!(x + 1) + three;
        match x {
            either!(0, 1) => u[p] += 1,
            _ => {}
        }
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    u.set(1, 4);
    squares(&mut u);
    assert_eq!(u.to_vec(), [11, 34]);
}
