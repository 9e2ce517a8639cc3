//! The order in which a thread visits a field's elements is that of the field's memory.

use std::sync::atomic::{AtomicU32, Ordering};

use allotrope::__private::byte_offset;
use allotrope::prelude::*;

#[kernel]
fn number(visits: &mut Field<u32, _, Ijk>, next: &AtomicU32) {
    for ijk in visits {
        visits[ijk] = next.fetch_add(1, Ordering::Relaxed);
    }
}

#[kernel]
fn number_inside(visits: &mut Field<u32, _, Ijk>, next: &AtomicU32) {
    for (i, j, k) in visits.interior(1) {
        visits[(i, j, k)] = next.fetch_add(1, Ordering::Relaxed);
    }
}

/// Visits beyond zero, in the order of memory.
fn in_memory_order<L: Layout<Ijk>>(field: &Field<u32, L, Ijk>) -> Vec<u32> {
    let [n, m, l] = field.shape();
    let places = (0..n).flat_map(|i| (0..m).flat_map(move |j| (0..l).map(move |k| (i, j, k))));
    let mut visits: Vec<(usize, u32)> = places.map(|at| (byte_offset(field, at, 0, 0), field.get(at))).collect();
    visits.sort_unstable();
    visits.into_iter().map(|(_, visit)| visit).filter(|&visit| visit > 0).collect()
}

#[test]
fn loops_follow_memory() {
    fn run<L: Layout<Ijk>>() {
        let mut field = Field::<u32, L>::new([9, 6, 7]);
        let alone = Schedule { threads: 1, ..Schedule::default() };
        alone.run(|| number(&mut field, &AtomicU32::new(1)));
        assert!(in_memory_order(&field).into_iter().eq(1..=9 * 6 * 7), "{}", std::any::type_name::<L>());
        field.fill(0);
        alone.run(|| number_inside(&mut field, &AtomicU32::new(1)));
        assert!(in_memory_order(&field).into_iter().eq(1..=7 * 4 * 5), "{}", std::any::type_name::<L>());
    }
    run::<Aos>();
    run::<layout!(dense(kji).aos)>();
    run::<layout!(dense(ijk).dense(kij, (2, 3, 4)).aos)>();
    run::<layout!(dense(ijk).dense(i, 2).dense(j, 2).dense(ijk, 2).dense(k, 2).aos)>();
    run::<Morton<2>>();
    run::<Morton<8>>();
    run::<layout!(dense(ikj).morton(jki, (2, 1, 8)).aos)>();
    run::<layout!(dense(ijk).dense(kj, (1, 2)).morton(ij, (2, 4)).dense(ijk, (3, 1, 2)).morton(jk, 2).aos)>();
}
