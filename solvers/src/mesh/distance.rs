//! How far a place is from a closed mesh, and on which side.

use super::ClosedMesh;
use super::fill::Columns;

/// Cells around a triangle in which every node is measured against it, so that distances up to as many are exact.
const BAND: f64 = 3.0;

/// More nodes than this are not made; the lattice becomes coarser instead.
const MOST_NODES: f64 = (1 << 24) as f64;

/// Distances from a closed mesh, negative inside, at the nodes of a regular lattice around it.
///
/// Within three cells of the surface they are exact; farther away they are those to a triangle that is nearest, or nearly
/// so, found from node to node. The side is told by the parity of crossings, as when a mesh is filled.
#[derive(Clone, Debug)]
pub struct SignedDistance {
    low: [f64; 3],
    spacing: f64,
    /// Nodes along each axis; the third runs fastest.
    counts: [usize; 3],
    values: Vec<f32>,
}

impl SignedDistance {
    /// Measures the distances at nodes `spacing` apart, over the mesh and two cells around it. A lattice of more than
    /// 2^24 nodes is made coarser.
    pub fn new(mesh: &ClosedMesh, spacing: f64) -> Self {
        let (low, high) = mesh.bounds();
        let cells = |spacing: f64| [0, 1, 2].map(|axis| ((high[axis] - low[axis]) / spacing).ceil() + 4.0);
        let mut spacing = spacing;
        while cells(spacing).iter().map(|cells| cells + 1.0).product::<f64>() > MOST_NODES {
            spacing *= 1.25;
        }
        let counts = cells(spacing).map(|cells| cells as usize + 1);
        let low = low.map(|x| x - 2.0 * spacing);
        let mut distances =
            Distances { mesh, low, spacing, counts, nearest: vec![(f32::INFINITY, 0); counts.iter().product()] };
        distances.measure_near();
        distances.spread();

        let columns = Columns::new(mesh, low, spacing, counts);
        let mut values: Vec<f32> = distances.nearest.iter().map(|(squared, _)| squared.sqrt()).collect();
        for (column, values) in values.chunks_mut(counts[2]).enumerate() {
            columns.inside(column / counts[1], column % counts[1]).for_each(|k| values[k] = -values[k]);
        }
        Self { low, spacing, counts, values }
    }

    /// The distance from the surface in m, negative inside, and the direction of length one in which it grows fastest,
    /// which is outwards: interpolated from the eight nodes around. Nothing outside of the lattice.
    ///
    /// Where no direction is the fastest, as in the middle of a ball, the direction is that of the second axis.
    pub fn at(&self, x: [f64; 3]) -> Option<(f64, [f64; 3])> {
        let mut first = [0; 3];
        let mut part = [0.0; 3];
        for axis in 0..3 {
            let place = (x[axis] - self.low[axis]) / self.spacing;
            if !(0.0..=(self.counts[axis] - 1) as f64).contains(&place) {
                return None;
            }
            first[axis] = (place as usize).min(self.counts[axis] - 2);
            part[axis] = place - first[axis] as f64;
        }
        let (mut distance, mut gradient) = (0.0, [0.0; 3]);
        for corner in 0..8 {
            let upper = [0, 1, 2].map(|axis| corner >> axis & 1);
            let [i, j, k] = [0, 1, 2].map(|axis| first[axis] + upper[axis]);
            let value = f64::from(self.values[(i * self.counts[1] + j) * self.counts[2] + k]);
            let weight = [0, 1, 2].map(|axis| if upper[axis] == 1 { part[axis] } else { 1.0 - part[axis] });
            distance += weight[0] * weight[1] * weight[2] * value;
            for axis in 0..3 {
                let sign = if upper[axis] == 1 { 1.0 } else { -1.0 };
                gradient[axis] += sign * weight[(axis + 1) % 3] * weight[(axis + 2) % 3] * value;
            }
        }
        let length = dot(gradient, gradient).sqrt();
        let normal = if length > 1e-6 * self.spacing { gradient.map(|g| g / length) } else { [0.0, 1.0, 0.0] };
        Some((distance, normal))
    }
}

/// Squares of distances while they are found.
struct Distances<'a> {
    mesh: &'a ClosedMesh,
    low: [f64; 3],
    spacing: f64,
    counts: [usize; 3],
    /// At each node, the square of the distance from a triangle, and which.
    nearest: Vec<(f32, u32)>,
}

impl Distances<'_> {
    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (i * self.counts[1] + j) * self.counts[2] + k
    }

    fn place(&self, node: [usize; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.low[axis] + node[axis] as f64 * self.spacing)
    }

    fn corners(&self, triangle: u32) -> [[f64; 3]; 3] {
        self.mesh.triangles[triangle as usize].map(|vertex| self.mesh.vertices[vertex as usize])
    }

    fn try_triangle(&mut self, node: [usize; 3], triangle: u32) {
        let squared = squared_distance(self.place(node), self.corners(triangle)) as f32;
        let index = self.index(node);
        if squared < self.nearest[index].0 {
            self.nearest[index] = (squared, triangle);
        }
    }

    /// Measures every node near a triangle against it.
    fn measure_near(&mut self) {
        for triangle in 0..self.mesh.triangles.len() as u32 {
            let corners = self.corners(triangle);
            let range = |axis: usize| {
                let places = corners.map(|x| (x[axis] - self.low[axis]) / self.spacing);
                let low = places.into_iter().fold(f64::INFINITY, f64::min) - BAND;
                let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max) + BAND;
                low.ceil().max(0.0) as usize..(high.floor() as usize + 1).min(self.counts[axis])
            };
            let [columns, rows, heights] = [range(0), range(1), range(2)];
            for i in columns {
                for j in rows.clone() {
                    heights.clone().for_each(|k| self.try_triangle([i, j, k], triangle));
                }
            }
        }
    }

    /// Measures the other nodes against the triangles that are nearest to their neighbours: to those before them in
    /// memory on the way up, to those after them on the way down.
    fn spread(&mut self) {
        let before: Vec<[isize; 3]> = (0..13).map(|n| [n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1]).collect();
        let after: Vec<[isize; 3]> = before.iter().map(|step| step.map(|s| -s)).collect();
        let count = self.nearest.len();
        for n in 0..count {
            self.try_neighbours(n, &before);
        }
        for n in (0..count).rev() {
            self.try_neighbours(n, &after);
        }
    }

    fn try_neighbours(&mut self, n: usize, steps: &[[isize; 3]]) {
        let node = [n / self.counts[2] / self.counts[1], n / self.counts[2] % self.counts[1], n % self.counts[2]];
        let near = (BAND * self.spacing).powi(2) as f32;
        for step in steps {
            let mut other = [0; 3];
            let within = (0..3).all(|axis| {
                let place = node[axis].checked_add_signed(step[axis]).filter(|&place| place < self.counts[axis]);
                other[axis] = place.unwrap_or(0);
                place.is_some()
            });
            let (squared, known) = self.nearest[n];
            if squared <= near {
                return;
            }
            if within {
                let (theirs, triangle) = self.nearest[self.index(other)];
                if theirs.is_finite() && (triangle != known || squared.is_infinite()) {
                    self.try_triangle(node, triangle);
                }
            }
        }
    }
}

/// The square of a place's distance from a triangle: from its plane, where the foot of the perpendicular lies inside,
/// else from its nearest edge.
fn squared_distance(x: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> f64 {
    let normal = cross(minus(b, a), minus(c, a));
    let area = dot(normal, normal);
    let inner = |from, to| dot(cross(minus(to, from), minus(x, from)), normal) >= 0.0;
    if area > 0.0 && inner(a, b) && inner(b, c) && inner(c, a) {
        return dot(minus(x, a), normal).powi(2) / area;
    }
    let edge = |from, to| {
        let (along, arm) = (minus(to, from), minus(x, from));
        let length = dot(along, along);
        let part = if length > 0.0 { (dot(arm, along) / length).clamp(0.0, 1.0) } else { 0.0 };
        let foot = minus(arm, along.map(|component| part * component));
        dot(foot, foot)
    };
    edge(a, b).min(edge(b, c)).min(edge(c, a))
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
