//! A macro's own names are not its caller's.
use allotrope::prelude::*;

macro_rules! fill {
    ($name:ident, $value:expr) => {
        #[kernel]
        fn $name(u: &mut Field<i32, _>, p: i32) {
            for q in u {
                let x: i32 = $value;
                u[q] = x + p;
            }
        }
    };
}

fill!(ones, 1);
fill!(sevens, {
    let r = 7;
    r
});

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    ones(&mut u, 2);
    assert_eq!(u.to_vec(), [3, 3]);
    sevens(&mut u, 0);
    assert_eq!(u.to_vec(), [7, 7]);
}
