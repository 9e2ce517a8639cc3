//! Linear algebra: the decompositions of small matrices that materials need, and iterative solvers of `A x = b`.
//!
//! | method | function | for |
//! | --- | --- | --- |
//! | Jacobi's iteration, damped or not | [`jacobi`] | any matrix whose iteration contracts, a dominant diagonal for one |
//! | conjugate gradients (Hestenes & Stiefel 1952) | [`conjugate_gradients`] | symmetric, positive definite matrices |
//! | the same, preconditioned by the diagonal | [`preconditioned_conjugate_gradients`] | those whose diagonal varies |
//!
//! A solver knows a matrix as an [`Operator`] alone, whose product with a vector is a kernel: [`Laplacian`] holds no
//! matrix at all, and [`DenseMatrix`], [`RowMatrix`] and [`CsrMatrix`] hold the same one in three layouts. All sums are
//! reductions of a fixed order in double precision: residuals are the same bits for any number of threads.
//!
//! ```
//! use allotrope::prelude::*;
//! use allotrope_solvers::linear::{Laplacian, Stop, conjugate_gradients};
//! let mut b = Field::<f64, Aos>::new([15, 15]);
//! b.fill(1.0);
//! let mut u = b.clone();
//! u.fill(0.0);
//! let report = conjugate_gradients(&Laplacian::new(), &b, &mut u, &Stop::at(1e-6)).unwrap();
//! assert_eq!(report.iterations, 24);
//! assert!((u.get([7, 7]) / 16.0f64.powi(2) - 0.0734458).abs() < 1e-6);
//! ```

mod conjugate_gradients;
mod csr;
mod decomposition;
mod dense;
mod entries;
mod jacobi;
mod laplacian;
mod operator;
mod polar;
mod report;
mod rows;
mod svd2;
mod svd3;
mod vectors;

pub use conjugate_gradients::{conjugate_gradients, preconditioned_conjugate_gradients};
pub use csr::CsrMatrix;
pub use decomposition::{Matrix, Svd};
pub use dense::DenseMatrix;
pub use entries::{Entry, EntryError};
pub use jacobi::jacobi;
pub use laplacian::Laplacian;
pub use operator::{Operator, Value, Vector};
pub use polar::Polar;
pub use report::{Failure, Report, SolveError, Stop};
pub use rows::{RowMatrix, Rows};
