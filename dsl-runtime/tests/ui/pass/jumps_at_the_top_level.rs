//! The top level may be left between loops.
use allotrope::prelude::*;

#[kernel]
fn guarded(u: &mut Field<i32, _>, limits: &[i32]) -> Option<i32> {
    let first = *limits.first()?;
    if first < 0 {
        return None;
    }
    while u[0] < first {
        for p in u {
            u[p] += 1;
        }
        if u[0] == 3 {
            break;
        }
    }
    Some(u[1])
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    assert_eq!(guarded(&mut u, &[]), None);
    assert_eq!(guarded(&mut u, &[-1]), None);
    assert_eq!(guarded(&mut u, &[2]), Some(2));
    assert_eq!(guarded(&mut u, &[9]), Some(3));
}
