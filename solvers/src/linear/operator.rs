//! What a solver asks of a matrix.

use std::ops::{Add, AddAssign, Mul, Sub, SubAssign};

use allotrope::prelude::*;
use allotrope::{Element, Random};

use super::vectors;

/// What a vector holds at each place: a number, or one of space.
pub trait Value:
    Element<Scalar = f64>
    + Random
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + AddAssign
    + SubAssign
{
    /// The sum of the products of the components.
    fn dot(self, other: Self) -> f64;

    /// 1 divided by each component.
    fn recip(self) -> Self;
}

impl Value for f64 {
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        self * other
    }

    #[inline(always)]
    fn recip(self) -> Self {
        1.0 / self
    }
}

impl Value for DVec3 {
    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        DVec3::dot(self, other)
    }

    #[inline(always)]
    fn recip(self) -> Self {
        1.0 / self
    }
}

/// A vector that an operator takes.
pub type Vector<A> = Field<<A as Operator>::Value, <A as Operator>::Layout, <A as Operator>::Axes>;

/// A square matrix, known by its product with a vector, which is a kernel.
///
/// [`turn`](Self::turn) and [`descend`](Self::descend) are the two halves of an iteration of conjugate gradients.
/// Together they go eleven times through a vector; a matrix whose rows are computed faster than memory is read can do
/// with less, by computing `A p` twice, as [`Laplacian`](super::Laplacian) does.
pub trait Operator {
    /// What vectors hold at each place.
    type Value: Value;
    /// The axes of vectors.
    type Axes: Axes;
    /// The layout of vectors.
    type Layout: Layout<Self::Axes>;

    /// `y <- A x`; returns `x . A x`.
    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64
    where
        Self: Sized;

    /// Fills in the diagonal of the matrix.
    fn diagonal(&self, diagonal: &mut Vector<Self>)
    where
        Self: Sized;

    /// `p <- r + beta p`; returns `p . A p`. `spare` holds whatever [`descend`](Self::descend) wants to find
    /// there.
    fn turn(&self, r: &Vector<Self>, p: &mut Vector<Self>, spare: &mut Vector<Self>, beta: f64) -> f64
    where
        Self: Sized,
    {
        vectors::conjugate(r, p, beta);
        self.apply(p, spare)
    }

    /// `x <- x + alpha p` and `r <- r - alpha A p`; returns `r . r`.
    fn descend(
        &self,
        x: &mut Vector<Self>,
        r: &mut Vector<Self>,
        p: &Vector<Self>,
        spare: &Vector<Self>,
        alpha: f64,
    ) -> f64
    where
        Self: Sized,
    {
        vectors::descend(x, r, p, spare, alpha)
    }
}
