//! Rows some of whose elements are active: whole ones are computed, and what is not active stays as it is.

use allotrope::prelude::*;

use super::Numbers;

#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Cell {
    u: f32,
    w: f32,
    n: u8,
    x: DVec2,
}

/// Arithmetic of floats alone, with a variable that is changed.
#[kernel]
fn smooth(cells: &mut Field<Cell, _, Ij>, dense: &mut Field<f32, _, Ij>, by: f32, times: i32) {
    for (i, j) in cells.interior(1) {
        let mut sum = cells.u[(i - 1, j)] + cells.u[(i + 1, j)] + cells.u[(i, j - 1)];
        sum += cells.u[(i, j + 1)].max(0.0).sqrt();
        cells.w[(i, j)] = (sum / by).max(sum * by) - i as f32 * (times / 2) as f32;
        cells.x[(i, j)].y += 2.0 * cells.x[(i, j)].x;
        dense[(i, j)] -= cells.u[(i, j)];
    }
}

/// Arithmetic of floats alone, of one row.
#[kernel]
fn scale(cells: &mut Field<Cell, _, Ij>, by: f32) {
    for p in cells {
        cells.u[p] *= by;
        cells.x[p] += vec2(by, 1.0).as_dvec2();
    }
}

/// Would panic where nothing is active: divides by zero.
#[kernel]
fn divide(cells: &mut Field<Cell, _, Ij>) {
    for (i, j) in cells.interior(1) {
        cells.n[(i, j)] = 100 / cells.n[(i, j)];
        cells.w[(i, j)] = cells.u[(i, j - 1)];
    }
}

/// Would panic where nothing is active, whose `u` is zero: by a division whose numbers are the same for all elements.
#[kernel]
fn guard(cells: &mut Field<Cell, _, Ij>, none: i32) {
    for p in cells {
        cells.w[p] = if cells.u[p] == 0.0 { (7 / none) as f32 } else { cells.u[p] };
    }
}

/// Would panic where nothing is active: `n` of those is zero.
#[kernel]
fn check(cells: &mut Field<Cell, _, Ij>) -> f32 {
    let mut total = 0.0;
    for p in cells {
        assert!(cells.n[p] > 0, "not active");
        cells.w[p] = cells.u[p];
        total += cells.u[p];
    }
    total
}

const SHAPE: [usize; 2] = [37, 45];

/// A third of the cells active, in clusters, with values of their own.
fn cells<L: Layout<Ij>>() -> Field<Cell, L, Ij> {
    let (mut cells, mut numbers) = (Field::<Cell, L>::new(SHAPE), Numbers(7));
    for _ in 0..60 {
        let start = [numbers.below(SHAPE[0]), numbers.below(SHAPE[1])];
        let end = [start[0] + numbers.below(6), start[1] + numbers.below(9)];
        for i in start[0]..end[0].min(SHAPE[0]) {
            for j in start[1]..end[1].min(SHAPE[1]) {
                let u = numbers.below(1000) as f32 - 300.5;
                let n = 1 + numbers.below(100) as u8;
                cells.set([i, j], Cell { u, w: 1.0, n, x: DVec2::new(u.into(), 0.5) });
            }
        }
    }
    // What was active once is no more, and holds the background.
    for _ in 0..80 {
        cells.deactivate([numbers.below(SHAPE[0]), numbers.below(SHAPE[1])]);
    }
    cells
}

/// All elements, and which are active.
fn all<L: Layout<Ij>>(cells: &Field<Cell, L, Ij>) -> Vec<(Cell, bool)> {
    let places = (0..SHAPE[0]).flat_map(|i| (0..SHAPE[1]).map(move |j| [i, j]));
    places.map(|at| (cells.get(at), cells.is_active(at))).collect()
}

fn check_in<L: Layout<Ij>, D: Layout<Ij>>() {
    let start = cells::<L>();
    let at = |i: usize, j: usize| start.get([i, j]);
    let active = |i: usize, j: usize| start.is_active([i, j]);
    let count = all(&start).iter().filter(|(_, active)| *active).count();
    assert!((200..1200).contains(&count), "{count}");
    for threads in [1, 3] {
        Schedule { threads, grain: 16, ..Schedule::default() }.run(|| {
            let (mut cells, mut dense) = (start.clone(), Field::<f32, D>::new(SHAPE).with_background(3.0));
            smooth(&mut cells, &mut dense, 1.5, 3);
            for (n, (cell, is_active)) in all(&cells).into_iter().enumerate() {
                let (i, j) = (n / SHAPE[1], n % SHAPE[1]);
                assert_eq!(is_active, active(i, j));
                let mut expected = at(i, j);
                let inside = (1..SHAPE[0] - 1).contains(&i) && (1..SHAPE[1] - 1).contains(&j);
                if is_active && inside {
                    let mut sum = at(i - 1, j).u + at(i + 1, j).u + at(i, j - 1).u;
                    sum += at(i, j + 1).u.max(0.0).sqrt();
                    expected.w = (sum / 1.5).max(sum * 1.5) - i as f32;
                    expected.x.y += 2.0 * expected.x.x;
                }
                assert_eq!(cell, expected, "({i}, {j})");
                let taken = if is_active && inside { at(i, j).u } else { 0.0 };
                assert_eq!(dense.get([i, j]), 3.0 - taken, "({i}, {j})");
            }
            let mut cells = start.clone();
            scale(&mut cells, 0.5);
            divide(&mut cells);
            guard(&mut cells, 0);
            let total = check(&mut cells);
            for (n, (cell, is_active)) in all(&cells).into_iter().enumerate() {
                let (i, j) = (n / SHAPE[1], n % SHAPE[1]);
                let mut expected = at(i, j);
                if is_active {
                    expected.u *= 0.5;
                    expected.x += DVec2::new(0.5, 1.0);
                    if (1..SHAPE[0] - 1).contains(&i) && (1..SHAPE[1] - 1).contains(&j) {
                        expected.n = 100 / expected.n;
                    }
                    expected.w = expected.u;
                } else {
                    assert_eq!(cell, Cell::default());
                }
                assert_eq!(cell, expected);
            }
            let expected: f32 = all(&cells).iter().map(|(cell, _)| cell.u).sum();
            assert!((total - expected).abs() < 0.5, "{total} and {expected}");
        });
    }
}

#[test]
fn rows_of_bits() {
    check_in::<layout!(pointer(ij).bitmasked(ij, 8).soa), Aos>();
    check_in::<layout!(pointer(ij).bitmasked(ij, 8).aos), layout!(dense(ij).dense(ij, 8).aos)>();
    check_in::<layout!(pointer(ij).bitmasked(ij, (4, 16)).split), Soa>();
    // Rows that cross the words of bits, and rows of one word.
    check_in::<layout!(pointer(ij).bitmasked(ij, (7, 13)).soa), Aos>();
    check_in::<layout!(bitmasked(ij).bitmasked(ij, (2, 64)).soa), layout!(dense(ij).dense(ij, (2, 64)).soa)>();
}
