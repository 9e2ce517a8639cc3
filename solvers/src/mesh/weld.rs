//! Puts a mesh together from vertices that may be told more than once.

use std::collections::HashMap;

use super::{Mesh, MeshError};

/// A mesh that is being read, in which vertices at equal positions are one.
pub(super) struct Welder {
    mesh: Mesh,
    known: HashMap<[u64; 3], u32>,
}

impl Default for Welder {
    fn default() -> Self {
        Self { mesh: Mesh { vertices: Vec::new(), triangles: Vec::new() }, known: HashMap::new() }
    }
}

impl Welder {
    /// The number of the vertex at a position.
    ///
    /// # Errors
    /// If the position is not finite.
    pub(super) fn vertex(&mut self, position: [f64; 3]) -> Result<u32, MeshError> {
        if position.iter().any(|x| !x.is_finite()) {
            return Err(MeshError(format!("has a vertex that is not finite, {position:?}")));
        }
        // `+ 0.0` makes the two zeros one.
        let next = self.mesh.vertices.len() as u32;
        let vertex = *self.known.entry(position.map(|x| (x + 0.0).to_bits())).or_insert(next);
        if vertex == next {
            self.mesh.vertices.push(position);
        }
        Ok(vertex)
    }

    /// Adds a triangle. One that names a vertex twice has no area, and its neighbours meet where it is left out.
    pub(super) fn triangle(&mut self, [a, b, c]: [u32; 3]) {
        if a != b && b != c && c != a {
            self.mesh.triangles.push([a, b, c]);
        }
    }

    /// The mesh.
    ///
    /// # Errors
    /// If there is no triangle.
    pub(super) fn finish(self) -> Result<Mesh, MeshError> {
        if self.mesh.triangles.is_empty() { Err(MeshError("has no faces".into())) } else { Ok(self.mesh) }
    }
}
