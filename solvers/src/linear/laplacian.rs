//! The 5-point Laplacian, without a matrix.

use std::marker::PhantomData;

use allotrope::prelude::*;

use super::operator::{Operator, Vector};

/// The 5-point Laplacian `4 u - (sum of the four neighbours)` at the interior nodes of a rectangle, with zeros around
/// them (minus the Laplace operator times `h^2`, where nodes are `h` apart), over vectors in the layout `L`.
///
/// It computes a product twice an iteration of conjugate gradients instead of keeping it, so that an iteration goes
/// through memory eight times instead of eleven.
#[derive(Clone, Copy, Debug, Default)]
pub struct Laplacian<L = Aos>(PhantomData<fn() -> L>);

impl<L> Laplacian<L> {
    /// For rectangles of any extents.
    pub fn new() -> Self {
        Self(PhantomData)
    }
}

impl<L: Layout<Ij>> Operator for Laplacian<L> {
    type Value = f64;
    type Axes = Ij;
    type Layout = L;

    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
        apply(x, y)
    }

    fn diagonal(&self, diagonal: &mut Vector<Self>) {
        diagonal.fill(4.0);
    }

    /// The new direction lies beside the old one, whose neighbours are still read; then they change places.
    fn turn(&self, r: &Vector<Self>, p: &mut Vector<Self>, spare: &mut Vector<Self>, beta: f64) -> f64 {
        let curvature = turn(r, p, spare, beta);
        std::mem::swap(p, spare);
        curvature
    }

    fn descend(
        &self,
        x: &mut Vector<Self>,
        r: &mut Vector<Self>,
        p: &Vector<Self>,
        _: &Vector<Self>,
        alpha: f64,
    ) -> f64 {
        descend(x, r, p, alpha)
    }
}

/// `y <- A x`; returns `x . A x`.
#[kernel]
fn apply(x: &Field<f64, _, Ij>, y: &mut Field<f64, _, Ij>) -> f64 {
    let mut curvature = 0.0;
    for (i, j) in y.interior(1) {
        let own = x[(i, j)];
        let product = 4.0 * own - (x[(i - 1, j)] + x[(i + 1, j)] + x[(i, j - 1)] + x[(i, j + 1)]);
        y[(i, j)] = product;
        curvature += own * product;
    }
    for (i, j) in y.border(1) {
        let own = x[(i, j)];
        let around = x.or((i - 1, j), 0.0) + x.or((i + 1, j), 0.0) + x.or((i, j - 1), 0.0) + x.or((i, j + 1), 0.0);
        let product = 4.0 * own - around;
        y[(i, j)] = product;
        curvature += own * product;
    }
    curvature
}

/// `p <- r + beta old`; returns `p . A p`.
#[kernel]
fn turn(r: &Field<f64, _, Ij>, old: &Field<f64, _, Ij>, p: &mut Field<f64, _, Ij>, beta: f64) -> f64 {
    let mut curvature = 0.0;
    for (i, j) in p.interior(1) {
        let own = r[(i, j)] + beta * old[(i, j)];
        let residuals = r[(i - 1, j)] + r[(i + 1, j)] + r[(i, j - 1)] + r[(i, j + 1)];
        let directions = old[(i - 1, j)] + old[(i + 1, j)] + old[(i, j - 1)] + old[(i, j + 1)];
        p[(i, j)] = own;
        curvature += own * (4.0 * own - (residuals + beta * directions));
    }
    for (i, j) in p.border(1) {
        let own = r[(i, j)] + beta * old[(i, j)];
        let residuals = r.or((i - 1, j), 0.0) + r.or((i + 1, j), 0.0) + r.or((i, j - 1), 0.0) + r.or((i, j + 1), 0.0);
        let directions =
            old.or((i - 1, j), 0.0) + old.or((i + 1, j), 0.0) + old.or((i, j - 1), 0.0) + old.or((i, j + 1), 0.0);
        p[(i, j)] = own;
        curvature += own * (4.0 * own - (residuals + beta * directions));
    }
    curvature
}

/// `x <- x + alpha p` and `r <- r - alpha A p`; returns `r . r`.
#[kernel]
fn descend(x: &mut Field<f64, _, Ij>, r: &mut Field<f64, _, Ij>, p: &Field<f64, _, Ij>, alpha: f64) -> f64 {
    let mut square = 0.0;
    for (i, j) in x.interior(1) {
        let own = p[(i, j)];
        let product = 4.0 * own - (p[(i - 1, j)] + p[(i + 1, j)] + p[(i, j - 1)] + p[(i, j + 1)]);
        x[(i, j)] += alpha * own;
        let new = r[(i, j)] - alpha * product;
        r[(i, j)] = new;
        square += new * new;
    }
    for (i, j) in x.border(1) {
        let own = p[(i, j)];
        let around = p.or((i - 1, j), 0.0) + p.or((i + 1, j), 0.0) + p.or((i, j - 1), 0.0) + p.or((i, j + 1), 0.0);
        x[(i, j)] += alpha * own;
        let new = r[(i, j)] - alpha * (4.0 * own - around);
        r[(i, j)] = new;
        square += new * new;
    }
    square
}
