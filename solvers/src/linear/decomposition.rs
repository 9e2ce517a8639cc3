//! Small dense matrices: the singular value and polar decompositions that materials need, in 2D and 3D.
//!
//! All is worked out in double precision, so that neither the smallest nor the largest matrix of single precision
//! overflows when it is squared, and results are right to about the last bit of single precision.

use std::fmt::Debug;
use std::ops::{Add, Mul, Sub};

use allotrope::prelude::*;

use super::{polar, svd2, svd3};
use polar::Polar;

/// Factors of `F = U diag(sigma) V^T`, where `U` and `V` are rotations. The values decrease in magnitude, and only the
/// last may be negative: it carries the sign of the determinant (Irving, Teran & Fedkiw 2004, "Invertible finite
/// elements for robust simulation of large deformation").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Svd<M: Matrix> {
    /// Rotation on the left.
    pub u: M,
    /// Singular values.
    pub sigma: M::Singular,
    /// Rotation on the right, not transposed.
    pub v: M,
}

impl<M: Matrix> Svd<M> {
    /// The product of the factors.
    pub fn product(&self) -> M {
        self.u * M::from_diagonal(self.sigma) * self.v.transpose()
    }
}

/// A square matrix, [`Mat2`] or [`Mat3`], for laws that are the same in both.
pub trait Matrix:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f32, Output = Self>
    + 'static
{
    /// As many values as there are dimensions.
    type Singular: Copy + Debug + PartialEq + Send + Sync + AsRef<[f32]> + AsMut<[f32]> + 'static;

    /// 2 or 3.
    const DIMENSIONS: usize;
    /// Ones on the diagonal.
    const IDENTITY: Self;
    /// Zeros.
    const ZERO: Self;

    /// The matrix with that diagonal.
    fn from_diagonal(diagonal: Self::Singular) -> Self;

    /// A multiple of the identity.
    fn isotropic(scale: f32) -> Self {
        Self::IDENTITY * scale
    }

    /// Rows and columns exchanged.
    fn transpose(self) -> Self;

    /// The volume that a unit volume is mapped to.
    fn determinant(self) -> f32;

    /// The sum of the diagonal.
    fn trace(self) -> f32;

    /// The sum of the squares of all components.
    fn norm_squared(self) -> f32;

    /// The determinant less one, to full precision where the matrix is nearly the identity: there it is small, and the
    /// determinant itself would have lost it to rounding.
    fn volume_change(self) -> f32;

    /// Factors, never NaN where the matrix and its norm are finite.
    fn svd(self) -> Svd<Self>;

    /// A rotation and a symmetric matrix, never NaN where the matrix and its norm are finite.
    fn polar(self) -> Polar<Self>;
}

impl Matrix for Mat2 {
    type Singular = [f32; 2];

    const DIMENSIONS: usize = 2;
    const IDENTITY: Self = Mat2::IDENTITY;
    const ZERO: Self = Mat2::ZERO;

    fn from_diagonal(diagonal: [f32; 2]) -> Self {
        Mat2::from_diagonal(diagonal.into())
    }

    fn transpose(self) -> Self {
        Mat2::transpose(&self)
    }

    fn determinant(self) -> f32 {
        Mat2::determinant(&self)
    }

    fn trace(self) -> f32 {
        self.x_axis.x + self.y_axis.y
    }

    fn norm_squared(self) -> f32 {
        self.x_axis.length_squared() + self.y_axis.length_squared()
    }

    fn volume_change(self) -> f32 {
        let change = self - Mat2::IDENTITY;
        change.trace() + Mat2::determinant(&change)
    }

    fn svd(self) -> Svd<Self> {
        svd2::svd(self)
    }

    fn polar(self) -> Polar<Self> {
        polar::polar2(self)
    }
}

impl Matrix for Mat3 {
    type Singular = [f32; 3];

    const DIMENSIONS: usize = 3;
    const IDENTITY: Self = Mat3::IDENTITY;
    const ZERO: Self = Mat3::ZERO;

    fn from_diagonal(diagonal: [f32; 3]) -> Self {
        Mat3::from_diagonal(diagonal.into())
    }

    fn transpose(self) -> Self {
        Mat3::transpose(&self)
    }

    fn determinant(self) -> f32 {
        Mat3::determinant(&self)
    }

    fn trace(self) -> f32 {
        self.x_axis.x + self.y_axis.y + self.z_axis.z
    }

    fn norm_squared(self) -> f32 {
        self.x_axis.length_squared() + self.y_axis.length_squared() + self.z_axis.length_squared()
    }

    fn volume_change(self) -> f32 {
        let change = self - Mat3::IDENTITY;
        let Mat3 { x_axis: x, y_axis: y, z_axis: z } = change;
        // The sum of the principal minors of two rows.
        let minors = (x.x * y.y - x.y * y.x) + (y.y * z.z - y.z * z.y) + (x.x * z.z - x.z * z.x);
        change.trace() + (minors + Mat3::determinant(&change))
    }

    fn svd(self) -> Svd<Self> {
        svd3::svd(self)
    }

    fn polar(self) -> Polar<Self> {
        polar::polar3(self)
    }
}
