//! A macro that names nothing of the kernel may be defined where it is used.
use allotrope::prelude::*;

#[kernel]
fn double(u: &mut Field<i32, _>) {
    for p in u {
        macro_rules! twice {
            ($x:expr) => {
                2 * $x
            };
        }
        let x = u[p];
        u[p] = twice!(x);
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    u.fill(3);
    double(&mut u);
    assert_eq!(u.to_vec(), [6, 6]);
}
