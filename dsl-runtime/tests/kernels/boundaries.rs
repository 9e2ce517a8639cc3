//! Reads at any index, with a rule for those outside of the field.

use allotrope::prelude::*;

use super::Node;

#[kernel]
fn around(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>, a: i32, b: i32) {
    for (i, j) in v {
        v[(i, j)] = u.clamped((i + a, j + b)) + 1000.0 * u.wrapped((i + a, j + b));
    }
}

#[kernel]
fn around_vectors(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>, a: i32, b: i32) {
    for ij in v {
        v[ij] = u.clamped(ij + ivec2(a, b)) + 1000.0 * u.wrapped(ij + ivec2(a, b));
    }
}

#[test]
fn clamped_and_wrapped_in_any_layout() {
    fn run<L: Layout<Ij>>(shape: [usize; 2], step: impl Fn(&Field<f32, L, Ij>, &mut Field<f32, L, Ij>, i32, i32)) {
        let (n, m) = (shape[0] as i32, shape[1] as i32);
        let value = |i: i32, j: i32| (13 * i + j) as f32;
        let (mut u, mut v) = (Field::<f32, L>::new(shape), Field::<f32, L>::new(shape));
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            u.set((i, j), value(i, j));
        }
        for (a, b) in [(0, 0), (1, 0), (0, -1), (-3, 2), (7, 50), (-50, -7), (i32::MAX - 20, i32::MIN + 20)] {
            step(&u, &mut v, a, b);
            for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
                let clamped = value((i + a).clamp(0, n - 1), (j + b).clamp(0, m - 1));
                let wrapped = value((i + a).rem_euclid(n), (j + b).rem_euclid(m));
                assert_eq!(v.get((i, j)), clamped + 1000.0 * wrapped, "({i}, {j}) moved by ({a}, {b}) in {shape:?}");
            }
        }
    }
    for shape in [[5, 7], [1, 1], [4, 8], [9, 2]] {
        run::<Aos>(shape, around);
        run::<Blocked<4>>(shape, around);
        run::<Blocked<4>>(shape, around_vectors);
        run::<layout!(dense(ji).dense(ij, (3, 5)).soa)>(shape, around);
    }
}

/// The sum over the neighbours; beyond the border lies `outside`.
#[kernel]
fn neighbours(grid: &mut Field<Node, _, Ij>, outside: Vec2) {
    for (i, j) in grid {
        let mut sum = Vec2::ZERO;
        for (a, b) in unroll!(-1..2, -1..2) {
            sum += grid.v.or((i + a, j + b), outside);
        }
        grid.m[(i, j)] = sum.x - sum.y;
    }
}

#[test]
fn or_gives_the_value_outside_of_the_field_alone() {
    fn run<L: Layout<Ij>>() {
        let mut grid = Field::<Node, L>::new([6, 5]);
        grid.fill(Node { v: vec2(1.0, 0.0), m: 0.0 });
        neighbours(&mut grid, vec2(0.0, 100.0));
        for (i, j) in (0..6).flat_map(|i| (0..5).map(move |j| (i, j))) {
            let inside = (3 - i32::from(i == 0 || i == 5)) * (3 - i32::from(j == 0 || j == 4));
            assert_eq!(grid.get((i, j)).m, (inside - 100 * (9 - inside)) as f32, "({i}, {j})");
        }
    }
    run::<Aos>();
    run::<Split>();
    run::<Blocked<4>>();
}

/// Indices of several types, each evaluated once, and whole records.
#[kernel]
fn any_integer(nodes: &Field<Node, _>, out: &mut Field<f32, _>, calls: &std::sync::atomic::AtomicUsize) {
    for p in out {
        let index = |k: u64| {
            calls.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            k
        };
        let far = nodes.clamped(index(u64::MAX));
        let near = nodes.m.wrapped(p as i64 - 1_000_000_000_000);
        out[p] = far.m + near + nodes.or(-1i8, Node { v: Vec2::ZERO, m: 0.5 }).m + nodes.m.or(200u8, 0.25);
    }
}

#[test]
fn indices_of_any_integer_type_are_evaluated_once() {
    let mut nodes = Field::<Node, Soa>::new([10]);
    (0..10).for_each(|p| nodes.set(p, Node { v: Vec2::ZERO, m: p as f32 }));
    let (mut out, calls) = (Field::<f32, Aos>::new([10]), std::sync::atomic::AtomicUsize::new(0));
    any_integer(&nodes, &mut out, &calls);
    for p in 0..10 {
        assert_eq!(out.get(p), 9.0 + p as f32 + 0.75);
    }
    assert_eq!(calls.into_inner(), 10);
}

/// At the top level, in a serial loop and in a serial loop inside a parallel one.
#[kernel]
fn serially(u: &mut Field<f32, _>, v: &mut Field<f32, _>) -> f32 {
    #[serial]
    for p in u {
        u[p] = u.clamped(p - 1) + u.wrapped(p + 1) + u.or(p + 1, 5.0);
    }
    for p in v {
        for q in u {
            v[p] += u.or(p + q, 1.0);
        }
    }
    u.wrapped(-1) + u.clamped(-1) + u.or(17, 0.5) + u.or(0, 0.5)
}

#[test]
fn boundary_rules_outside_of_parallel_loops() {
    let (mut u, mut v) = (Field::<f32, Aos>::new([3]), Field::<f32, Aos>::new([2]));
    (0..3).for_each(|p| u.set(p, 1.0 + p as f32));
    let sum = serially(&mut u, &mut v);
    // 1 + 2 + 2, 5 + 3 + 3, 11 + 5 + 5.
    assert_eq!(u.iter().collect::<Vec<_>>(), [5.0, 11.0, 21.0]);
    assert_eq!(v.iter().collect::<Vec<_>>(), [37.0, 33.0]);
    assert_eq!(sum, 21.0 + 5.0 + 0.5 + 5.0);
}

#[kernel]
fn nearest(empty: &Field<f32, _>, out: &mut Field<f32, _>) {
    for p in out {
        out[p] = empty.or(p, 2.0);
        if out[p] == 2.0 {
            out[p] = empty.clamped(p);
        }
    }
}

#[test]
fn a_field_without_elements_has_none_nearest() {
    let (empty, mut out) = (Field::<f32, Aos>::new([0]), Field::<f32, Aos>::new([1]));
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| nearest(&empty, &mut out))).unwrap_err();
    let text = panic.downcast_ref::<String>().expect("a message");
    for part in ["nearest", "`empty`", "index [0]", "[0]"] {
        assert!(text.contains(part), "{text}");
    }
    assert_eq!(out.get(0), 2.0);
}
