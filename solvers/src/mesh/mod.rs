//! Closed triangle meshes: read, checked, measured and filled with points.

mod closed;
mod fill;
mod read;

use std::fmt;

pub use closed::ClosedMesh;
pub use read::{read, read_obj};

/// A triangle mesh of which nothing is known yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Finite positions.
    vertices: Vec<[f64; 3]>,
    /// Vertices of each triangle, counter-clockwise seen from outside.
    triangles: Vec<[u32; 3]>,
}

/// Why a mesh is refused, in one line without the file's name.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshError(String);

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for MeshError {}
