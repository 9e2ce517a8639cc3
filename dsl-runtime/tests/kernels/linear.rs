//! Indices that are multiples of the loop's variables: checked once a launch, and the same elements as ever.

use allotrope::prelude::*;

/// Runs a test of fields with two axes in several layouts.
macro_rules! in_layouts {
    ($run:ident) => {
        $run::<Aos>();
        $run::<layout!(dense(ji).soa)>();
        $run::<Blocked<4>>();
        $run::<Morton<4>>();
    };
}

fn numbered<L: Layout<Ij>>(n: usize, m: usize) -> Field<f32, L, Ij> {
    let mut field = Field::<f32, L>::new([n, m]);
    (0..n).for_each(|i| (0..m).for_each(|j| field.set([i, j], (i * 100 + j) as f32)));
    field
}

#[kernel]
fn restrict(fine: &Field<f32, _, Ij>, coarse: &mut Field<f32, _, Ij>) {
    for (i, j) in coarse {
        let mut sum = fine[(2 * i, j * 2)] + fine[(2 * i + 1, 2 * j)];
        for (a, b) in unroll!(0..2, 1..2) {
            sum += fine[(a + 2 * i, b + 2 * j)];
        }
        coarse[(i, j)] = 0.25 * sum;
    }
}

#[kernel]
fn prolong(coarse: &Field<f32, _, Ij>, fine: &mut Field<f32, _, Ij>) {
    for (i, j) in coarse {
        for (a, b) in unroll!(0..2, 0..2) {
            fine[(2 * i + a, 2 * j + b)] += coarse[(i, j)];
        }
    }
}

#[test]
fn grids_of_half_the_size() {
    fn run<L: Layout<Ij>>() {
        let fine = numbered::<L>(10, 14);
        let mut coarse = Field::<f32, L>::new([5, 7]);
        restrict(&fine, &mut coarse);
        for i in 0..5 {
            for j in 0..7 {
                let sum: f32 =
                    [(0, 0), (1, 0), (0, 1), (1, 1)].iter().map(|(a, b)| fine.get([2 * i + a, 2 * j + b])).sum();
                assert_eq!(coarse.get([i, j]), 0.25 * sum);
            }
        }
        let mut back = Field::<f32, L>::new([10, 14]);
        prolong(&coarse, &mut back);
        assert_eq!(back.get([9, 12]), coarse.get([4, 6]));
    }
    in_layouts!(run);
}

#[kernel]
fn mixed(u: &Field<f32, _, Ij>, line: &Field<f32, _>, v: &mut Field<f32, _, Ij>, n: i32, shift: usize, back: &i32) {
    let (last, first) = (n - 1, back);
    for (i, j) in ndrange!(0..n, 0..n) {
        v[(j, i)] = u[(last - i, j + 3)] + line[3 * (i - 1) + 5] + u[(0, -j + 9)] + line[shift] + u[(j, i - first)];
    }
}

#[test]
fn reversed_shifted_and_fixed_places() {
    fn run<L: Layout<Ij>>() {
        let u = numbered::<L>(12, 13);
        let mut line = Field::<f32, Soa>::new([40]);
        (0..40).for_each(|i| line.set(i, i as f32 * 0.5));
        let mut v = Field::<f32, L>::new([9, 9]);
        mixed(&u, &line, &mut v, 9, 7, &-2);
        for i in 0..9i32 {
            for j in 0..9i32 {
                let at = |i: i32, j: i32| u.get([i, j]);
                let expected = at(8 - i, j + 3) + (3 * i + 2) as f32 * 0.5 + at(0, 9 - j) + 3.5 + at(j, i + 2);
                assert_eq!(v.get([j, i]), expected, "({i}, {j})");
            }
        }
    }
    in_layouts!(run);
}

/// Iterations that would leave the field pass by.
#[kernel]
fn guarded(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for i in v {
        if 2 * i + 1 < u.len() as i32 {
            v[i] = u[2 * i + 1];
        }
    }
}

#[kernel]
fn skipped(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for i in v {
        if 2 * i + 1 >= u.len() as i32 {
            continue;
        }
        v[i] = u[2 * i + 1];
    }
}

#[kernel]
fn shadowed(u: &Field<f32, _>, v: &mut Field<f32, _>, a: i32) {
    for i in v {
        let a = a.min(1);
        v[i] = u[2 * i + a];
    }
}

#[test]
fn what_iterations_pass_by_is_not_asked_for() {
    let (mut u, mut v, mut w) =
        (Field::<f32, Soa>::new([11]), Field::<f32, Soa>::new([11]), Field::<f32, Soa>::new([11]));
    (0..11).for_each(|i| u.set(i, i as f32));
    guarded(&u, &mut v);
    skipped(&u, &mut w);
    for i in 0..11 {
        let expected = if 2 * i + 1 < 11 { (2 * i + 1) as f32 } else { 0.0 };
        assert_eq!((v.get(i), w.get(i)), (expected, expected));
    }
    let mut few = Field::<f32, Soa>::new([5]);
    shadowed(&u, &mut few, 100);
    assert_eq!(few.get(4), 9.0);
}

#[kernel]
fn transpose(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in u {
        v[(j, i)] = u[(i, j)];
    }
}

#[kernel]
fn gather_transposed(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v {
        v[(i, j)] = u[(j, i)];
    }
}

/// What a panic says.
fn message(run: impl FnOnce()) -> String {
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(run)).expect_err("it panics");
    panic.downcast_ref::<String>().cloned().unwrap_or_default()
}

#[test]
fn what_lies_outside_is_told() {
    let (u, mut v) = (numbered::<Soa>(4, 6), Field::<f32, Soa>::new([6, 3]));
    let text = message(|| transpose(&u, &mut v));
    assert_eq!(text, "kernel `transpose`: index [0, 3] is out of range of field `v`, whose shape is [6, 3]");
    assert_eq!(v.get([0, 2]), 2.0 * 100.0);
    let mut v = Field::<f32, Soa>::new([7, 4]);
    let text = message(|| gather_transposed(&u, &mut v));
    assert_eq!(text, "kernel `gather_transposed`: index [0, 6] is out of range of field `u`, whose shape is [4, 6]");
    let (line, mut short) = (Field::<f32, Soa>::new([6]), Field::<f32, Soa>::new([4]));
    assert!(message(|| shadowed(&line, &mut short, i32::MAX)).contains("index [7] is out of range of field `u`"));
    let mut none = Field::<f32, Soa>::new([0]);
    shadowed(&line, &mut none, i32::MAX);
}
