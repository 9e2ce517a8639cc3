//! In the plane.

use allotrope::prelude::*;

/// A vector.
pub type Vector = Vec2;
/// A matrix; column `n` of a gradient is the derivative along axis `n`.
pub type Matrix = Mat2;
/// A node.
pub type Index = IVec2;
/// The axes of grids.
pub type Nodes = Ij;
/// Coefficients of a polynomial velocity field.
pub type Modes = [Vec2; 9];

/// How many axes there are.
pub const DIMENSIONS: usize = 2;

/// The polynomial of each mode along each axis, in the order of Fu et al. (2017): 1, x, y, xy, x^2, y^2, x^2 y, x y^2, x^2
/// y^2.
pub const MODES: [[usize; 2]; 9] = [[0, 0], [1, 0], [0, 1], [1, 1], [2, 0], [0, 2], [2, 1], [1, 2], [2, 2]];

/// A vector from one with a third component.
pub(in crate::mpm) fn vector(v: [f64; 3]) -> Vector {
    vec2(v[0] as f32, v[1] as f32)
}

/// A vector with a third component.
pub(in crate::mpm) fn triple(v: Vector) -> [f64; 3] {
    [f64::from(v.x), f64::from(v.y), 0.0]
}

/// A matrix from its columns.
pub(in crate::mpm) fn from_columns(columns: [Vector; DIMENSIONS]) -> Matrix {
    Matrix::from_cols(columns[0], columns[1])
}

/// A matrix from its rows.
pub(in crate::mpm) fn matrix(rows: [[f64; 3]; 3]) -> Matrix {
    let column = |n: usize| vector([rows[0][n], rows[1][n], 0.0]);
    Mat2::from_cols(column(0), column(1))
}

/// A matrix' rows.
pub(in crate::mpm) fn rows(matrix: Matrix) -> [[f64; 3]; 3] {
    [triple(matrix.row(0)), triple(matrix.row(1)), [0.0; 3]]
}

/// The nodes along each axis.
pub(in crate::mpm) fn extents(grid: [usize; 3]) -> [usize; 2] {
    [grid[0], grid[1]]
}

/// A node with a third component.
#[inline(always)]
pub fn node(index: Index) -> IVec3 {
    index.extend(0)
}

/// A velocity with a third component.
#[inline(always)]
pub fn raised(v: Vector) -> Vec3 {
    v.extend(0.0)
}

/// A velocity without its third component.
#[inline(always)]
pub fn lowered(v: Vec3) -> Vector {
    v.truncate()
}

/// The product of a column and a row.
#[inline(always)]
pub fn outer(column: Vector, row: Vector) -> Matrix {
    Mat2::from_cols(column * row.x, column * row.y)
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
