//! Slices as parameters: fields over one axis where a loop uses them as such, ordinary values elsewhere; and `#[field]`.

use allotrope::prelude::*;

use super::Node;

#[kernel]
fn saxpy(y: &mut [f32], a: f32, x: &[f32]) -> f32 {
    let mut sum = 0.0;
    for i in y {
        y[i] += a * x[i as usize];
        sum += y[i];
    }
    sum
}

/// Both slices are fields: one is the loop's, with neighbours and boundary rules, the other is written.
#[kernel]
fn blur(from: &[Vec2], to: &mut [Vec2]) {
    for i in from.interior(1) {
        to[i] = (from[i - 1] + from[i] + from[i + 1]) / 3.0;
    }
    for i in from.border(1) {
        to[i].x = from.clamped(i - 1).x + from.or(i + 1, Vec2::ZERO).x;
        to[i].y = from.wrapped(i - 1).y;
    }
}

/// Slices that are read at the loop's indices: own, moved, and by a part of one.
#[kernel]
fn weigh(u: &mut Field<f32, _, Ij>, rows: &[f32], columns: &[u8]) {
    for (i, j) in u {
        u[(i, j)] = rows[i] * f32::from(columns[j + 1]);
    }
    for ij in u.interior(1) {
        u[ij] += rows[ij.x - 1];
    }
}

#[kernel]
fn histogram(values: &Field<f32, _>, bins: &mut [u32], highest: &mut [f32]) {
    for p in values {
        let bin = (values[p] * 10.0) as usize % bins.len();
        bins[bin] += 1;
        highest[bin].max_assign(values[p]);
    }
}

/// The top level and serial loops; a slice of what is no element, read in a loop.
#[kernel]
fn mixed(names: &[String], ids: &[usize], list: &mut [i32; 8], out: &mut [i32]) -> usize {
    list[0] = 1;
    out[1..3].copy_from_slice(&[5, 6]);
    for i in out {
        out[i] += names[ids[i as usize]].len() as i32;
    }
    let mut last = 0;
    #[serial]
    for (n, id) in ids.iter().enumerate() {
        out[n] += list[0];
        last = *id;
    }
    out[0u8] *= 10;
    last + out.iter().sum::<i32>() as usize
}

type Grid<L> = Field<Node, L, Ij>;

#[kernel]
fn decay(#[field] grid: &mut Grid<impl Layout<Ij>>, #[field] masses: &Heat, #[field] rows: &[f32]) {
    for (i, j) in grid {
        grid.m[(i, j)] = masses[(i, j)] * rows[i];
        grid.v[(i, j)].y = rows.wrapped(j);
    }
    for (i, j) in masses {
        grid.m[(i, j)] += 1.0;
    }
}
type Heat = Field<f32, Soa, Ij>;

/// A parameter whose type is a type parameter.
#[kernel]
fn total<S: allotrope::AnyMember<f32, Ij>>(#[field] s: &S) -> f32 {
    let mut total = 0.0;
    for (i, j) in s {
        total += s[(i, j)];
    }
    total
}

fn schedules(mut each: impl FnMut(Schedule)) {
    for scatter in [Scatter::Auto, Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
        for threads in 1..=3 {
            each(Schedule { threads, scatter, grain: 16, ..Schedule::default() });
        }
    }
}

#[test]
fn loops_run_over_slices_and_write_them() {
    schedules(|schedule| {
        let x: Vec<f32> = (0..1000).map(|n| n as f32).collect();
        let mut y = vec![1.0; 1000];
        let sum = schedule.run(|| saxpy(&mut y[10..900], 2.0, &x));
        let expected = |n: usize| if (10..900).contains(&n) { 1.0 + 2.0 * (n - 10) as f32 } else { 1.0 };
        assert!(y.iter().enumerate().all(|(n, y)| *y == expected(n)));
        assert!((sum - (10..900).map(expected).sum::<f32>()).abs() < 1.0);
    });
    assert_eq!(saxpy(&mut [], 1.0, &[]), 0.0);
}

#[test]
fn neighbours_and_boundary_rules_in_slices() {
    let from: Vec<Vec2> = (0..50).map(|n| vec2(n as f32, (n * n) as f32)).collect();
    let mut to = vec![Vec2::ZERO; 50];
    blur(&from, &mut to);
    assert_eq!(to[7], (from[6] + from[7] + from[8]) / 3.0);
    assert_eq!((to[0], to[49]), (vec2(1.0, from[49].y), vec2(48.0, from[48].y)));
}

#[test]
fn slices_are_read_at_the_loop_s_indices() {
    fn run<L: Layout<Ij>>() {
        let mut u = Field::<f32, L>::new([4, 3]);
        weigh(&mut u, &[1.0, 2.0, 3.0, 4.0], &[9, 0, 1, 2]);
        assert_eq!((u.get([3, 2]), u.get([2, 1]), u.get([1, 0])), (8.0, 3.0 + 2.0, 0.0));
    }
    run::<Aos>();
    run::<Blocked<2>>();
    run::<layout!(dense(ji).aos)>();
}

/// Copies of a slice that jobs accumulate into are combined into the slice, and into nothing behind or before it.
#[test]
fn slices_are_accumulated_into_by_every_schedule() {
    let mut values = Field::<f32, Soa>::new([5000]);
    values.members_mut().0.copy_from_slice(&(0..5000).map(|n| (n * 7 % 4000) as f32 / 1000.0).collect::<Vec<_>>());
    let (mut expected, mut most) = ([9; 40], [-1f32; 40]);
    for value in values.iter() {
        let bin = (value * 10.0) as usize % 30;
        expected[3 + bin] += 1;
        most[3 + bin] = most[3 + bin].max(value);
    }
    schedules(|schedule| {
        let (mut bins, mut highest) = ([9; 40], [-1f32; 40]);
        schedule.run(|| histogram(&values, &mut bins[3..33], &mut highest[3..33]));
        assert_eq!((bins, highest), (expected, most), "{schedule:?}");
    });
}

#[test]
fn slices_are_plain_values_where_no_loop_uses_them_as_fields() {
    let names = ["a".to_owned(), "bcd".to_owned()];
    let mut out = [0; 4];
    assert_eq!(mixed(&names, &[1, 0, 1, 1], &mut [0; 8], &mut out), 1 + 40 + 7 + 10 + 4);
    assert_eq!(out, [40, 7, 10, 4]);
}

#[test]
fn parameters_marked_as_fields() {
    fn run<L: Layout<Ij>>() {
        let mut grid = Field::<Node, L>::new([3, 5]);
        let masses = Field::<f32, Soa>::new([3, 5]).with_background(2.0);
        decay(&mut grid, &masses, &[1.0, 10.0, 100.0]);
        assert_eq!(grid.get([2, 3]), Node { v: vec2(0.0, 1.0), m: 201.0 });
        assert_eq!(total(&grid.members().m), 5.0 * 222.0 + 15.0);
    }
    run::<Aos>();
    run::<Soa>();
    run::<Blocked<2>>();
    assert_eq!(total(&Field::<f32, AoSoA<4>>::new([7, 9]).with_background(1.0)), 63.0);
}

#[test]
#[should_panic(expected = "kernel `saxpy`: index")]
fn an_index_outside_of_a_slice_panics() {
    #[kernel]
    fn saxpy(y: &mut [f32], x: &[f32]) {
        for i in x {
            y[i] = x[i];
        }
    }
    saxpy(&mut [0.0; 9], &[1.0; 10]);
}
