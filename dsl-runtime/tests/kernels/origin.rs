//! Fields whose indices begin below zero, or anywhere: every head and every view speaks of the same indices.

use allotrope::prelude::*;

const N: i32 = 11;
const M: i32 = 9;

/// Runs a test in several layouts.
macro_rules! in_layouts {
    ($run:ident) => {
        $run::<Aos>();
        $run::<layout!(dense(ji).soa)>();
        $run::<Blocked<4>>();
        $run::<Morton<4>>();
        $run::<layout!(dense(ij).dense(j, 3).aos)>();
    };
}

/// Where fields begin: aligned with blocks and not.
const ORIGINS: [(i32, i32); 5] = [(0, 0), (-3, -3), (-4, 8), (5, -7), (-100, 1000)];

/// A field of what each index is.
fn indices<L: Layout<Ij>>((i, j): (i32, i32)) -> Field<i32, L, Ij> {
    let mut field = Field::<i32, L>::new([N as usize, M as usize]).with_origin((i, j));
    for (a, b) in all((i, j)) {
        field.set((a, b), value(a, b));
    }
    field
}

fn value(i: i32, j: i32) -> i32 {
    i * 10_000 + j
}

/// All indices of a field that begins there.
fn all((i, j): (i32, i32)) -> impl Iterator<Item = (i32, i32)> {
    (i..i + N).flat_map(move |a| (j..j + M).map(move |b| (a, b)))
}

#[kernel]
fn tell_indices(u: &mut Field<i32, _, Ij>) {
    for ij in u {
        u[ij] = ij.x * 10_000 + ij.y;
    }
}

#[kernel]
fn heads(u: &mut Field<i32, _, Ij>, colour: i32) {
    for (i, j) in u.interior(2) {
        u[(i, j)] += 1;
    }
    for (i, j) in u.border(1) {
        u[(i, j)] += 10;
    }
    for (i, j) in u.checkerboard(colour) {
        u[(i, j)] += 100;
    }
    for ij in u.interior(1).colored(2, colour) {
        u[ij] += 1000;
    }
    #[serial]
    for (i, j) in u.interior(3) {
        u[(i, j)] += 10_000;
    }
}

#[test]
fn heads_run_over_the_field_s_own_indices() {
    fn run<L: Layout<Ij>>() {
        for origin in ORIGINS {
            let mut u = Field::<i32, L>::new([N as usize, M as usize]).with_origin(origin);
            tell_indices(&mut u);
            assert!(all(origin).all(|(i, j)| u.get((i, j)) == value(i, j)), "{origin:?}");
            for colour in [0, 1] {
                u.fill(0);
                heads(&mut u, colour);
                for (i, j) in all(origin) {
                    let (a, b) = (i - origin.0, j - origin.1);
                    let inside = |width: i32| (width..N - width).contains(&a) && (width..M - width).contains(&b);
                    let expected = i32::from(inside(2))
                        + 10 * i32::from(!inside(1))
                        + 100 * i32::from((i ^ j) & 1 == colour)
                        + 1000 * i32::from(inside(1) && i.rem_euclid(2) == 0 && j.rem_euclid(2) == colour)
                        + 10_000 * i32::from(inside(3));
                    assert_eq!(u.get((i, j)), expected, "({i}, {j}) from {origin:?} in {}", std::any::type_name::<L>());
                }
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn stencil(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>) {
    for (i, j) in v.interior(1) {
        v[(i, j)] = u[(i, j)] + 3 * u[(i - 1, j)] + 5 * u[(i, j + 1)] + 7 * u[(i + 1, j - 1)];
    }
}

#[test]
fn two_fields_of_different_origins_meet_at_the_same_indices() {
    fn run<L: Layout<Ij>, K: Layout<Ij>>() {
        // The second field holds all that the loop over the first asks for.
        for (a, b) in [((0, 0), (0, 0)), ((-3, -3), (-4, -4)), ((-4, 8), (-8, 4)), ((5, -7), (4, -6)), ((2, 2), (0, 1))]
        {
            let mut big = Field::<i32, L>::new([20, 20]).with_origin(b);
            for i in b.0..b.0 + 20 {
                (b.1..b.1 + 20).for_each(|j| big.set((i, j), value(i, j)));
            }
            let mut v = Field::<i32, K>::new([N as usize, M as usize]).with_origin(a);
            if a.0 < b.0 || a.1 < b.1 {
                continue;
            }
            stencil(&big, &mut v);
            for (i, j) in all(a) {
                let inside = (a.0 + 1..a.0 + N - 1).contains(&i) && (a.1 + 1..a.1 + M - 1).contains(&j);
                let at = value;
                let sum = at(i, j) + 3 * at(i - 1, j) + 5 * at(i, j + 1) + 7 * at(i + 1, j - 1);
                assert_eq!(v.get((i, j)), if inside { sum } else { 0 }, "({i}, {j}) from {a:?} and {b:?}");
            }
        }
    }
    run::<Aos, Aos>();
    run::<Blocked<4>, Blocked<4>>();
    run::<Morton<4>, Morton<4>>();
    run::<Soa, Blocked<4>>();
    run::<layout!(dense(ji).dense(ij, 4).aos), layout!(dense(ij).dense(ij, 4).soa)>();
}

#[kernel]
fn boundaries(u: &Field<i32, _, Ij>, v: &mut Field<IVec3, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = ivec3(u.clamped((i - 2, j + 3)), u.wrapped((i + 20, j - 7)), u.or((i + 4, j), -1));
    }
}

#[kernel]
fn places(u: &Field<i32, _, Ij>, v: &mut Field<i32, _, Ij>, w: &mut Field<i32, _, Ij>, n: i32) {
    for (i, j) in u {
        v[(j, i)] = u[(i, j)];
    }
    for (i, j) in ndrange!(-3..n, -3..n) {
        w[(i, j)] += u[(2 * i + 3, j)] + u[(i, -j)];
    }
}

#[kernel]
fn accumulate(at: &Field<IVec2, _>, sums: &mut Field<i32, _, Ij>) {
    for p in at {
        let base = at[p];
        for (a, b) in unroll!(-1..2, -1..2) {
            sums[base + ivec2(a, b)] += 10 * a + b + 100;
        }
    }
}

#[kernel]
fn relax(u: &mut Field<i32, _, Ij>) {
    for (i, j) in u.interior(1).checkerboard(1) {
        u[(i, j)] = u[(i - 1, j)] + u[(i, j + 1)];
    }
}

#[test]
fn every_view_reads_and_writes_the_same_indices() {
    fn run<L: Layout<Ij>>() {
        for origin in ORIGINS {
            let u = indices::<L>(origin);
            let mut v = Field::<IVec3, L>::new([N as usize, M as usize]).with_origin(origin);
            boundaries(&u, &mut v);
            let (n, m) = (N, M);
            for (i, j) in all(origin) {
                let (a, b) = (i - origin.0, j - origin.1);
                let clamped = value((a - 2).max(0) + origin.0, (b + 3).min(m - 1) + origin.1);
                let wrapped = value((a + 20).rem_euclid(n) + origin.0, (b - 7).rem_euclid(m) + origin.1);
                let or = if a + 4 < n { value(i + 4, j) } else { -1 };
                assert_eq!(v.get((i, j)), ivec3(clamped, wrapped, or), "({i}, {j}) from {origin:?}");
            }

            let mut turned = Field::<i32, L>::new([M as usize, N as usize]).with_origin((origin.1, origin.0));
            let mut none = Field::<i32, L>::new([1, 1]);
            places(&u, &mut turned, &mut none, -3);
            assert!(all(origin).all(|(i, j)| turned.get((j, i)) == value(i, j)));

            let mut at = Field::<IVec2, Soa>::new([300]);
            (0..300).for_each(|p| at.set(p, ivec2(origin.0 + 1 + p % (N - 2), origin.1 + 1 + p * p % (M - 2))));
            for scatter in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
                let mut sums = Field::<i32, L>::new([N as usize, M as usize]).with_origin(origin);
                Schedule { threads: 2, scatter, ..Schedule::default() }.run(|| accumulate(&at, &mut sums));
                for (i, j) in all(origin) {
                    let part = |base: IVec2| {
                        let (a, b) = (i - base.x, j - base.y);
                        if a.abs() < 2 && b.abs() < 2 { 10 * a + b + 100 } else { 0 }
                    };
                    assert_eq!(sums.get((i, j)), at.iter().map(part).sum::<i32>());
                }
            }

            let mut relaxed = indices::<L>(origin);
            relax(&mut relaxed);
            for (i, j) in all(origin) {
                let (a, b) = (i - origin.0, j - origin.1);
                let changed = (1..n - 1).contains(&a) && (1..m - 1).contains(&b) && (i ^ j) & 1 == 1;
                let expected = if changed { value(i - 1, j) + value(i, j + 1) } else { value(i, j) };
                assert_eq!(relaxed.get((i, j)), expected);
            }
        }
        let u = {
            let mut u = Field::<i32, L>::new([N as usize, M as usize]).with_origin((-4, -4));
            tell_indices(&mut u);
            u
        };
        let (mut turned, mut w) = (
            Field::<i32, L>::new([M as usize, N as usize]).with_origin((-4, -4)),
            Field::<i32, L>::new([N as usize, M as usize]).with_origin((-4, -4)),
        );
        places(&u, &mut turned, &mut w, 2);
        for (i, j) in all((-4, -4)) {
            let inside = (-3..2).contains(&i) && (-3..2).contains(&j);
            let expected = if inside { value(2 * i + 3, j) + value(i, -j) } else { 0 };
            assert_eq!(w.get((i, j)), expected);
        }
    }
    in_layouts!(run);
}

/// What a panic says.
fn message(run: impl FnOnce()) -> String {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).expect_err("it panics");
    panic.downcast_ref::<String>().cloned().unwrap_or_default()
}

#[test]
fn what_lies_outside_is_told_with_the_indices_there_are() {
    fn run<L: Layout<Ij>>() {
        let u = indices::<L>((-3, 2));
        let mut v = Field::<i32, L>::new([N as usize, M as usize]).with_origin((-2, 2));
        let text = message(|| stencil(&u, &mut v));
        assert!(
            text.starts_with("kernel `stencil`: index [")
                && text.ends_with(
                    "is out of range of field `u`, whose shape is [11, 9] and whose indices are -3..8, 2..11"
                ),
            "{text}"
        );
        let text = message(|| {
            u.get((0, 0));
        });
        assert!(
            text.ends_with("index [0, 0] is out of range of shape [11, 9], whose indices are -3..8, 2..11"),
            "{text}"
        );
    }
    run::<Aos>();
    run::<Blocked<4>>();
}

#[test]
fn fields_keep_their_origin() {
    let u = indices::<Soa>((-3, 40));
    let blocks = u.relayout::<Blocked<4>>();
    assert_eq!((blocks.origin(), u.clone().origin()), (ivec2(-3, 40), ivec2(-3, 40)));
    assert!(all((-3, 40)).all(|at| blocks.get(at) == u.get(at)));
    let mut there = Field::<i32, Morton<4>>::new([N as usize, M as usize]).with_origin((7, 7));
    there.copy_from(&u);
    assert_eq!((there.origin(), there.get((7, 7))), (ivec2(7, 7), value(-3, 40)));
    assert_eq!(there.members().0.get((8, 9)), value(-2, 42));
    let mut line = Field::<u32, Soa>::new([5]).with_origin(-2);
    (-2i32..3).for_each(|i| line.set(i, (2 - i) as u32));
    line.reorder_by_key(|value| *value);
    assert_eq!((line.origin(), line.get(-2), line.get(2)), (-2, 0, 4));
    let mut numbers = Field::<f32, Blocked<4>>::new([5, 5]).with_origin((-2, -2));
    numbers.set((1, -1), f32::NAN);
    assert_eq!(numbers.find_nonfinite().expect("a number that is none").index, ivec2(1, -1));
}
