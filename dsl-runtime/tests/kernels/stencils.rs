//! Reads at constant offsets.

use allotrope::prelude::*;

#[kernel]
fn jacobi(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v.interior(1) {
        v[(i, j)] = 0.25 * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]);
    }
}

#[kernel]
fn jacobi_vectors(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for ij in v.interior(1) {
        let sum = u[ij - IVec2::X] + u[ij + ivec2(1, 0)] + u[ij + IVec2::new(0, -1)] + u[ivec2(0, 1) + ij];
        v[ij] = 0.25 * sum;
    }
}

fn grid<L: Layout<Ij>>(n: usize, m: usize) -> Field<f32, L, Ij> {
    let mut field = Field::<f32, L, I>::new([n, m]);
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        field.set((i, j), (i * i + 3 * j * j + i * j) as f32);
    }
    field
}

#[test]
fn jacobi_in_any_layout() {
    fn run<L: Layout<Ij>>(step: impl Fn(&Field<f32, L, Ij>, &mut Field<f32, L, Ij>)) {
        let (u, mut v) = (grid::<L>(19, 23), grid::<L>(19, 23));
        step(&u, &mut v);
        for (i, j) in (0..19).flat_map(|i| (0..23).map(move |j| (i, j))) {
            let border = i == 0 || j == 0 || i == 18 || j == 22;
            let near = |a: i32, b: i32| if border { u.get((i, j)) } else { u.get((i + a, j + b)) };
            assert_eq!(v.get((i, j)), 0.25 * (near(-1, 0) + near(1, 0) + near(0, -1) + near(0, 1)), "({i}, {j})");
        }
    }
    run::<Aos>(jacobi);
    run::<Aos>(jacobi_vectors);
    run::<Blocked<4>>(jacobi);
    run::<layout!(dense(ji).dense(ij, (3, 5)).soa)>(jacobi);
    run::<Morton<8>>(jacobi);
    run::<layout!(dense(ij).dense(ij, 4).pad(32).soa)>(jacobi);
    run::<layout!(dense(ij).morton(ji, (4, 2)).dense(ij, 3).soa)>(jacobi_vectors);
}

#[kernel]
fn shift(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for p in v {
        v[p] = u[p + 1];
    }
}

#[test]
fn offsets_outside_panic_and_leave_the_field() {
    let (mut u, mut v) = (Field::<f32, Aos>::new([8]), Field::<f32, Soa>::new([7]));
    u.fill(2.0);
    shift(&u, &mut v);
    assert!(v.iter().all(|x| x == 2.0));
    let mut short = Field::<f32, Aos>::new([8]);
    let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| shift(&u, &mut short))).unwrap_err();
    let text = panic.downcast_ref::<String>().expect("a message");
    for part in ["shift", "`u`", "[8]"] {
        assert!(text.contains(part), "{text}");
    }
    short.fill(1.0);
    assert_eq!(short.get(7), 1.0);
}

#[kernel]
fn laplacian(u: &Field<f64, _, Ijk>, v: &mut Field<f64, _, Ijk>) {
    for (i, j, k) in v.interior(1) {
        let near = u[(i - 1, j, k)] + u[(i + 1, j, k)] + u[(i, j - 1, k)] + u[(i, j + 1, k)];
        v[(i, j, k)] = near + u[(i, j, k - 1)] + u[(i, j, k + 1)] - 6.0 * u[(i, j, k)];
    }
}

#[test]
fn laplacian_of_a_quadratic() {
    fn run<L: Layout<Ijk>>() {
        let (mut u, mut v) = (Field::<f64, L>::new([9, 10, 11]), Field::<f64, L>::new([9, 10, 11]));
        for i in 0..9 {
            for j in 0..10 {
                for k in 0..11 {
                    u.set((i, j, k), (i * i + 2 * j * j + 3 * k * k) as f64);
                }
            }
        }
        laplacian(&u, &mut v);
        let inside = v.iter().filter(|x| *x == 12.0).count();
        assert_eq!(inside, 7 * 8 * 9);
    }
    run::<Aos>();
    run::<Blocked<2>>();
    run::<Morton<4>>();
    run::<layout!(dense(ijk).dense(k, 2).morton(jik, (2, 4, 2)).soa)>();
}
