//! Kernels on vectors of any values, axes and layout.

use allotrope::prelude::*;

use super::operator::Value;

/// `a . b`.
#[kernel]
pub(super) fn dot<V: Value, X: Axes>(a: &Field<V, _, X>, b: &Field<V, _, X>) -> f64 {
    let mut sum = 0.0;
    for at in a {
        sum += a[at].dot(b[at]);
    }
    sum
}

/// `r <- b - y`; returns `r . r`.
#[kernel]
pub(super) fn residual<V: Value, X: Axes>(b: &Field<V, _, X>, y: &Field<V, _, X>, r: &mut Field<V, _, X>) -> f64 {
    let mut square = 0.0;
    for at in r {
        let new = b[at] - y[at];
        r[at] = new;
        square += new.dot(new);
    }
    square
}

/// `x <- x + damping D^-1 r`.
#[kernel]
pub(super) fn relax<V: Value, X: Axes>(
    x: &mut Field<V, _, X>,
    r: &Field<V, _, X>,
    inverse_diagonal: &Field<V, _, X>,
    damping: f64,
) {
    for at in x {
        x[at] += inverse_diagonal[at] * r[at] * damping;
    }
}

/// 1 divided by each component.
#[kernel]
pub(super) fn invert<V: Value, X: Axes>(diagonal: &mut Field<V, _, X>) {
    for at in diagonal {
        diagonal[at] = diagonal[at].recip();
    }
}

/// `p <- r + beta p`.
#[kernel]
pub(super) fn conjugate<V: Value, X: Axes>(r: &Field<V, _, X>, p: &mut Field<V, _, X>, beta: f64) {
    for at in p {
        p[at] = r[at] + p[at] * beta;
    }
}

/// `p <- D^-1 r + beta p`.
#[kernel]
pub(super) fn conjugate_scaled<V: Value, X: Axes>(
    r: &Field<V, _, X>,
    inverse_diagonal: &Field<V, _, X>,
    p: &mut Field<V, _, X>,
    beta: f64,
) {
    for at in p {
        p[at] = inverse_diagonal[at] * r[at] + p[at] * beta;
    }
}

/// `x <- x + alpha p` and `r <- r - alpha q`; returns `r . r`.
#[kernel]
pub(super) fn descend<V: Value, X: Axes>(
    x: &mut Field<V, _, X>,
    r: &mut Field<V, _, X>,
    p: &Field<V, _, X>,
    q: &Field<V, _, X>,
    alpha: f64,
) -> f64 {
    let mut square = 0.0;
    for at in x {
        x[at] += p[at] * alpha;
        let new = r[at] - q[at] * alpha;
        r[at] = new;
        square += new.dot(new);
    }
    square
}

/// `r . D^-1 r`.
#[kernel]
pub(super) fn dot_scaled<V: Value, X: Axes>(r: &Field<V, _, X>, inverse_diagonal: &Field<V, _, X>) -> f64 {
    let mut sum = 0.0;
    for at in r {
        sum += r[at].dot(inverse_diagonal[at] * r[at]);
    }
    sum
}
