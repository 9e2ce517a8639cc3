//! `unroll!`, and bases that are checked once.

use allotrope::prelude::*;

#[kernel]
fn digits(u: &mut Field<i32, _>) {
    for p in u {
        let mut code = 0;
        for (a, b) in unroll!(-1..2, 5..=6) {
            if a == 0 {
                continue;
            }
            code = 10 * code + a + b;
        }
        for a in unroll!(0..4) {
            if a == 2 && p == 1 {
                break;
            }
            code += 10_000 * a;
        }
        'outer: for a in unroll!(0..3) {
            for b in 0..3 {
                if a + b == 3 {
                    continue 'outer;
                }
                if a == 2 {
                    break 'outer;
                }
                code += 1_000_000;
            }
        }
        for _ in unroll!(0..0) {
            code = 0;
        }
        u[p] = code;
    }
}

#[test]
fn jumps_in_unrolled_loops() {
    let mut u = Field::<i32, Aos>::new([2]);
    digits(&mut u);
    assert_eq!(u.iter().collect::<Vec<_>>(), [5_064_567, 5_014_567]);
}

/// A sum over neighbours from a base that may lie at the border.
#[kernel]
fn gather(u: &Field<i32, _, Ij>, at: &Field<IVec2, _>, sums: &mut Field<i32, _>, side: i32) {
    for p in at {
        let base = at[p];
        let mut sum = 0;
        for (i, j) in unroll!(-1..2, -1..2) {
            let offset = ivec2(i, j + 1);
            let near = base + offset;
            if near.cmplt(IVec2::ZERO).any() || near.cmpge(IVec2::splat(side)).any() {
                continue;
            }
            sum += u[base + offset] + 1000 * u[base + ivec2(i, j + 1)];
        }
        sums[p] = sum;
    }
}

#[kernel]
fn scatter(u: &mut Field<i32, _, Ij>, at: &Field<IVec2, _>, side: i32) {
    for p in at {
        let base = at[p];
        for (i, j) in unroll!(-1..2, 0..3) {
            let near = base + ivec2(i, j);
            if near.min_element() >= 0 && near.max_element() < side {
                u[base + ivec2(i, j)] += 1;
            }
        }
    }
}

#[test]
fn bases_at_the_border_are_checked_one_by_one() {
    fn run<L: Layout<Ij>>() {
        let side = 6;
        let mut at = Field::<IVec2, Soa>::new([36]);
        (0..36).for_each(|p| at.set(p, ivec2(p / 6, p % 6)));
        let mut u = Field::<i32, L>::new([6, 6]);
        scatter(&mut u, &at, side);
        let count = |i: i32, j: i32| {
            let near =
                |c: i32, low: i32, high: i32| (low..high).filter(|d| (0..side).contains(&(c - d))).count() as i32;
            near(i, -1, 2) * near(j, 0, 3)
        };
        assert!((0..36).all(|p| u.get((p / 6, p % 6)) == count(p / 6, p % 6)));
        let mut sums = Field::<i32, Aos>::new([36]);
        gather(&u, &at, &mut sums, side);
        for p in 0..36 {
            let inside = (-1..2).flat_map(|i| (0..3).map(move |j| (p / 6 + i, p % 6 + j)));
            let inside = inside.filter(|(i, j)| (0..side).contains(i) && (0..side).contains(j));
            assert_eq!(sums.get(p), 1001 * inside.map(|(i, j)| u.get((i, j))).sum::<i32>(), "{p}");
        }
    }
    run::<Aos>();
    run::<layout!(dense(ij).dense(ij, (4, 2)).soa)>();
}

#[kernel]
fn windows(u: &Field<i32, _>, v: &mut Field<i32, _>, grid: &Field<i32, _, Ij>, w: &mut Field<i32, _>) {
    for p in v.interior(2) {
        for a in unroll!(-2..3) {
            v[p] += u[p + a];
        }
    }
    for p in w {
        let base = ivec2(1, p);
        for a in unroll!(0..2) {
            w[p] += grid[base + a];
        }
    }
}

#[test]
fn bases_over_one_axis_and_scalars_added_to_vectors() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([9]), Field::<i32, Aos>::new([9]));
    (0..9).for_each(|i| u.set(i, i));
    let (mut grid, mut w) = (Field::<i32, Aos>::new([4, 4]), Field::<i32, Aos>::new([3]));
    (0..16).for_each(|i| grid.set((i / 4, i % 4), i));
    windows(&u, &mut v, &grid, &mut w);
    assert_eq!(v.iter().collect::<Vec<_>>(), [0, 0, 10, 15, 20, 25, 30, 0, 0]);
    assert_eq!(w.iter().collect::<Vec<_>>(), [13, 15, 17]);
}
