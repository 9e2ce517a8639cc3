//! Loops over fields whose memory follows what is active.

use allotrope::layout::ListLayout;
use allotrope::prelude::*;

/// What a cell of the shell holds.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub struct Two {
    /// Distance from the sphere.
    pub u: f32,
    /// Its Laplacian.
    pub w: f32,
}

/// Cells of the cube that the shell lies in, along each axis.
pub const SIDE: usize = 512;

/// Makes the cells active that lie within three cells of a sphere of 200.
#[kernel]
pub fn shell(field: &mut Field<Two, _, Ijk>) {
    for (i, j, k) in ndrange!(50..462, 50..462, 50..462) {
        let from = vec3(i as f32, j as f32, k as f32) - 256.0;
        let distance = from.length() - 200.0;
        if distance.abs() < 3.0 {
            field.u[(i, j, k)] = distance;
        }
    }
}

/// The 7-point Laplacian of the active cells; what is not active counts as zero.
#[kernel]
pub fn laplacian(field: &mut Field<Two, _, Ijk>) {
    for (i, j, k) in field {
        field.w[(i, j, k)] = field.u[(i - 1, j, k)]
            + field.u[(i + 1, j, k)]
            + field.u[(i, j - 1, k)]
            + field.u[(i, j + 1, k)]
            + field.u[(i, j, k - 1)]
            + field.u[(i, j, k + 1)]
            - 6.0 * field.u[(i, j, k)];
    }
}

/// Scales the active cells.
#[kernel]
pub fn scale(field: &mut Field<Two, _, Ijk>, by: f32) {
    for at in field {
        field.u[at] *= by;
    }
}

/// `x * 0.5 + 1` of the active cells.
#[kernel]
pub fn halve(x: &mut Field<f32, _, Ij>) {
    for at in x {
        x[at] = x[at] * 0.5 + 1.0;
    }
}

/// Appends every value to one list.
#[kernel]
pub fn append<L: ListLayout<I>>(values: &[u32], list: &mut Field<u32, L, I>) {
    for v in values {
        list.append((), values[v]);
    }
}
