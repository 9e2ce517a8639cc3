//! When the order of particles in memory has decayed so far that they are sorted.

use allotrope::prelude::*;
use allotrope_solvers::mpm::order::Order;

/// Cells of particles in rows of a hundred.
fn row(place: usize) -> IVec3 {
    IVec3::new(place as i32 / 100, place as i32 % 100, 0)
}

/// No order at all.
fn mixed(place: usize) -> IVec3 {
    row(place * 7919 % 10_007)
}

#[test]
fn what_was_never_sorted_is_sorted_first() {
    let mut order = Order::default();
    assert!(order.has_decayed(0, 10_000, row));
    order.renew(10_000, row);
    assert!((0..1000).all(|step| !order.has_decayed(step, 10_000, row)), "nothing moves");
}

#[test]
fn decay_adds_up_until_a_sort_pays() {
    let mut order = Order::default();
    order.renew(10_000, row);
    assert!((1..9).any(|step| order.has_decayed(step, 10_000, mixed)), "all order is lost at once");
    let slow = |place: usize| if place.is_multiple_of(40) { mixed(place) } else { row(place) };
    order.renew(10_000, row);
    let steps = (1..1000).find(|&step| order.has_decayed(step, 10_000, slow)).unwrap();
    assert!(steps > 8 && steps < 200, "{steps}");
}

#[test]
fn few_particles_are_looked_at_too() {
    for particles in [0, 1, 2, 65] {
        let mut order = Order::default();
        order.renew(particles, row);
        assert!(!order.has_decayed(8, particles, row), "{particles}");
    }
}
