//! Jacobi's iteration.

use super::operator::{Operator, Vector};
use super::report::{Failure, Report, SolveError, Stop};
use super::vectors;

/// Solves `A x = b` by `x <- x + damping D^-1 (b - A x)`, where `D` is the diagonal of `A`, starting from what `x`
/// holds: Jacobi's iteration for a damping of 1. It converges if the spectral radius of `I - damping D^-1 A` is below
/// one, as it is for diagonally dominant matrices.
///
/// # Errors
/// With the residuals until then: an input that is not finite, a zero on the diagonal, or no convergence in as many
/// iterations as are allowed; an iteration that grows ends when it is no longer finite.
///
/// # Panics
/// If the vectors' extents differ from the matrix's.
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope_solvers::linear::{Laplacian, Stop, jacobi};
/// let mut b = Field::<f64, Aos>::new([15, 15]);
/// b.fill(1.0);
/// let mut u = b.clone();
/// u.fill(0.0);
/// assert_eq!(jacobi(&Laplacian::new(), &b, &mut u, 1.0, &Stop::at(1e-6)).unwrap().iterations, 705);
/// ```
pub fn jacobi<A: Operator>(
    a: &A,
    b: &Vector<A>,
    x: &mut Vector<A>,
    damping: f64,
    stop: &Stop,
) -> Result<Report, SolveError> {
    let mut report = Report::default();
    let fail = |failure, report: Report| Err(SolveError { failure, report });
    let bound = match start(a, b, x) {
        Ok(norm) => stop.tolerance * norm,
        Err(failure) => return fail(failure, report),
    };
    let mut inverse = b.clone();
    if let Err(failure) = inverse_diagonal(a, &mut inverse) {
        return fail(failure, report);
    }
    let (mut r, mut y) = (b.clone(), b.clone());
    loop {
        a.apply(x, &mut y);
        let norm = vectors::residual(b, &y, &mut r).sqrt();
        report.residuals.push(norm);
        if norm <= bound {
            return Ok(report);
        }
        if !norm.is_finite() {
            return fail(Failure::NotFinite("a residual"), report);
        }
        if report.iterations == stop.most {
            return fail(Failure::Limit(stop.most), report);
        }
        vectors::relax(x, &r, &inverse, damping);
        report.iterations += 1;
    }
}

/// Checks what is given, and returns the norm of the right-hand side.
pub(super) fn start<A: Operator>(_: &A, b: &Vector<A>, x: &Vector<A>) -> Result<f64, Failure> {
    let norm = vectors::dot(b, b).sqrt();
    if !norm.is_finite() {
        return Err(Failure::NotFinite("the right-hand side"));
    }
    if !vectors::dot(x, x).is_finite() {
        return Err(Failure::NotFinite("the vector to start from"));
    }
    Ok(norm)
}

/// Fills in the inverse of the diagonal.
pub(super) fn inverse_diagonal<A: Operator>(a: &A, inverse: &mut Vector<A>) -> Result<(), Failure> {
    a.diagonal(inverse);
    let sound = |diagonal: &Vector<A>| vectors::dot(diagonal, diagonal).is_finite();
    if !sound(inverse) {
        return Err(Failure::Diagonal);
    }
    vectors::invert(inverse);
    if sound(inverse) { Ok(()) } else { Err(Failure::Diagonal) }
}
