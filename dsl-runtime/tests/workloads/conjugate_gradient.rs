//! Conjugate gradients for Poisson's equation, fused with its dot products; and the same on members of any record.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[derive(Record, Clone, Copy, Default)]
struct Cg {
    x: f32,
    r: f32,
    p: f32,
    ap: f32,
}

#[kernel]
fn apply(cg: &mut Field<Cg, _, Ij>) -> f64 {
    let mut p_ap = 0.0f64;
    for (i, j) in cg {
        let s =
            cg.p.or((i - 1, j), 0.0) + cg.p.or((i + 1, j), 0.0) + cg.p.or((i, j - 1), 0.0) + cg.p.or((i, j + 1), 0.0);
        let q = 4.0 * cg.p[(i, j)] - s;
        cg.ap[(i, j)] = q;
        p_ap += (cg.p[(i, j)] * q) as f64;
    }
    p_ap
}

#[kernel]
fn descend(cg: &mut Field<Cg, _, Ij>, alpha: f32) -> f64 {
    let mut rr = 0.0f64;
    for ij in cg {
        cg.x[ij] += alpha * cg.p[ij];
        cg.r[ij] -= alpha * cg.ap[ij];
        rr += (cg.r[ij] * cg.r[ij]) as f64;
    }
    rr
}

#[kernel]
fn conjugate(cg: &mut Field<Cg, _, Ij>, beta: f32) {
    for ij in cg {
        cg.p[ij] = cg.r[ij] + beta * cg.p[ij];
    }
}

/// For members of any record.
#[kernel]
fn dot(a: &Member<f32, _, Ij>, b: &Member<f32, _, Ij>) -> f64 {
    let mut sum = 0.0;
    for ij in a {
        sum += (a[ij] * b[ij]) as f64;
    }
    sum
}

/// Solves, and returns the solution and the number of iterations.
fn solve<L: Layout<Ij>>(b: &[f32], shape: [usize; 2]) -> (Vec<f32>, usize) {
    let mut cg = Field::<Cg, L>::new(shape);
    cg.members_mut().r.copy_from_slice(b);
    cg.members_mut().p.copy_from_slice(b);
    let mut rr = dot(&cg.members().r, &cg.members().r);
    let first = rr;
    for iteration in 0..200 {
        if rr <= 1e-12 * first {
            return (cg.members().x.to_vec(), iteration);
        }
        let alpha = rr / apply(&mut cg);
        let next = descend(&mut cg, alpha as f32);
        conjugate(&mut cg, (next / rr) as f32);
        rr = next;
    }
    panic!("no convergence: {rr} of {first}");
}

#[test]
fn the_solution_satisfies_the_equation() {
    fn run<L: Layout<Ij>>() {
        let (n, m) = (13, 10);
        let b: Vec<f32> = (0..n * m).map(scattered).collect();
        on_threads(|| {
            let (x, iterations) = solve::<L>(&b, [n, m]);
            assert!(iterations < 60, "{iterations} iterations");
            let at = |i: usize, j: usize| if i < n && j < m { x[i * m + j] } else { 0.0 };
            let product: Vec<f32> = (0..n * m)
                .map(|cell| {
                    let (i, j) = (cell / m, cell % m);
                    let around = at(i.wrapping_sub(1), j) + at(i + 1, j) + at(i, j.wrapping_sub(1)) + at(i, j + 1);
                    4.0 * at(i, j) - around
                })
                .collect();
            close(&product, &b, 1e-5);
        });
    }
    run::<Aos>();
    run::<Soa>();
    run::<Blocked<4>>();
}
