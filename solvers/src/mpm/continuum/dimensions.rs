//! The plane and space, with what materials and polynomial fields need to know of them.

use std::fmt::Debug;

use allotrope::Element;
use allotrope::prelude::*;
use allotrope::spatial::*;

use crate::linear;

/// The axes of a plane or of space, of whose matrices materials know the singular values.
pub trait Dimensions: Spatial<Mat<f32>: linear::Matrix> {
    /// Coefficients of a polynomial velocity field.
    type Modes: Element<Scalar = f32> + Default + PartialEq + Debug + AsRef<[Self::Vec<f32>]> + AsMut<[Self::Vec<f32>]>;

    /// The polynomial of each mode along each axis: its power.
    const MODES: &'static [[usize; 3]];
}

impl Dimensions for Ij {
    type Modes = [Vec2; 9];

    /// In the order of Fu et al. (2017): 1, x, y, xy, x^2, y^2, x^2 y, x y^2, x^2 y^2.
    #[rustfmt::skip]
    const MODES: &'static [[usize; 3]] = &[
        [0, 0, 0],
        [1, 0, 0], [0, 1, 0], [1, 1, 0],
        [2, 0, 0], [0, 2, 0],
        [2, 1, 0], [1, 2, 0], [2, 2, 0],
    ];
}

impl Dimensions for Ijk {
    type Modes = [Vec3; 27];

    /// The constant, the linear ones, their products, the squares, and all products with squares.
    #[rustfmt::skip]
    const MODES: &'static [[usize; 3]] = &[
        [0, 0, 0],
        [1, 0, 0], [0, 1, 0], [0, 0, 1],
        [1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1],
        [2, 0, 0], [0, 2, 0], [0, 0, 2],
        [2, 1, 0], [2, 0, 1], [2, 1, 1], [1, 2, 0], [0, 2, 1], [1, 2, 1], [1, 0, 2], [0, 1, 2], [1, 1, 2],
        [2, 2, 0], [0, 2, 2], [2, 0, 2], [2, 2, 1], [1, 2, 2], [2, 1, 2], [2, 2, 2],
    ];
}
