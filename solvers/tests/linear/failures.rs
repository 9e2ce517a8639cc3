//! What cannot be solved is told, with the residuals until then.

use allotrope::prelude::*;
use allotrope_solvers::linear::{
    DenseMatrix, Failure, Laplacian, Operator, Stop, Vector, conjugate_gradients, jacobi,
    preconditioned_conjugate_gradients,
};

use super::matrices::{dense, line};

/// Solves from zero, and returns why that failed and the residuals.
fn failure(a: &DenseMatrix, b: &[f64], stop: &Stop) -> (Failure, Vec<f64>) {
    let mut x = line(&vec![0.0; b.len()]);
    let error = conjugate_gradients(a, &line(b), &mut x, stop).unwrap_err();
    (error.failure, error.report.residuals)
}

#[test]
fn a_matrix_that_is_not_symmetric_is_refused_at_once() {
    let a = dense(&[&[2.0, 1.0], &[0.0, 2.0]]);
    let (failure, residuals) = failure(&a, &[1.0, 1.0], &Stop::at(1e-6));
    assert!(matches!(failure, Failure::NotSymmetric(by) if by > 1e-3), "{failure:?}");
    assert!(residuals.is_empty());
}

#[test]
fn unsymmetric_matrices_that_are_not_checked_do_not_end_in_a_wrong_answer() {
    // A rotation by a right angle: every direction has the curvature 0.
    let a = dense(&[&[0.0, 1.0], &[-1.0, 0.0]]);
    let (failure, residuals) = failure(&a, &[1.0, 2.0], &Stop { check_symmetry: false, ..Stop::at(1e-6) });
    assert_eq!(failure, Failure::NotPositive(0.0));
    assert_eq!(residuals, [5f64.sqrt()]);
}

#[test]
fn singular_matrices_break_down() {
    let a = dense(&[&[1.0, 1.0], &[1.0, 1.0]]);
    for b in [[1.0, -1.0], [1.0, 0.0]] {
        let (failure, residuals) = failure(&a, &b, &Stop::at(1e-6));
        assert!(matches!(failure, Failure::NotPositive(_)), "{failure:?}");
        assert!(!residuals.is_empty());
    }
    // With a right-hand side in its range there is a solution, and it is found.
    let mut x = line(&[0.0; 2]);
    conjugate_gradients(&a, &line(&[2.0, 2.0]), &mut x, &Stop::at(1e-12)).unwrap();
    assert!((x.get(0) + x.get(1) - 2.0).abs() < 1e-12);
}

/// A random matrix of rank 11 in 12 rows, where rounding hides the zero.
#[test]
fn a_rank_that_rounding_hides_is_found() {
    let n = 12;
    let half: Vec<Vec<f64>> = (0..n).map(|i| (0..n - 1).map(|j| random::<f64>(21, (i, j)) - 0.5).collect()).collect();
    let rows: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| (0..n - 1).map(|k| half[i][k] * half[j][k]).sum()).collect()).collect();
    let a = dense(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let b: Vec<f64> = (0..n).map(|i| random::<f64>(22, i)).collect();
    let (failure, residuals) = failure(&a, &b, &Stop { most: 1000, ..Stop::at(1e-8) });
    assert!(matches!(failure, Failure::NotPositive(_) | Failure::Limit(1000)), "{failure:?}");
    assert!(residuals.iter().all(|residual| residual.is_finite() && *residual > 0.0));
}

#[test]
fn negative_matrices_are_refused() {
    let a = dense(&[&[-1.0, 0.0], &[0.0, -2.0]]);
    let (failure, _) = failure(&a, &[1.0, 1.0], &Stop::at(1e-6));
    assert_eq!(failure, Failure::NotPositive(-1.5));
}

#[test]
fn what_is_not_finite_is_told_wherever_it_stands() {
    let a = dense(&[&[2.0, 0.0], &[0.0, 2.0]]);
    let right = Failure::NotFinite("the right-hand side");
    assert_eq!(failure(&a, &[1.0, f64::NAN], &Stop::at(1e-6)).0, right);
    assert_eq!(failure(&a, &[f64::INFINITY, 1.0], &Stop::at(1e-6)).0, right);
    let (b, mut x) = (line(&[1.0, 1.0]), line(&[f64::NAN, 0.0]));
    let start = Failure::NotFinite("the vector to start from");
    assert_eq!(conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-6)).unwrap_err().failure, start);
    assert_eq!(jacobi(&a, &b, &mut x, 1.0, &Stop::at(1e-6)).unwrap_err().failure, start);

    let wrong = dense(&[&[2.0, f64::NAN], &[f64::NAN, 2.0]]);
    for check_symmetry in [true, false] {
        let (failure, _) = failure(&wrong, &[1.0, 1.0], &Stop { check_symmetry, ..Stop::at(1e-6) });
        assert_eq!(failure, Failure::NotFinite("a product with the matrix"));
    }
    let mut x = line(&[0.0, 0.0]);
    let error = jacobi(&wrong, &b, &mut x, 1.0, &Stop::at(1e-6)).unwrap_err();
    assert_eq!(error.failure, Failure::NotFinite("a residual"));
}

#[test]
fn the_limit_of_iterations_is_an_error_with_all_residuals() {
    let mut b = Field::<f64, Aos>::new([31, 31]);
    b.fill(1.0);
    let mut u = b.clone();
    u.fill(0.0);
    let stop = Stop { most: 10, ..Stop::at(1e-6) };
    let error = conjugate_gradients(&Laplacian::new(), &b, &mut u, &stop).unwrap_err();
    assert_eq!((error.failure, error.report.iterations), (Failure::Limit(10), 10));
    assert_eq!(error.report.residuals.len(), 11);
    assert_eq!(error.report.residuals[0], 31.0);
    let text = error.to_string();
    assert!(
        text.starts_with("not converged after the 10 iterations that were allowed (iteration 10, residual "),
        "{text}"
    );

    u.fill(0.0);
    let error = jacobi(&Laplacian::new(), &b, &mut u, 1.0, &stop).unwrap_err();
    assert_eq!((error.failure, error.report.residuals.len()), (Failure::Limit(10), 11));
    assert!(error.report.residuals.is_sorted_by(|a, b| a > b), "Jacobi's residuals fall");
}

#[test]
fn an_iteration_that_grows_ends() {
    let a = dense(&[&[1.0, 3.0], &[3.0, 1.0]]);
    let mut x = line(&[0.0, 0.0]);
    let error = jacobi(&a, &line(&[1.0, 2.0]), &mut x, 1.0, &Stop::at(1e-6)).unwrap_err();
    assert_eq!(error.failure, Failure::NotFinite("a residual"));
    let residuals = &error.report.residuals;
    assert!((residuals[11] / residuals[10] - 3.0).abs() < 0.01, "it grows by the spectral radius");
}

#[test]
fn a_zero_on_the_diagonal_is_told() {
    let a = dense(&[&[0.0, 1.0], &[1.0, 0.0]]);
    let (b, mut x) = (line(&[1.0, 2.0]), line(&[0.0, 0.0]));
    assert_eq!(jacobi(&a, &b, &mut x, 1.0, &Stop::at(1e-6)).unwrap_err().failure, Failure::Diagonal);
    let error = preconditioned_conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-6)).unwrap_err();
    assert_eq!(error.failure, Failure::Diagonal);
}

#[test]
fn a_right_hand_side_of_zeros_has_the_solution_zero() {
    let a = dense(&[&[2.0, 1.0], &[1.0, 2.0]]);
    let (b, mut x) = (line(&[0.0, 0.0]), line(&[0.0, 0.0]));
    assert_eq!(conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-6)).unwrap().iterations, 0);
    assert_eq!(jacobi(&a, &b, &mut x, 1.0, &Stop::at(1e-6)).unwrap().iterations, 0);
    // From elsewhere it is reached as far as numbers go, or the error says so: never another answer.
    x.fill(1.0);
    if conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-6)).is_ok() {
        assert!(x.iter().all(|x| x == 0.0));
    }
}

/// The trait can be implemented outside of the crate, for whatever a kernel computes.
#[test]
fn operators_are_open() {
    struct Twice;
    impl Operator for Twice {
        type Value = DVec3;
        type Axes = I;
        type Layout = Soa;
        fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
            twice(x, y)
        }
        fn diagonal(&self, diagonal: &mut Vector<Self>) {
            diagonal.fill(DVec3::splat(2.0));
        }
    }
    let mut b = Field::<DVec3, Soa>::new([3]);
    b.fill(dvec3(2.0, 4.0, 6.0));
    let mut x = b.clone();
    assert_eq!(conjugate_gradients(&Twice, &b, &mut x, &Stop::at(1e-12)).unwrap().iterations, 1);
    assert_eq!(x.get(2), dvec3(1.0, 2.0, 3.0));
}

#[kernel]
fn twice(x: &Field<DVec3, _>, y: &mut Field<DVec3, _>) -> f64 {
    let mut curvature = 0.0;
    for i in y {
        y[i] = 2.0 * x[i];
        curvature += 2.0 * x[i].length_squared();
    }
    curvature
}
