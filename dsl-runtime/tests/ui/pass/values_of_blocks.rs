//! Blocks, branches and loops are values, and their last expressions accumulate.
use allotrope::prelude::*;

#[kernel]
fn values(u: &mut Field<i32, _>, bins: &mut Field<i32, _>) -> i32 {
    let mut count = 0;
    for p in u {
        let x = {
            let y = u[p] + 1;
            if y > 1 { u[p] } else { y * 10 }
        };
        if x > 5 {
            bins[0] += x
        } else {
            bins[1] += 1
        }
        match x {
            10 => count += 1,
            _ => count += 100,
        }
        u[p] = x
    }
    count
}

fn main() {
    let (mut u, mut bins) = (Field::<i32, Soa>::new([3]), Field::<i32, Soa>::new([2]));
    u.set(1, 3);
    assert_eq!(values(&mut u, &mut bins), 102);
    assert_eq!((u.to_vec(), bins.to_vec()), (vec![10, 3, 10], vec![20, 1]));
}
