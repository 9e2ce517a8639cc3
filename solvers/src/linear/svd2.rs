//! Singular values in the plane, in closed form.

use allotrope::prelude::*;

use super::Svd;

/// A matrix of the plane as a rotation times a scale, plus a reflection times a scale; vectors stand for complex
/// numbers.
pub(super) struct Planar {
    /// `(s1 + s2) / 2`, not negative.
    pub(super) mean: f64,
    /// `(s1 - s2) / 2`, not negative.
    pub(super) half_difference: f64,
    /// Cosine and sine of the rotation `U V^T`.
    pub(super) turn: DVec2,
    /// Cosine and sine of twice the angle of `V`.
    pub(super) doubled: DVec2,
}

impl Planar {
    /// Where a part is zero its direction is of no account, and taken along the first axis.
    pub(super) fn new(matrix: Mat2) -> Self {
        let [a, c, b, d] = matrix.to_cols_array().map(f64::from);
        let (rotation, reflection) = (0.5 * dvec2(a + d, c - b), 0.5 * dvec2(a - d, c + b));
        let turn = rotation.normalize_or(DVec2::X);
        // The reflection's angle is the sum of those of U and V, the rotation's the difference.
        let doubled = dvec2(turn.x, -turn.y).rotate(reflection.normalize_or(DVec2::X));
        Self { mean: rotation.length(), half_difference: reflection.length(), turn, doubled }
    }
}

/// See [`Svd`]. Blinn 1996, "Consider the lowly 2 x 2 matrix", with half angles by square roots instead of arc
/// tangents.
pub(super) fn svd(matrix: Mat2) -> Svd<Mat2> {
    let Planar { mean, half_difference, turn, doubled: DVec2 { x: cosine, y: sine } } = Planar::new(matrix);
    // Both forms point along the half angle; the one that does not cancel is taken.
    let half = if cosine >= 0.0 { dvec2(1.0 + cosine, sine) } else { dvec2(sine, 1.0 - cosine) };
    let v = half.normalize();
    let u = v.rotate(turn);
    let rotation = |DVec2 { x: cosine, y: sine }| DMat2::from_cols(dvec2(cosine, sine), dvec2(-sine, cosine)).as_mat2();
    Svd { u: rotation(u), sigma: [(mean + half_difference) as f32, (mean - half_difference) as f32], v: rotation(v) }
}
