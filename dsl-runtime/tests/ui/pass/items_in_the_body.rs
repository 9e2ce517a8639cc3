//! Items inside a loop have names of their own.
use allotrope::prelude::*;

#[kernel]
fn items(u: &mut Field<i32, _>) {
    fn next(u: i32) -> i32 {
        u + 1
    }
    for p in u {
        fn double(p: i32) -> i32 {
            let u = p;
            u * 2
        }
        struct Pair {
            p: i32,
            u: i32,
        }
        impl Pair {
            fn sum(&self) -> i32 {
                self.p + self.u
            }
        }
        const P: i32 = 10;
        use std::cmp::max;
        let pair = Pair { p: double(p), u: next(P) };
        u[p] = max(pair.sum(), pair.u + 1);
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    items(&mut u);
    assert_eq!(u.to_vec(), [12, 13]);
}
