//! When a solver stops, what it tells, and why it may fail.

use std::fmt;

/// When an iteration ends, and what is checked before it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Converged is what has `norm(r) <= tolerance norm(b)`, where `r = b - A x`.
    pub tolerance: f64,
    /// More iterations than this are an error.
    pub most: usize,
    /// Whether conjugate gradients first compare `u . A v` with `v . A u` for two random vectors: a matrix that is not
    /// symmetric is then an error at once, at the price of two products.
    pub check_symmetry: bool,
}

impl Stop {
    /// At a relative residual, after at most 100,000 iterations, with the check.
    pub fn at(tolerance: f64) -> Self {
        Self { tolerance, most: 100_000, check_symmetry: true }
    }
}

/// What a solver did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Iterations done.
    pub iterations: usize,
    /// The norm of the residual before the first iteration and after each.
    pub residuals: Vec<f64>,
}

impl Report {
    /// The norm of the last residual.
    pub fn residual(&self) -> f64 {
        self.residuals.last().copied().unwrap_or(0.0)
    }
}

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// An infinity or NaN in the right-hand side, in the vector to start from, or in products with the matrix; the text
    /// says which.
    NotFinite(&'static str),
    /// `u . A v` and `v . A u` differ by so much of their magnitude.
    NotSymmetric(f64),
    /// Along a direction `p . A p / p . p` is this, not above zero (as seen beside the largest such quotient): the matrix
    /// is singular, or not positive definite.
    NotPositive(f64),
    /// The diagonal, by which the solver divides, has a zero or what is not finite.
    Diagonal,
    /// So many iterations were done, and the residual is still too large.
    Limit(usize),
}

/// Why a solver gave up, with what it had seen until then.
#[derive(Clone, Debug, PartialEq)]
pub struct SolveError {
    /// Why.
    pub failure: Failure,
    /// The iterations done, and the residuals.
    pub report: Report,
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.failure {
            Failure::NotFinite(what) => write!(f, "{what} has no finite norm")?,
            Failure::NotSymmetric(by) => {
                write!(
                    f,
                    "the matrix is not symmetric, as conjugate gradients need it: u A v and v A u differ by {by:.1e}"
                )?;
            }
            Failure::NotPositive(quotient) => {
                write!(
                    f,
                    "the matrix is singular or not positive definite: along a direction p, p A p / p p = {quotient:.1e}"
                )?;
            }
            Failure::Diagonal => write!(f, "the diagonal of the matrix has a zero, or is not finite")?,
            Failure::Limit(most) => write!(f, "not converged after the {most} iterations that were allowed")?,
        }
        let Report { iterations, residuals } = &self.report;
        match (residuals.first(), residuals.last()) {
            (Some(first), Some(last)) => {
                write!(f, " (iteration {iterations}, residual {last:.3e}, at the start {first:.3e})")
            }
            _ => Ok(()),
        }
    }
}

impl std::error::Error for SolveError {}
