//! Singular values in space: Jacobi rotations of `F^T F`, then the columns of `F V` made orthonormal (McAdams et al.
//! 2011, "Computing the singular value decomposition of 3x3 matrices with minimal branching and elementary floating
//! point operations", with exact Givens rotations).

use allotrope::prelude::*;

use super::Svd;

/// Sweeps over the three pairs of axes; convergence is cubic, and four are hardly ever needed.
const SWEEPS: usize = 10;

/// Columns whose scalar product is below this, relative to their lengths, are orthogonal.
const ORTHOGONAL: f64 = 1e-8;

/// What rounding leaves of a product of columns, relative to the square of the largest singular value.
const ROUNDING: f64 = 1e-16;

/// A second singular value below this, relative to the first, leaves its direction open.
const RANK: f64 = 1e-12;

/// See [`Svd`].
pub(super) fn svd(matrix: Mat3) -> Svd<Mat3> {
    let (u, sigma, v) = decompose(matrix);
    Svd { u: u.as_mat3(), sigma: sigma.as_vec3().to_array(), v: v.as_mat3() }
}

/// `U`, the singular values and `V` in double precision.
pub(super) fn decompose(matrix: Mat3) -> (DMat3, DVec3, DMat3) {
    let matrix = matrix.as_dmat3();
    let mut v = right_vectors(matrix.transpose() * matrix);
    let mut columns = v.map(|v| matrix * v);
    let mut squares = columns.map(DVec3::length_squared);
    for (long, short) in [(0, 1), (1, 2), (0, 1)] {
        if squares[long] < squares[short] {
            squares.swap(long, short);
            columns.swap(long, short);
            v.swap(long, short);
            // An exchange mirrors; so does this, and V remains a rotation.
            columns[short] = -columns[short];
            v[short] = -v[short];
        }
    }
    let v = DMat3::from_cols(v[0], v[1], v[2]);
    let first = squares[0].sqrt();
    if first == 0.0 {
        return (v, DVec3::ZERO, v);
    }
    let x = columns[0] / first;
    let rest = columns[1] - x * x.dot(columns[1]);
    let second = rest.length();
    let y = if second <= RANK * first { x.any_orthonormal_vector() } else { rest / second };
    let z = x.cross(y);
    // The order of values too small for `F^T F` to tell is settled here.
    let second = second.min(first);
    let third = z.dot(columns[2]).min(second).max(-second);
    (DMat3::from_cols(x, y, z), dvec3(first, second, third), v)
}

/// The eigenvectors of a symmetric matrix as columns of a rotation, in no order.
fn right_vectors(symmetric: DMat3) -> [DVec3; 3] {
    let DMat3 { x_axis: x, y_axis: y, z_axis: z } = symmetric;
    let rounding = ROUNDING * (x.x + y.y + z.z);
    let mut state = Jacobi {
        diagonal: [x.x, y.y, z.z],
        mixed: [y.z, z.x, x.y],
        vectors: [DVec3::X, DVec3::Y, DVec3::Z],
        negligible: rounding * rounding,
    };
    for _ in 0..SWEEPS {
        let turned = [state.turn::<0, 1, 2>(), state.turn::<1, 2, 0>(), state.turn::<2, 0, 1>()];
        if turned == [false; 3] {
            break;
        }
    }
    state.vectors
}

/// A symmetric matrix on its way to a diagonal one.
struct Jacobi {
    diagonal: [f64; 3],
    /// Each of the others stands at the axis that it does not involve.
    mixed: [f64; 3],
    vectors: [DVec3; 3],
    /// The square of what counts as nothing.
    negligible: f64,
}

impl Jacobi {
    /// Turns about axis `K`, from `I` to `J`, such that nothing mixes the two; false where hardly anything did.
    // Axes are constants, so that all stays in registers.
    #[inline(always)]
    fn turn<const I: usize, const J: usize, const K: usize>(&mut self) -> bool {
        let Self { diagonal, mixed, vectors, negligible } = self;
        let square = mixed[K] * mixed[K];
        if square <= ORTHOGONAL * ORTHOGONAL * (diagonal[I] * diagonal[J]) || square <= *negligible {
            return false;
        }
        // Half of the angle of (x, y), at most 45 degrees.
        let (x, y) = (diagonal[I] - diagonal[J], 2.0 * mixed[K]);
        let adjacent = x.abs() + (x * x + y * y).sqrt();
        let opposite = y * 1f64.copysign(x);
        let scale = 1.0 / (adjacent * adjacent + opposite * opposite).sqrt();
        let (cosine, sine) = (adjacent * scale, opposite * scale);
        let moved = mixed[K] * (opposite / adjacent);
        diagonal[I] += moved;
        diagonal[J] -= moved;
        mixed[K] = 0.0;
        (mixed[I], mixed[J]) = (cosine * mixed[I] - sine * mixed[J], cosine * mixed[J] + sine * mixed[I]);
        (vectors[I], vectors[J]) = (vectors[I] * cosine + vectors[J] * sine, vectors[J] * cosine - vectors[I] * sine);
        true
    }
}
