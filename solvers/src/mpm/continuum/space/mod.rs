//! In space.

use allotrope::prelude::*;

/// A vector.
pub type Vector = Vec3;
/// A matrix; column `n` of a gradient is the derivative along axis `n`.
pub type Matrix = Mat3;
/// A node.
pub type Index = IVec3;
/// The axes of grids.
pub type Nodes = Ijk;
/// Coefficients of a polynomial velocity field.
pub type Modes = [Vec3; 27];

/// How many axes there are.
pub const DIMENSIONS: usize = 3;

/// The polynomial of each mode along each axis: the constant, the linear ones, their products, the squares, and all
/// products with squares.
#[rustfmt::skip]
pub const MODES: [[usize; 3]; 27] = [
    [0, 0, 0],
    [1, 0, 0], [0, 1, 0], [0, 0, 1],
    [1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1],
    [2, 0, 0], [0, 2, 0], [0, 0, 2],
    [2, 1, 0], [2, 0, 1], [2, 1, 1], [1, 2, 0], [0, 2, 1], [1, 2, 1], [1, 0, 2], [0, 1, 2], [1, 1, 2],
    [2, 2, 0], [0, 2, 2], [2, 0, 2], [2, 2, 1], [1, 2, 2], [2, 1, 2], [2, 2, 2],
];

/// A vector from one with a third component.
pub(in crate::mpm) fn vector(v: [f64; 3]) -> Vector {
    vec3(v[0] as f32, v[1] as f32, v[2] as f32)
}

/// A vector with a third component.
pub(in crate::mpm) fn triple(v: Vector) -> [f64; 3] {
    v.to_array().map(f64::from)
}

/// A matrix from its columns.
pub(in crate::mpm) fn from_columns(columns: [Vector; DIMENSIONS]) -> Matrix {
    Matrix::from_cols(columns[0], columns[1], columns[2])
}

/// A matrix from its rows.
pub(in crate::mpm) fn matrix(rows: [[f64; 3]; 3]) -> Matrix {
    let column = |n: usize| vector([rows[0][n], rows[1][n], rows[2][n]]);
    Mat3::from_cols(column(0), column(1), column(2))
}

/// A matrix' rows.
pub(in crate::mpm) fn rows(matrix: Matrix) -> [[f64; 3]; 3] {
    [triple(matrix.row(0)), triple(matrix.row(1)), triple(matrix.row(2))]
}

/// The nodes along each axis.
pub(in crate::mpm) fn extents(grid: [usize; 3]) -> [usize; 3] {
    grid
}

/// A node with a third component.
#[inline(always)]
pub fn node(index: Index) -> IVec3 {
    index
}

/// A velocity with a third component.
#[inline(always)]
pub fn raised(v: Vector) -> Vec3 {
    v
}

/// A velocity without its third component.
#[inline(always)]
pub fn lowered(v: Vec3) -> Vector {
    v
}

/// The product of a column and a row.
#[inline(always)]
pub fn outer(column: Vector, row: Vector) -> Matrix {
    Mat3::from_cols(column * row.x, column * row.y, column * row.z)
}

#[path = "../affine.rs"]
pub mod affine;
#[path = "../carrier.rs"]
mod carrier;
#[path = "../medium.rs"]
mod medium;
#[path = "../plain.rs"]
pub mod plain;
#[path = "../polynomial.rs"]
pub mod polynomial;
mod quadratic;
#[path = "../records.rs"]
mod records;
#[path = "../stencil.rs"]
mod stencil;

pub(in crate::mpm) use carrier::{Affine, Plain, Polynomial};
pub(in crate::mpm) use medium::Continuum;
pub use quadratic::{grid_to_particle, particle_to_grid};
pub use records::{AffinePoint, ChangingNode, Node, PlainPoint, PolynomialPoint};
pub(in crate::mpm) use records::{HotAffine, HotPlain, HotPolynomial};
pub use stencil::{Stencil, Transfers};
