//! The rotation nearest to a matrix, and what remains.

use allotrope::prelude::*;

use super::Matrix;
use super::svd2::Planar;
use super::svd3::decompose;

/// Factors of `F = R S`. With the factors of [`Svd`](super::Svd), `R = U V^T` and `S = V diag(sigma) V^T`: the rotation
/// is one even where `F` turns space inside out, and then `S` has one negative eigenvalue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar<M: Matrix> {
    /// `R`.
    pub rotation: M,
    /// `S`, symmetric to the last bit.
    pub symmetric: M,
}

/// In closed form.
pub(super) fn polar2(matrix: Mat2) -> Polar<Mat2> {
    let Planar { mean, half_difference, turn, doubled } = Planar::new(matrix);
    let reflection = half_difference * doubled;
    Polar {
        rotation: DMat2::from_cols(turn, turn.perp()).as_mat2(),
        symmetric: DMat2::from_cols(dvec2(mean + reflection.x, reflection.y), dvec2(reflection.y, mean - reflection.x))
            .as_mat2(),
    }
}

/// From the singular values.
pub(super) fn polar3(matrix: Mat3) -> Polar<Mat3> {
    let (u, sigma, v) = decompose(matrix);
    let symmetric = v * DMat3::from_diagonal(sigma) * v.transpose();
    Polar { rotation: (u * v.transpose()).as_mat3(), symmetric: (0.5 * (symmetric + symmetric.transpose())).as_mat3() }
}
