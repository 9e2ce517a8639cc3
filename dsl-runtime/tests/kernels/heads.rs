//! Borders and colours: each element of the part once, none else, for every layout, shape and number of threads.

use allotrope::prelude::*;

#[kernel]
fn borders(u: &mut Field<u32, _, Ij>, width: u32) {
    for ij in u.border(width) {
        u[ij] += 1;
    }
}

#[kernel]
fn checkerboards(u: &mut Field<u32, _, Ij>, width: u32, colour: u8) {
    for (i, j) in u.checkerboard(colour) {
        u[(i, j)] += 1;
    }
    for ij in u.interior(width).checkerboard(colour) {
        u[ij] += 10;
    }
    for ij in u.border(width).checkerboard(1 - colour) {
        u[ij] += 100;
    }
}

#[kernel]
fn colours(u: &mut Field<u32, _, Ij>, width: u32, n: usize, colour: i64) -> u32 {
    let mut visited = 0;
    for ij in u.colored(n, colour) {
        u[ij] += 1;
        visited += 1u32;
    }
    for (i, j) in u.interior(width).colored(n, colour) {
        u[(i, j)] += 10;
    }
    visited
}

/// The same in serial loops, at the top level and inside of parallel ones.
#[kernel]
fn serially(u: &mut Field<u32, _, Ij>, sums: &mut Field<u32, _>, width: u32, n: i32, colour: i32) {
    #[serial]
    for ij in u.border(width) {
        u[ij] += 1;
    }
    #[serial]
    for (i, j) in u.interior(width).checkerboard(colour & 1) {
        u[(i, j)] += 10;
    }
    #[serial]
    for ij in u.colored(n, colour) {
        u[ij] += 100;
    }
    for p in sums {
        for (i, j) in u.border(width) {
            sums[p] += u[(i, j)];
        }
        for ij in u.colored(n, colour) {
            sums[p] += u[ij];
        }
    }
}

const SHAPES: [[usize; 2]; 9] = [[1, 1], [1, 9], [2, 2], [3, 3], [5, 4], [7, 13], [16, 8], [33, 2], [19, 23]];

fn inside(at: [usize; 2], shape: [usize; 2], width: u32) -> bool {
    let w = width as usize;
    (0..2).all(|a| at[a] >= w && at[a] + w < shape[a])
}

/// Asserts that a field holds what a plain loop says.
#[track_caller]
fn holds<L: Layout<Ij>>(u: &Field<u32, L, Ij>, what: &str, expected: impl Fn([usize; 2]) -> u32) {
    let [n, m] = u.shape();
    for at in (0..n).flat_map(|i| (0..m).map(move |j| [i, j])) {
        assert_eq!(u.get(at), expected(at), "{at:?} of {n} x {m}, {what}");
    }
}

fn parts<L: Layout<Ij>>(threads: usize) {
    let schedule = Schedule { threads, grain: 1, ..Schedule::default() };
    schedule.run(|| {
        for (shape, width) in SHAPES.into_iter().flat_map(|shape| (0..4).map(move |width| (shape, width))) {
            let new = || Field::<u32, L>::new(shape);
            let mut u = new();
            borders(&mut u, width);
            holds(&u, &format!("border {width}"), |at| u32::from(!inside(at, shape, width)));
            for colour in 0..2u8 {
                let mut u = new();
                checkerboards(&mut u, width, colour);
                holds(&u, &format!("border {width}, colour {colour}"), |at| {
                    let (own, inside) = ((at[0] + at[1]) % 2 == usize::from(colour), inside(at, shape, width));
                    u32::from(own) + 10 * u32::from(own && inside) + 100 * u32::from(!own && !inside)
                });
            }
            for n in 1..4usize {
                for colour in 0..n * n {
                    let mut u = new();
                    let visited = colours(&mut u, width, n, colour as i64);
                    let own = |at: [usize; 2]| at[0] % n * n + at[1] % n == colour;
                    holds(&u, &format!("border {width}, colour {colour} of {n}"), |at| {
                        u32::from(own(at)) + 10 * u32::from(own(at) && inside(at, shape, width))
                    });
                    assert_eq!(visited, u.iter().filter(|count| count % 10 == 1).count() as u32);
                }
            }
        }
    });
}

#[test]
fn parts_are_visited_once_in_any_layout() {
    for threads in [1, 2, 3, 8] {
        parts::<Aos>(threads);
        parts::<Blocked<4>>(threads);
        parts::<layout!(dense(ji).dense(ij, (3, 5)).soa)>(threads);
        parts::<AoSoA<8>>(threads);
    }
}

#[test]
fn parts_in_serial_loops() {
    let (shape, width) = ([7, 6], 2);
    let (mut u, mut sums) = (Field::<u32, Blocked<4>>::new(shape), Field::<u32, Aos>::new([3]));
    serially(&mut u, &mut sums, width, 3, 5);
    let coloured = |at: [usize; 2]| at[0] % 3 == 1 && at[1] % 3 == 2;
    let value = |at: [usize; 2]| {
        let inner = inside(at, shape, width);
        u32::from(!inner) + 10 * u32::from(inner && (at[0] + at[1]) % 2 == 1) + 100 * u32::from(coloured(at))
    };
    holds(&u, "serially", value);
    let all = || (0..7).flat_map(|i| (0..6).map(move |j| [i, j]));
    let border: u32 = all().filter(|at| !inside(*at, shape, width)).map(value).sum();
    let colour: u32 = all().filter(|at| coloured(*at)).map(value).sum();
    assert!(sums.iter().all(|sum| sum == border + colour), "{sums:?}");
}

/// Rows with offsets, in parts of a field.
#[kernel]
fn black(u: &Field<f64, _, Ijk>, v: &mut Field<f64, _, Ijk>, colour: i32) {
    for (i, j, k) in v.interior(1).checkerboard(colour) {
        v[(i, j, k)] = u[(i - 1, j, k)] + 10.0 * u[(i, j + 1, k)] + 100.0 * u[(i, j, k - 1)];
    }
}

#[test]
fn offsets_under_a_colour() {
    fn run<L: Layout<Ijk>>() {
        let shape = [6, 7, 9];
        let value = |i: usize, j: usize, k: usize| (i * 100 + j * 10 + k) as f64;
        let (mut u, mut v) = (Field::<f64, L>::new(shape), Field::<f64, L>::new(shape));
        let all = || (0..6).flat_map(|i| (0..7).flat_map(move |j| (0..9).map(move |k| (i, j, k))));
        all().for_each(|(i, j, k)| u.set([i, j, k], value(i, j, k)));
        black(&u, &mut v, 1);
        for (i, j, k) in all() {
            let own = i > 0 && j > 0 && k > 0 && i < 5 && j < 6 && k < 8 && (i + j + k) % 2 == 1;
            let sum = || value(i - 1, j, k) + 10.0 * value(i, j + 1, k) + 100.0 * value(i, j, k - 1);
            assert_eq!(v.get([i, j, k]), if own { sum() } else { 0.0 }, "{i} {j} {k}");
        }
    }
    run::<Aos>();
    run::<Blocked<4>>();
    run::<layout!(dense(kij).dense(ijk, (2, 3, 4)).split)>();
}

#[test]
fn colours_that_do_not_exist_panic() {
    fn message<T: std::fmt::Debug>(call: impl FnOnce(&mut Field<u32, Aos, Ij>) -> T) -> String {
        let mut u = Field::<u32, Aos>::new([4, 4]);
        let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| call(&mut u))).unwrap_err();
        assert!(u.iter().all(|count| count == 0));
        panic.downcast_ref::<String>().expect("a message").clone()
    }
    assert_eq!(message(|u| checkerboards(u, 1, 2)), "`checkerboard(2)`: its colours are 0 and 1");
    assert_eq!(message(|u| colours(u, 1, 2, 4)), "`colored(2, 4)`: over so many axes, 2, the colours are 0 to 3");
    assert!(message(|u| colours(u, 1, 2, -1)).contains("0 to 3"));
    assert!(message(|u| colours(u, 1, 0, 0)).contains("modulo a positive number"));
}
