//! The 5-point Laplacian against closed forms and counts of an independent program.

use std::f64::consts::PI;

use allotrope::prelude::*;
use allotrope_solvers::linear::{
    Laplacian, Operator, Stop, Vector, conjugate_gradients, jacobi, preconditioned_conjugate_gradients,
};

type Grid<L = Aos> = Field<f64, L, Ij>;

fn constant<L: Layout<Ij>>(mut field: Grid<L>, value: f64) -> Grid<L> {
    field.fill(value);
    field
}

fn largest<L: Layout<Ij>>(u: &Grid<L>) -> f64 {
    u.iter().fold(0.0, f64::max)
}

/// `norm(b - A x)`, on the host.
fn residual(b: &Grid, x: &Grid) -> f64 {
    let [n, m] = b.shape().map(|extent| extent as i32);
    let at = |i: i32, j: i32| if (0..n).contains(&i) && (0..m).contains(&j) { x.get([i, j]) } else { 0.0 };
    let mut square = 0.0;
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        let product = 4.0 * at(i, j) - at(i - 1, j) - at(i + 1, j) - at(i, j - 1) - at(i, j + 1);
        square += (b.get([i, j]) - product).powi(2);
    }
    square.sqrt()
}

/// Nodes an axis, iterations of Jacobi, spectral radius, iterations of conjugate gradients, largest `u h^2`.
const TABLE: [(usize, usize, f64, usize, f64); 3] = [
    (15, 705, 0.98078528, 24, 0.07344576),
    (31, 2825, 0.99518473, 50, 0.07361474),
    (63, 11302, 0.99879546, 100, 0.07365718),
];

#[test]
fn iterations_and_solutions_are_those_of_the_table() {
    for (n, jacobi_iterations, radius, iterations, top) in TABLE {
        let b = constant(Field::<f64, Aos>::new([n, n]), 1.0);
        let h2 = ((n + 1) as f64).powi(-2);
        let a = Laplacian::new();

        let mut u = constant(b.clone(), 0.0);
        let report = jacobi(&a, &b, &mut u, 1.0, &Stop::at(1e-6)).unwrap();
        assert_eq!(report.iterations, jacobi_iterations);
        assert_eq!(report.residuals.len(), jacobi_iterations + 1);
        let last = &report.residuals[jacobi_iterations - 1..];
        assert!((last[1] / last[0] - radius).abs() < 1e-8, "{last:?}");
        assert!((largest(&u) * h2 - top).abs() < 1e-6);
        assert!((residual(&b, &u) - report.residual()).abs() < 1e-9 * report.residuals[0]);

        let mut v = constant(b.clone(), 0.0);
        let report = conjugate_gradients(&a, &b, &mut v, &Stop::at(1e-6)).unwrap();
        assert_eq!(report.iterations, iterations);
        assert!((largest(&v) * h2 - top).abs() < 1e-6);
        assert!(residual(&b, &v) <= 1.001e-6 * report.residuals[0]);

        // A constant diagonal scales directions, and changes nothing else.
        let mut w = constant(b.clone(), 0.0);
        let report = preconditioned_conjugate_gradients(&a, &b, &mut w, &Stop::at(1e-6)).unwrap();
        assert_eq!(report.iterations, iterations);
        assert!(v.iter().zip(w.iter()).all(|(v, w)| (v - w).abs() < 1e-9 * top / h2));
    }
}

/// `-lap u = 2 pi^2 sin pi x sin pi y`: the nodal error is `2 pi^2 / lambda - 1` times the solution, with
/// `lambda = 4 (1 - cos pi h) / h^2`.
#[test]
fn the_error_of_five_points_is_exact() {
    for (n, printed) in [(8, 1.2951e-2), (16, 3.2190e-3), (32, 8.0358e-4), (64, 2.0082e-4), (128, 5.0201e-5)] {
        let h = 1.0 / n as f64;
        let exact = |i: usize, j: usize| (PI * h * (i + 1) as f64).sin() * (PI * h * (j + 1) as f64).sin();
        let nodes: Vec<f64> = (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| exact(i, j))).collect();
        let mut b = Field::<f64, Aos>::new([n - 1, n - 1]);
        b.copy_from_slice(&nodes.iter().map(|u| 2.0 * PI * PI * h * h * u).collect::<Vec<_>>());
        let mut u = constant(b.clone(), 0.0);
        conjugate_gradients(&Laplacian::new(), &b, &mut u, &Stop::at(1e-13)).unwrap();
        let error = u.iter().zip(&nodes).map(|(u, exact)| (u - exact).abs()).fold(0.0, f64::max);
        let lambda = 4.0 * (1.0 - (PI * h).cos()) / (h * h);
        assert!((error / (2.0 * PI * PI / lambda - 1.0) - 1.0).abs() < 1e-8, "{n}: {error}");
        assert!((error / printed - 1.0).abs() < 1e-4, "{n}: {error}");
    }
}

/// Rectangles that are no squares, down to those without an interior, in blocks as well.
#[test]
fn products_are_those_of_the_definition_in_any_shape_and_layout() {
    fn run<L: Layout<Ij>>(mut x: Grid<L>) {
        let [n, m] = x.shape();
        let values: Vec<f64> = (0..n * m).map(|at| random::<f64>(3, at) - 0.5).collect();
        x.copy_from_slice(&values);
        let mut y = x.clone();
        let measured = Laplacian::<L>::new().apply(&x, &mut y);
        let at = |i: usize, j: usize| if i < n && j < m { values[i * m + j] } else { 0.0 };
        let mut curvature = 0.0;
        for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
            let around = at(i.wrapping_sub(1), j) + at(i + 1, j) + at(i, j.wrapping_sub(1)) + at(i, j + 1);
            let product = 4.0 * at(i, j) - around;
            assert!((y.get([i, j]) - product).abs() < 1e-14, "({i}, {j}) of {n} x {m}");
            curvature += at(i, j) * product;
        }
        assert!((measured - curvature).abs() < 1e-12);
    }
    for shape in [[1, 1], [1, 7], [2, 2], [5, 3], [17, 9]] {
        run(Field::<f64, Aos>::new(shape));
        run(Field::<f64, Blocked<4>>::new(shape));
    }
}

/// What the operator does in place of the two halves of an iteration is what they are.
#[test]
fn computing_a_product_twice_changes_nothing_but_rounding() {
    /// The same operator with the halves that serve all.
    struct Plain;
    impl Operator for Plain {
        type Value = f64;
        type Axes = Ij;
        type Layout = Aos;
        fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
            Laplacian::<Aos>::new().apply(x, y)
        }
        fn diagonal(&self, diagonal: &mut Vector<Self>) {
            diagonal.fill(4.0);
        }
    }
    let mut b = Field::<f64, Aos>::new([23, 12]);
    let values: Vec<f64> = (0..b.len()).map(|at| random::<f64>(5, at)).collect();
    b.copy_from_slice(&values);
    let (mut u, mut v) = (constant(b.clone(), 0.25), constant(b.clone(), 0.25));
    let one = conjugate_gradients(&Laplacian::new(), &b, &mut u, &Stop::at(1e-8)).unwrap();
    let other = conjugate_gradients(&Plain, &b, &mut v, &Stop::at(1e-8)).unwrap();
    assert_eq!(one.iterations, other.iterations);
    for (one, other) in one.residuals.iter().zip(&other.residuals) {
        assert!((one - other).abs() < 1e-6 * one, "{one} and {other}");
    }
}

#[test]
fn residuals_are_the_same_bits_on_any_number_of_threads() {
    let b = constant(Field::<f64, Aos>::new([200, 150]), 1.0);
    let solve = |threads| {
        Schedule { threads, grain: 64, ..Schedule::default() }.run(|| {
            let mut u = constant(b.clone(), 0.0);
            (conjugate_gradients(&Laplacian::new(), &b, &mut u, &Stop::at(1e-6)).unwrap(), u.to_vec())
        })
    };
    let one = solve(1);
    assert!(one.0.iterations > 100);
    assert!(one == solve(3));
}
