//! `Colored`: sorted by what is updated, without losing or changing anything.

use allotrope::prelude::*;

/// A point that carries a weight to the cells around it.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Point {
    x: Vec2,
    weight: f32,
}

/// What arrives at a cell.
#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Node {
    mass: f32,
    count: u32,
    most: i64,
}

/// Spreads weights over three by three cells; also the sum of all weights.
#[kernel]
fn spread(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>) -> f32 {
    let mut total = 0.0;
    for p in points {
        let x = points.x[p];
        if x.x < 0.0 {
            continue;
        }
        let base = (x - 0.5).as_ivec2();
        let fx = x - base.as_vec2();
        for (i, j) in unroll!(0..3, 0..3) {
            let offset = ivec2(i, j);
            let distance = (offset.as_vec2() - fx).length();
            grid.mass[base + offset] += points.weight[p] * distance;
            grid.count[base + offset] += 1;
            grid.most[base + offset].max_assign(i64::from(p));
        }
        total += points.weight[p];
    }
    total
}

/// The same with a reach that is too small, and a key far from most of what is updated.
#[kernel]
fn spread_with_lies(points: &Field<Point, _>, grid: &mut Field<Node, _, Ij>) -> f32 {
    let mut total = 0.0;
    #[scatter(Colored, key = ivec2(p % 7, 3), reach = 0)]
    for p in points {
        let x = points.x[p];
        if x.x >= 0.0 {
            let base = (x - 0.5).as_ivec2();
            let fx = x - base.as_vec2();
            for (i, j) in unroll!(0..3, 0..3) {
                let offset = ivec2(i, j);
                let distance = (offset.as_vec2() - fx).length();
                grid.mass[base + offset] += points.weight[p] * distance;
                grid.count[base + offset] += 1;
                grid.most[base + offset].max_assign(i64::from(p));
            }
            total += points.weight[p];
        }
    }
    total
}

/// Points that are no nearer to each other than the grid's cells allow, in an order that has nothing to do with where they are.
fn points<L: Layout<I>>(count: usize, [m, n]: [usize; 2]) -> Field<Point, L> {
    let mut points = Field::new([count]);
    for p in 0..count {
        let at = |by: u64, extent: usize| (p as u64 * by % 10_007) as f32 / 10_007.0 * (extent as f32 - 4.0) + 1.0;
        let x = if p % 11 == 3 { vec2(-1.0, 0.0) } else { vec2(at(7919, m), at(104_729, n)) };
        points.set(p, Point { x, weight: 1.0 + (p % 5) as f32 * 0.3 });
    }
    points
}

type Kernel<L, G> = fn(&Field<Point, L>, &mut Field<Node, G, Ij>) -> f32;

fn result<L: Layout<I>, G: Layout<Ij>>(
    kernel: Kernel<L, G>,
    schedule: Schedule,
    count: usize,
    shape: [usize; 2],
) -> (f32, Vec<Node>) {
    let (points, mut grid) = (points::<L>(count, shape), Field::<Node, G>::new(shape));
    let total = schedule.run(|| kernel(&points, &mut grid));
    (total, grid.iter().collect())
}

/// Compares a kernel under `Colored` with the serial one, and its bits on several numbers of threads.
fn agrees<L: Layout<I>, G: Layout<Ij>>(kernel: Kernel<L, G>) {
    for (count, shape) in [(4000, [64, 48]), (700, [9, 200]), (1, [4, 4]), (30_000, [300, 5])] {
        let serial = Schedule { scatter: Scatter::Serial, threads: 1, ..Schedule::default() };
        let (total, expected) = result::<L, G>(spread, serial, count, shape);
        let mut first: Option<(f32, Vec<Node>)> = None;
        for (threads, deterministic) in [(1, false), (2, false), (3, true), (8, true), (16, true)] {
            let schedule =
                Schedule { scatter: Scatter::Colored, threads, deterministic, grain: 64, ..Schedule::default() };
            let found = result::<L, G>(kernel, schedule, count, shape);
            assert!((found.0 - total).abs() <= 1e-5 * total, "{} is the sum of all, {total}", found.0);
            for (found, expected) in found.1.iter().zip(&expected) {
                assert_eq!(
                    (found.count, found.most),
                    (expected.count, expected.most),
                    "{count} points, {threads} threads"
                );
                assert!((found.mass - expected.mass).abs() <= 1e-5 * expected.mass, "{found:?} is {expected:?}");
            }
            match &first {
                Some(first) => {
                    assert_eq!(first.0.to_bits(), found.0.to_bits(), "{threads} threads");
                    let bits = |nodes: &[Node]| nodes.iter().map(|node| node.mass.to_bits()).collect::<Vec<_>>();
                    assert!(bits(&first.1) == bits(&found.1), "the same bits on {threads} threads");
                }
                None => first = Some(found),
            }
        }
    }
}

#[test]
fn nothing_is_lost_and_bits_do_not_depend_on_threads() {
    agrees::<Aos, Aos>(spread);
    #[cfg(not(allotrope_sanitized))]
    agrees::<AoSoA<8>, Blocked<4>>(spread);
}

#[test]
fn a_wrong_key_and_reach_change_no_sum() {
    agrees::<Aos, Blocked<4>>(spread_with_lies);
}

/// Stencils around the own index need no sorting by values.
#[kernel]
fn diffuse(u: &Field<f64, _, Ij>, v: &mut Field<f64, _, Ij>) {
    for ij in u.interior(2) {
        v[ij] -= 4.0 * u[ij];
        v[ij + ivec2(2, 0)] += u[ij];
        v[ij + ivec2(-2, 0)] += u[ij];
        v[ij + ivec2(0, 1)] += u[ij];
        v[ij + ivec2(0, -1)] += u[ij];
    }
}

/// Three axes, integers, and a loop over ranges.
#[kernel]
fn mark(marks: &mut Field<u32, _, Ijk>, n: i32) {
    for (a, b) in ndrange!(0..n, 0..2 * n) {
        marks[((a * 7 + b) % n, b % n, a)] += 1;
        marks[(a, b % n, (a + b) % n)] += 3;
    }
}

#[test]
fn own_indices_and_ranges() {
    let diffused = |schedule: Schedule| {
        let mut u = Field::<f64, Blocked<4>>::new([70, 51]);
        let mut v = Field::<f64, Soa>::new([70, 51]);
        for (at, value) in (0..70 * 51).map(|n| ((n / 51, n % 51), f64::from(n * n % 97))) {
            u.set(at, value);
        }
        schedule.run(|| diffuse(&u, &mut v));
        v.to_vec()
    };
    let marked = |schedule: Schedule| {
        let mut marks = Field::<u32, Aos>::new([33, 33, 33]);
        schedule.run(|| mark(&mut marks, 33));
        marks.to_vec()
    };
    let serial = Schedule { scatter: Scatter::Serial, ..Schedule::default() };
    let (values, marks) = (diffused(serial), marked(serial));
    for threads in [1, 2, 5] {
        let schedule = Schedule { scatter: Scatter::Colored, threads, grain: 16, ..Schedule::default() };
        // Sums of small integers are exact.
        assert_eq!(diffused(schedule), values, "{threads} threads");
        assert_eq!(marked(schedule), marks, "{threads} threads");
    }
}

/// What a loop does to its own elements happens once, whatever its key reads.
#[kernel]
fn move_and_count(points: &mut Field<Point, _>, counts: &mut Field<u32, _, I>) {
    for p in points {
        points.weight[p] += 1.0;
        let at = points.weight[p];
        points.x[p] += 1.0;
        counts[at as i32 + 2] += 1;
    }
}

#[test]
fn own_writes_happen_once() {
    let mut points = Field::<Point, AoSoA<4>>::new([1000]);
    for p in 0..1000 {
        points.set(p, Point { x: Vec2::ZERO, weight: (p * 31 % 90) as f32 });
    }
    let before: Vec<Point> = points.iter().collect();
    let mut counts = Field::<u32, Aos>::new([100]);
    let schedule = Schedule { scatter: Scatter::Colored, threads: 3, grain: 10, ..Schedule::default() };
    schedule.run(|| move_and_count(&mut points, &mut counts));
    for (point, before) in points.iter().zip(&before) {
        assert_eq!(point, Point { x: Vec2::ONE, weight: before.weight + 1.0 });
    }
    assert_eq!(counts.to_vec().iter().sum::<u32>(), 1000);
    assert_eq!(counts.get(3), 1000u32.div_ceil(90));
}

/// A caller promises that indices lie in the field, not that they lie in a tile.
#[kernel(unchecked)]
fn scatter_unchecked(to: &Field<u32, _>, counts: &mut Field<u32, _>) {
    #[scatter(Colored, key = to[e] % 7)]
    for e in to {
        counts[to[e]] += 1;
    }
}

#[test]
fn promised_indices_may_lie_outside_of_tiles() {
    let mut to = Field::<u32, Soa>::new([20_000]);
    (0..20_000).for_each(|e| to.set(e, (e * 7919 % 30_000) as u32));
    let mut counts = Field::<u32, Soa>::new([30_000]);
    let schedule = Schedule { threads: 3, grain: 100, ..Schedule::default() };
    // SAFETY: all are below 30,000.
    schedule.run(|| unsafe { scatter_unchecked(&to, &mut counts) });
    let mut expected = vec![0; 30_000];
    to.iter().for_each(|at| expected[at as usize] += 1);
    assert_eq!(counts.to_vec(), expected);
}

/// A field without bounds: tiles lie where the points are.
#[test]
fn unbounded_fields_have_tiles() {
    let points = points::<Aos>(20_000, [200, 200]);
    let mut dense = Field::<Node, Aos>::new([200, 200]);
    let mut sparse = Field::<Node, layout!(hash(ij).dense(ij, 8).aos), Ij>::unbounded();
    let serial = Schedule { scatter: Scatter::Serial, ..Schedule::default() };
    let total = serial.run(|| spread(&points, &mut dense));
    for scatter in [Scatter::Colored, Scatter::Auto] {
        sparse.clear();
        let schedule = Schedule { scatter, threads: 3, deterministic: true, grain: 64, ..Schedule::default() };
        let found = schedule.run(|| spread(&points, &mut sparse));
        assert!((found - total).abs() <= 1e-5 * total, "{found} is {total}");
        for at in (0..200).flat_map(|i| (0..200).map(move |j| ivec2(i, j))) {
            let (found, expected) = (sparse.get(at), dense.get(at));
            assert_eq!((found.count, found.most), (expected.count, expected.most), "{scatter} at {at}");
            assert!((found.mass - expected.mass).abs() <= 1e-5 * expected.mass, "{found:?} is {expected:?}");
        }
    }
}

/// An index beyond the field is no update to be kept for later.
#[test]
fn indices_beyond_the_field_panic() {
    let mut points = Field::<Point, Aos>::new([10]);
    points.set(7, Point { x: vec2(40.0, 2.0), weight: 1.0 });
    let mut grid = Field::<Node, Aos>::new([8, 8]);
    let schedule = Schedule { scatter: Scatter::Colored, threads: 2, ..Schedule::default() };
    let run = std::panic::AssertUnwindSafe(|| schedule.run(|| spread(&points, &mut grid)));
    let panic = std::panic::catch_unwind(run).expect_err("cell 39 lies beyond");
    let message = panic.downcast_ref::<String>().expect("a message");
    assert!(
        message.contains("kernel `spread`") && message.contains("`grid`") && message.contains("[8, 8]"),
        "{message}"
    );
}
