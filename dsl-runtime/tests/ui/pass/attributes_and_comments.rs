//! Rust's attributes and comments stay where they are.
use allotrope::prelude::*;

/// Fills.
///
/// ```
/// ```
#[inline]
#[must_use]
#[allow(clippy::needless_return, unused_variables)]
#[kernel]
pub fn fill(/* the field */ u: &mut Field<i32, _>, #[allow(unused)] n: i32) -> i32 {
    #![allow(unused_mut)]
    // Each element.
    #[allow(unused_assignments)]
    for p in u {
        /* its own */
        #[allow(unused_variables)]
        let before = u[p];
        #[cfg(any())]
        u[p] = 3;
        #[cfg(all())]
        u[p] = 4; // four
    }
    #[cfg(not(all()))]
    return 3;
    return u[0];
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    assert_eq!(fill(&mut u, 0), 4);
}
