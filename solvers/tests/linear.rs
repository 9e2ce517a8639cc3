//! Singular value and polar decompositions, judged in double precision; iterative solvers in their modules.

#[path = "linear/failures.rs"]
mod failures;
#[path = "linear/laplacian.rs"]
mod laplacian;
#[path = "linear/matrices.rs"]
mod matrices;

use allotrope::prelude::*;
use allotrope_solvers::linear::{Matrix, Polar, Svd};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The largest relative error that any test meets is about 2e-7.
const TOLERANCE: f64 = 5e-7;

/// What the tests ask of matrices of either size.
trait Judged: Matrix {
    /// In double precision; in the plane with a third axis of zeros and a one.
    fn widen(self) -> DMat3;

    /// The upper left corner of rows.
    fn corner(rows: [[f32; 3]; 3]) -> Self;
}

impl Judged for Mat2 {
    fn widen(self) -> DMat3 {
        DMat3::from_mat2(self.as_dmat2())
    }

    fn corner([[a, b, _], [c, d, _], _]: [[f32; 3]; 3]) -> Self {
        mat2(vec2(a, c), vec2(b, d))
    }
}

impl Judged for Mat3 {
    fn widen(self) -> DMat3 {
        self.as_dmat3()
    }

    fn corner([[a, b, c], [d, e, f], [g, h, i]]: [[f32; 3]; 3]) -> Self {
        mat3(vec3(a, d, g), vec3(b, e, h), vec3(c, f, i))
    }
}

/// The largest component of a difference.
fn distance(one: DMat3, other: DMat3) -> f64 {
    (one - other).to_cols_array().iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Checks the factors of a matrix, and returns the largest relative error met.
fn check<M: Judged>(matrix: M) -> f64 {
    let Svd { u, sigma, v } = matrix.svd();
    let Polar { rotation, symmetric } = matrix.polar();
    let values = sigma.as_ref();
    assert!(values.windows(2).all(|pair| pair[0] >= pair[1].abs()), "{matrix:?}: {values:?} out of order");
    assert!(values[..M::DIMENSIONS - 1].iter().all(|value| *value >= 0.0), "{matrix:?}: {values:?}");
    let scale = f64::from(values[0]);
    let mut full = [1.0; 3];
    for (full, value) in full.iter_mut().zip(values) {
        *full = f64::from(*value);
    }
    let relative = |one: DMat3, other: DMat3| if scale == 0.0 { 0.0 } else { distance(one, other) / scale };
    let (u, v, rotation, symmetric) = (u.widen(), v.widen(), rotation.widen(), symmetric.widen());
    let diagonal = DMat3::from_diagonal(full.into());
    let matrix = matrix.widen();
    let mut error = relative(u * diagonal * v.transpose(), matrix).max(relative(rotation * symmetric, matrix));
    error = error.max(relative(v * diagonal * v.transpose(), symmetric));
    for factor in [u, v, rotation] {
        error = error.max(distance(factor * factor.transpose(), DMat3::IDENTITY));
        error = error.max((factor.determinant() - 1.0).abs());
    }
    error = error.max(distance(u * v.transpose(), rotation));
    assert_eq!(symmetric, symmetric.transpose(), "{matrix:?}");
    assert!(error < TOLERANCE, "{matrix:?}: error {error:e}");
    error
}

fn near(values: &[f32], expected: &[f64]) {
    for (value, expected) in values.iter().zip(expected) {
        assert!((f64::from(*value) - expected).abs() < 1e-7 * expected.abs().max(1.0), "{values:?}, not {expected:?}");
    }
}

/// Uniformly from -1 to 1.
fn unit(random: &mut ChaCha8Rng) -> f32 {
    (f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0) as f32
}

fn random_matrix<M: Judged>(random: &mut ChaCha8Rng) -> M {
    M::corner(std::array::from_fn(|_| std::array::from_fn(|_| unit(random))))
}

fn random_rotation<M: Judged>(random: &mut ChaCha8Rng) -> M {
    random_matrix::<M>(random).polar().rotation
}

#[test]
fn a_known_matrix_of_space_has_its_factors() {
    let matrix = Mat3::corner([[1.0, 0.2, 0.0], [0.0, 1.1, 0.3], [0.1, 0.0, 0.9]]);
    check(matrix);
    near(&matrix.svd().sigma, &[1.2403293, 0.96064339, 0.83591119]);
    let Polar { rotation, symmetric } = matrix.polar();
    near(
        &rotation.transpose().to_cols_array(),
        &[
            0.9924534252,
            0.1071125469,
            -0.0596917174,
            -0.0966696912,
            0.9829298876,
            0.1565369187,
            0.0754398411,
            -0.1495852213,
            0.9858666705,
        ],
    );
    near(
        &symmetric.to_cols_array(),
        &[
            0.9999974093,
            0.0921540247,
            0.0388949496,
            0.0921540247,
            1.1026453857,
            0.1602522671,
            0.0388949496,
            0.1602522671,
            0.934241079,
        ],
    );
}

#[test]
fn a_known_matrix_of_the_plane_has_its_factors_and_its_sign_on_the_smallest() {
    let matrix = mat2(vec2(-1.0, 0.3), vec2(0.2, 0.5));
    check(matrix);
    near(&matrix.svd().sigma, &[1.04552039, -0.53561844]);
}

#[test]
fn rotations_are_their_own_polar_factor() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..1000 {
        let (plane, space): (Mat2, Mat3) = (random_rotation(&mut random), random_rotation(&mut random));
        check(plane);
        check(space);
        near(&plane.svd().sigma, &[1.0, 1.0]);
        near(&space.svd().sigma, &[1.0, 1.0, 1.0]);
        assert!(plane.polar().rotation.abs_diff_eq(plane, 2e-7), "{plane}");
        assert!(space.polar().rotation.abs_diff_eq(space, 2e-7), "{space}");
    }
    check(Mat2::IDENTITY);
    check(Mat3::IDENTITY);
}

/// Zeros, ranks below the full, repeated values, and values far apart, in all orders and with all signs, seen from many
/// sides.
#[test]
fn degenerate_and_inverted_matrices_are_decomposed() {
    let mut random = ChaCha8Rng::seed_from_u64(2);
    let values = [0.0, 1.0, -1.0, 2.0, 1.0 + 1e-6, 0.5, 1e-4, 1e-7, -1e-9, 1e-12];
    for a in values {
        for b in values {
            let plane = Mat2::from_diagonal(vec2(a, b));
            for _ in 0..4 {
                check(plane);
                check(random_rotation::<Mat2>(&mut random) * plane * random_rotation::<Mat2>(&mut random));
            }
            for c in values {
                let space = Mat3::from_diagonal(vec3(a, b, c));
                check(space);
                for _ in 0..4 {
                    let (left, right): (Mat3, Mat3) = (random_rotation(&mut random), random_rotation(&mut random));
                    check(left * space);
                    check(left * space * right);
                    let expected = a * b * c;
                    if expected.abs() > 1e-3 {
                        let sigma = (left * space * right).svd().sigma;
                        assert_eq!(sigma[2] < 0.0, expected < 0.0, "{a} {b} {c}: {sigma:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn zero_has_rotations_all_the_same() {
    check(Mat2::ZERO);
    check(Mat3::ZERO);
    assert_eq!(Mat2::ZERO.polar().rotation, Mat2::IDENTITY);
    assert_eq!(Mat3::ZERO.polar().rotation, Mat3::IDENTITY);
    // Sums of outer products, as exact as they can be.
    check(Mat2::corner([[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0; 3]]));
    check(Mat3::corner([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 6.0, 9.0]]));
    check(Mat3::corner([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]));
    check(Mat3::corner([[0.0, 0.0, 7.0], [0.0; 3], [0.0; 3]]));
}

#[test]
fn scale_is_of_no_account() {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    for scale in [1e-36, 1e-30, 1e-20, 1e-8, 1e8, 1e20, 1e30, 1e37] {
        for _ in 0..500 {
            check(random_matrix::<Mat2>(&mut random) * scale);
            check(random_matrix::<Mat3>(&mut random) * scale);
        }
    }
    // Below the normal numbers little but their own steps is left to be exact to.
    let smallest = Mat3::from_cols_array(&[f32::from_bits(1); 9]);
    assert!(smallest.svd().product().is_finite() && smallest.polar().rotation.is_finite());
}

#[test]
fn random_matrices_are_decomposed() {
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let (mut plane, mut space) = (0f64, 0f64);
    for n in 0..20000 {
        // From any to nearly the identity, as simulations have them.
        let spread = [1.0, 1e-1, 1e-3, 1e-5][n % 4];
        let near = |n: usize| if n.is_multiple_of(4) { 0.0 } else { 1.0 };
        plane = plane.max(check(Mat2::IDENTITY * near(n) + random_matrix::<Mat2>(&mut random) * spread));
        space = space.max(check(Mat3::IDENTITY * near(n) + random_matrix::<Mat3>(&mut random) * spread));
    }
    println!("largest errors: {plane:e} in 2D, {space:e} in 3D");
}

#[test]
fn what_is_not_finite_ends_without_a_panic() {
    for value in [f32::NAN, f32::INFINITY] {
        let plane = Mat2::corner([[value, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0; 3]]);
        let space = Mat3::corner([[value, 0.1, 0.3], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert!(!plane.svd().product().is_finite());
        assert!(!space.svd().product().is_finite());
    }
}

#[test]
fn changes_of_volume_are_not_lost_to_rounding() {
    let mut random = ChaCha8Rng::seed_from_u64(5);
    for _ in 0..1000 {
        let space = Mat3::IDENTITY + random_matrix::<Mat3>(&mut random) * 1e-4;
        let plane = Mat2::IDENTITY + random_matrix::<Mat2>(&mut random) * 1e-4;
        let exact = [space.as_dmat3().determinant() - 1.0, plane.as_dmat2().determinant() - 1.0];
        for (change, exact) in [space.volume_change(), plane.volume_change()].into_iter().zip(exact) {
            assert!((f64::from(change) - exact).abs() < 1e-10, "{change} is not {exact}");
        }
    }
    let space = Mat3::corner([[1.0, 2.0, -1.0], [0.5, -3.0, 2.0], [4.0, 1.0, 0.25]]);
    assert!((space.volume_change() + 1.0 - space.determinant()).abs() < 1e-5);
}
