//! A field of one element takes sums from all, and is read by all.
use allotrope::prelude::*;

#[kernel]
fn mean(u: &mut Field<f32, _>, sum: &mut Field<f32, _, O>) {
    for p in u {
        sum[()] += u[p];
    }
    let n = u.len() as f32;
    for p in u {
        u[p] = sum[()] / n;
    }
    for o in sum {
        sum[o] = 2.0 * sum[o];
    }
}

fn main() {
    let (mut u, mut sum) = (Field::<f32, Soa>::new([4]), Field::<f32, Aos>::new([]));
    u.set(0, 8.0);
    mean(&mut u, &mut sum);
    assert_eq!(u.to_vec(), [2.0; 4]);
    assert_eq!(sum.get(()), 16.0);
}
