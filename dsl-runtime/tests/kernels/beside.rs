//! Reads of the other colour beside writes under `checkerboard`: the same as one element after another, in every layout.

use allotrope::prelude::*;

use super::Node;

/// One colour of a relaxation in place, the edges with values from outside.
#[kernel]
fn relax(u: &mut Field<f64, _, Ij>, colour: i32) {
    for (i, j) in u.checkerboard(colour) {
        let around = u.or((i - 1, j), 1.0) + u.or((i + 1, j), 2.0) + u.or((i, j - 1), 3.0) + u.or((i, j + 1), 4.0);
        u[(i, j)] += 0.5 * (0.25 * around - u[(i, j)]);
    }
}

#[kernel]
fn relax_clamped(u: &mut Field<f64, _, Ij>, colour: i32) {
    for ij in u.checkerboard(colour) {
        let before = u[ij];
        u[ij] = 7.0;
        // Where a neighbour is missing this is the element itself, with its new value.
        let around = u.clamped(ij - IVec2::X) + u.clamped(ij + IVec2::X) + 2.0 * u.clamped(ij + ivec2(0, -1));
        u[ij] = 0.25 * around + 0.1 * before;
    }
}

#[kernel]
fn relax_wrapped(u: &mut Field<f64, _, Ij>, colour: i32) {
    for (i, j) in u.checkerboard(colour) {
        let around = u.wrapped((i - 1, j)) + 2.0 * u.wrapped((i, j + 3)) + 3.0 * u.wrapped((i + 2, j - 1));
        u[(i, j)] = 0.1 * around + 0.5;
    }
}

/// Along one axis alone, so that the extent of the other does not matter.
#[kernel]
fn relax_wrapped_rows(u: &mut Field<f64, _, Ij>, colour: i32) {
    for (i, j) in u.checkerboard(colour) {
        u[(i, j)] = 0.5 * u.wrapped((i, j + 1)) + 0.25;
    }
}

/// Plain reads, within the interior: far ones too, and of whole records beside a member.
#[kernel]
fn relax_records(u: &mut Field<Node, _, Ij>, colour: i32) {
    for (i, j) in u.interior(2).checkerboard(colour) {
        let (left, right) = (u[(i - 1, j)], u[(i + 2, j + 1)]);
        u.v[(i, j)] = 0.5 * (left.v + right.v) + vec2(left.m, u.m[(i + 1, j + 1)]);
        u.v[(i, j)].y += u.v[(i, j - 1)].x;
    }
}

/// Over three axes.
#[kernel]
fn relax_volume(u: &mut Field<f32, _, Ijk>, colour: u8) {
    for ijk in u.interior(1).checkerboard(colour) {
        u[ijk] = 0.25 * (u[ijk + ivec3(1, 1, 1)] + u[ijk - IVec3::Z] + u[ijk - IVec3::ONE]) + 1.0;
    }
}

/// The same rule on one thread, over plain numbers.
fn serially(shape: [usize; 2], colour: usize, old: &[f64], rule: impl Fn(&[f64], i64, i64) -> f64) -> Vec<f64> {
    let mut u = old.to_vec();
    for (i, j) in (0..shape[0]).flat_map(|i| (0..shape[1]).map(move |j| (i, j))) {
        if (i + j) % 2 == colour {
            u[i * shape[1] + j] = rule(&u, i as i64, j as i64);
        }
    }
    u
}

const SHAPES: [[usize; 2]; 6] = [[1, 1], [1, 8], [5, 4], [7, 13], [16, 8], [34, 22]];

fn check<L: Layout<Ij>>(
    shape: [usize; 2],
    step: impl Fn(&mut Field<f64, L, Ij>, i32),
    rule: impl Fn(&[f64], i64, i64) -> f64,
) {
    let all = || (0..shape[0]).flat_map(|i| (0..shape[1]).map(move |j| [i, j]));
    let mut expected: Vec<f64> = (0..shape[0] * shape[1]).map(|n| (n * 37 % 19) as f64).collect();
    let mut u = Field::<f64, L>::new(shape);
    all().zip(&expected).for_each(|(at, value)| u.set(at, *value));
    for colour in [0, 1, 1, 0, 1] {
        step(&mut u, colour);
        expected = serially(shape, colour as usize, &expected, &rule);
        for (at, value) in all().zip(&expected) {
            assert_eq!(u.get(at), *value, "{at:?} of {shape:?}, colour {colour}");
        }
    }
}

fn rules<L: Layout<Ij>>(threads: usize) {
    let schedule = Schedule { threads, grain: 1, ..Schedule::default() };
    for shape in SHAPES {
        let (n, m) = (shape[0] as i64, shape[1] as i64);
        let at = |u: &[f64], i: i64, j: i64| u[(i * m + j) as usize];
        let or = |u: &[f64], i: i64, j: i64, value: f64| {
            if (0..n).contains(&i) && (0..m).contains(&j) { at(u, i, j) } else { value }
        };
        schedule.run(|| {
            check::<L>(shape, relax, |u, i, j| {
                let around = or(u, i - 1, j, 1.0) + or(u, i + 1, j, 2.0) + or(u, i, j - 1, 3.0) + or(u, i, j + 1, 4.0);
                at(u, i, j) + 0.5 * (0.25 * around - at(u, i, j))
            });
            check::<L>(shape, relax_clamped, |u, i, j| {
                let near = |i, j| or(u, i, j, 7.0);
                0.25 * (near(i - 1, j) + near(i + 1, j) + 2.0 * near(i, j - 1)) + 0.1 * at(u, i, j)
            });
            let wrapped = |u: &[f64], i: i64, j: i64| at(u, i.rem_euclid(n), j.rem_euclid(m));
            if n % 2 == 0 && m % 2 == 0 {
                check::<L>(shape, relax_wrapped, |u, i, j| {
                    let around = wrapped(u, i - 1, j) + 2.0 * wrapped(u, i, j + 3) + 3.0 * wrapped(u, i + 2, j - 1);
                    0.1 * around + 0.5
                });
            }
            if m % 2 == 0 {
                check::<L>(shape, relax_wrapped_rows, |u, i, j| 0.5 * wrapped(u, i, j + 1) + 0.25);
            }
        });
    }
}

#[test]
fn reads_of_the_other_colour_in_any_layout() {
    for threads in [1, 2, 3] {
        rules::<Aos>(threads);
        rules::<Soa>(threads);
        rules::<AoSoA<8>>(threads);
        rules::<Blocked<4>>(threads);
        rules::<layout!(dense(ji).dense(ij, (3, 5)).soa)>(threads);
    }
}

fn records<L: Layout<Ij>, V: Layout<Ijk>>(threads: usize) -> (Vec<Node>, Vec<f32>) {
    let mut u = Field::<Node, L>::new([19, 14]);
    let mut w = Field::<f32, V>::new([7, 6, 9]);
    for (i, j) in (0..19).flat_map(|i| (0..14).map(move |j| (i, j))) {
        let value = ((i * 31 + j * 17) % 23) as f32;
        u.set([i, j], Node { v: vec2(value, 1.0 - value), m: 0.5 * value });
    }
    for (i, j, k) in (0..7).flat_map(|i| (0..6).flat_map(move |j| (0..9).map(move |k| (i, j, k)))) {
        w.set([i, j, k], ((i * 5 + j * 3 + k) % 11) as f32);
    }
    Schedule { threads, grain: 1, ..Schedule::default() }.run(|| {
        for colour in [0, 1, 0] {
            relax_records(&mut u, colour);
            relax_volume(&mut w, colour as u8);
        }
    });
    (u.iter().collect(), w.iter().collect())
}

#[test]
fn records_and_volumes_are_the_same_on_any_threads() {
    let expected = records::<Aos, Aos>(1);
    assert!(expected.0[3 * 14 + 3].v != vec2(0.0, 0.0));
    for threads in [1, 2, 3] {
        assert_eq!(records::<Aos, Soa>(threads), expected);
        assert_eq!(records::<Soa, Aos>(threads), expected);
        assert_eq!(records::<AoSoA<8>, layout!(dense(ijk).dense(ijk, 4).soa)>(threads), expected);
        assert_eq!(records::<Blocked<4>, layout!(dense(kij).dense(ijk, (2, 3, 4)).split)>(threads), expected);
        assert_eq!(records::<layout!(dense(ij).morton(ij, 8).aos), Aos>(threads), expected);
    }
}

#[test]
fn odd_extents_are_not_wrapped() {
    fn message(shape: [usize; 2], step: impl FnOnce(&mut Field<f64, Aos, Ij>)) -> String {
        let mut u = Field::<f64, Aos>::new(shape);
        let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| step(&mut u))).unwrap_err();
        assert!(u.iter().all(|value| value == 0.0), "nothing has been written");
        panic.downcast_ref::<String>().expect("a message").clone()
    }
    let found = message([4, 5], |u| relax_wrapped_rows(u, 0));
    assert_eq!(
        found,
        "kernel `relax_wrapped_rows`: `wrapped` reads the field `u` under `checkerboard`, and its extent 5 along axis 1 is odd: \
         its first and its last element have one colour"
    );
    assert!(message([3, 4], |u| relax_wrapped(u, 1)).contains("extent 3 along axis 0 is odd"));
}
