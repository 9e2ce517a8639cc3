//! Conjugate gradients (Hestenes & Stiefel 1952, "Methods of conjugate gradients for solving linear systems").

use allotrope::prelude::*;

use super::jacobi::{inverse_diagonal, start};
use super::operator::{Operator, Vector};
use super::report::{Failure, Report, SolveError, Stop};
use super::vectors;

/// A quotient so much smaller than the largest one is zero but for rounding.
const SINGULAR: f64 = 1e-14;

/// What a product may lose of its symmetry to rounding.
const ASYMMETRY: f64 = 1e-10;

/// Solves `A x = b` for a symmetric, positive definite matrix by conjugate gradients, starting from what `x` holds.
///
/// # Errors
/// With the residuals until then: an input that is not finite, a matrix that is not symmetric (if that is checked) or
/// along some direction not positive, as a singular one is, or no convergence in as many iterations as are allowed.
///
/// # Panics
/// If the vectors' extents differ from the matrix's.
pub fn conjugate_gradients<A: Operator>(
    a: &A,
    b: &Vector<A>,
    x: &mut Vector<A>,
    stop: &Stop,
) -> Result<Report, SolveError> {
    let mut solve = Solve::default();
    solve.run(a, b, x, stop, None).map_err(|failure| SolveError { failure, report: solve.report.clone() })?;
    Ok(solve.report)
}

/// Conjugate gradients, preconditioned by the diagonal: `D^-1 r` takes the place of the residual in directions.
///
/// # Errors
/// As [`conjugate_gradients`], and where the diagonal has a zero.
///
/// # Panics
/// If the vectors' extents differ from the matrix's.
pub fn preconditioned_conjugate_gradients<A: Operator>(
    a: &A,
    b: &Vector<A>,
    x: &mut Vector<A>,
    stop: &Stop,
) -> Result<Report, SolveError> {
    let mut solve = Solve::default();
    let mut inverse = b.clone();
    inverse_diagonal(a, &mut inverse)
        .and_then(|()| solve.run(a, b, x, stop, Some(&inverse)))
        .map_err(|failure| SolveError { failure, report: solve.report.clone() })?;
    Ok(solve.report)
}

#[derive(Default)]
struct Solve {
    report: Report,
    /// The largest quotient met.
    largest: f64,
}

impl Solve {
    fn run<A: Operator>(
        &mut self,
        a: &A,
        b: &Vector<A>,
        x: &mut Vector<A>,
        stop: &Stop,
        inverse: Option<&Vector<A>>,
    ) -> Result<(), Failure> {
        let bound = stop.tolerance * start(a, b, x)?;
        let (mut r, mut p, mut spare) = (b.clone(), b.clone(), b.clone());
        if stop.check_symmetry {
            check_symmetry(a, &mut p, &mut r, &mut spare)?;
        }
        a.apply(x, &mut spare);
        let mut square = vectors::residual(b, &spare, &mut r);
        self.report.residuals.push(square.sqrt());
        p.fill(A::Value::default());
        let mut weight = inverse.map_or(square, |inverse| vectors::dot_scaled(&r, inverse));
        // `p . p` (with a preconditioner `p . D p`), which needs no sum: a residual is orthogonal to all former directions.
        let (mut beta, mut size) = (0.0, 0.0);
        loop {
            let norm = square.sqrt();
            if norm <= bound {
                return Ok(());
            }
            if !norm.is_finite() {
                return Err(Failure::NotFinite("a product with the matrix"));
            }
            if self.report.iterations == stop.most {
                return Err(Failure::Limit(stop.most));
            }
            let curvature = match inverse {
                None => a.turn(&r, &mut p, &mut spare, beta),
                Some(inverse) => {
                    vectors::conjugate_scaled(&r, inverse, &mut p, beta);
                    a.apply(&p, &mut spare)
                }
            };
            size = weight + beta * beta * size;
            self.check(curvature / size)?;
            let alpha = weight / curvature;
            // The default halves: a preconditioned iteration has its own first half, whose product lies in `spare`.
            square = match inverse {
                None => a.descend(x, &mut r, &p, &spare, alpha),
                Some(_) => vectors::descend(x, &mut r, &p, &spare, alpha),
            };
            let next = inverse.map_or(square, |inverse| vectors::dot_scaled(&r, inverse));
            (beta, weight) = (next / weight, next);
            self.report.iterations += 1;
            self.report.residuals.push(square.sqrt());
        }
    }

    fn check(&mut self, quotient: f64) -> Result<(), Failure> {
        if !quotient.is_finite() {
            return Err(Failure::NotFinite("a product with the matrix"));
        }
        self.largest = self.largest.max(quotient);
        if quotient <= SINGULAR * self.largest { Err(Failure::NotPositive(quotient)) } else { Ok(()) }
    }
}

/// Compares `u . A v` with `v . A u` for two random vectors. All that is handed over is overwritten.
fn check_symmetry<A: Operator>(
    a: &A,
    u: &mut Vector<A>,
    v: &mut Vector<A>,
    product: &mut Vector<A>,
) -> Result<(), Failure> {
    for (seed, vector) in [(1, &mut *u), (2, &mut *v)] {
        let values: Vec<A::Value> = (0..vector.len()).map(|n| random(seed, n)).collect();
        vector.copy_from_slice(&values);
    }
    a.apply(v, product);
    let (one, scale) = (vectors::dot(u, product), vectors::dot(u, u) * vectors::dot(product, product));
    a.apply(u, product);
    let other = vectors::dot(v, product);
    let asymmetry = (one - other).abs() / scale.sqrt();
    match asymmetry.partial_cmp(&ASYMMETRY) {
        // A matrix of zeros is symmetric.
        None if scale == 0.0 => Ok(()),
        None => Err(Failure::NotFinite("a product with the matrix")),
        Some(std::cmp::Ordering::Greater) => Err(Failure::NotSymmetric(asymmetry)),
        Some(_) => Ok(()),
    }
}
