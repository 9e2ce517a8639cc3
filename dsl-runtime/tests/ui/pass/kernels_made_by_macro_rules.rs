//! A macro may write kernels.
use allotrope::prelude::*;

macro_rules! scale {
    ($name:ident, $type:ty, $field:ident, $at:ident, $by:expr) => {
        #[kernel]
        fn $name($field: &mut Field<$type, _>) -> $type {
            let mut total = 0 as $type;
            for $at in $field {
                $field[$at] *= $by;
                total += $field[$at];
            }
            total
        }
    };
}

scale!(double, f32, u, p, 2.0);
scale!(triple, i32, values, k, 3);

fn main() {
    let mut u = Field::<f32, Soa>::new([3]);
    u.fill(1.5);
    assert_eq!(double(&mut u), 9.0);
    let mut v = Field::<i32, Aos>::new([2]);
    v.fill(1);
    assert_eq!(triple(&mut v), 6);
}
