//! The check that a mesh has an inside.

use std::collections::HashMap;

use super::{Mesh, MeshError};

/// A mesh in which every edge belongs to exactly two triangles, which run through it in opposite directions: it has an
/// inside, and a volume.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedMesh {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// Checks that the mesh is closed.
    ///
    /// # Errors
    /// The number of edges at which it is not, and where the first of them lies.
    pub fn closed(self) -> Result<ClosedMesh, MeshError> {
        // How often each edge is run through upwards (from the lower vertex to the higher) and downwards.
        let mut edges: HashMap<(u32, u32), (u32, u32)> = HashMap::new();
        for &[a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let passes = edges.entry((from.min(to), from.max(to))).or_default();
                if from < to { passes.0 += 1 } else { passes.1 += 1 }
            }
        }
        let fault = |what: &str, is: &dyn Fn(u32, u32) -> bool| {
            let faulty = edges.iter().filter(|(_, passes)| is(passes.0, passes.1)).map(|(edge, _)| *edge);
            let count = faulty.clone().count();
            let (a, b) = faulty.min()?;
            let place = |vertex: u32| {
                let [x, y, z] = self.vertices[vertex as usize];
                format!("({x}, {y}, {z})")
            };
            let plural = if count == 1 { "edge" } else { "edges" };
            Some(MeshError(format!(
                "is not closed: {count} {plural} {what}, the first from {} to {}",
                place(a),
                place(b)
            )))
        };
        let open = fault("open, with a face on one side only", &|up, down| up + down == 1);
        let crowded = || fault("shared by more than two faces", &|up, down| up + down > 2);
        let turned = || fault("between faces of opposite orientation", &|up, down| up != down);
        match open.or_else(crowded).or_else(turned) {
            Some(fault) => Err(fault),
            None => Ok(ClosedMesh { vertices: self.vertices, triangles: self.triangles }),
        }
    }
}

impl ClosedMesh {
    /// The volume inside, by the divergence theorem.
    pub fn volume(&self) -> f64 {
        let six_fold: f64 = self
            .triangles
            .iter()
            .map(|triangle| {
                // About the first vertex, so that a mesh far from the origin loses no digits.
                let [a, b, c] = triangle.map(|vertex| self.arm_of(vertex));
                let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
                a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]
            })
            .sum();
        (six_fold / 6.0).abs()
    }

    fn arm_of(&self, vertex: u32) -> [f64; 3] {
        let (first, x) = (self.vertices[0], self.vertices[vertex as usize]);
        std::array::from_fn(|axis| x[axis] - first[axis])
    }

    /// The corners of each triangle, counter-clockwise seen from outside.
    pub fn corners(&self) -> impl Iterator<Item = [[f64; 3]; 3]> + '_ {
        self.triangles.iter().map(|triangle| triangle.map(|vertex| self.vertices[vertex as usize]))
    }

    /// The mesh scaled, then moved.
    pub fn placed(mut self, scale: f64, offset: [f64; 3]) -> Self {
        for vertex in &mut self.vertices {
            *vertex = std::array::from_fn(|axis| vertex[axis] * scale + offset[axis]);
        }
        self
    }

    /// The lower and the upper corner of the smallest box around it.
    pub fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        let least = |a: [f64; 3], b: &[f64; 3]| std::array::from_fn(|axis| a[axis].min(b[axis]));
        let most = |a: [f64; 3], b: &[f64; 3]| std::array::from_fn(|axis| a[axis].max(b[axis]));
        (self.vertices.iter().fold(self.vertices[0], least), self.vertices.iter().fold(self.vertices[0], most))
    }
}
