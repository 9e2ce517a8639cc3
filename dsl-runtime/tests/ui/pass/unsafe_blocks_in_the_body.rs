//! What is unsafe stands in an `unsafe` block, as anywhere.
use allotrope::prelude::*;

#[kernel]
fn gather(u: &mut Field<i32, _>, values: &[i32]) {
    assert!(values.len() >= u.len());
    for p in u {
        // SAFETY: the slice is as long as the field, which was asserted.
        u[p] = unsafe { *values.get_unchecked(p as usize) };
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([3]);
    gather(&mut u, &[4, 5, 6]);
    assert_eq!(u.to_vec(), [4, 5, 6]);
}
