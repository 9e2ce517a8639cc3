//! Closed triangle meshes: read, checked, measured, filled with points, and distances from them.

mod closed;
mod distance;
mod fill;
mod obj;
mod ply;
mod read;
mod stl;
mod weld;

use std::fmt;

pub use closed::ClosedMesh;
pub use distance::SignedDistance;
pub use obj::read_obj;
pub use read::read;

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
