//! Fills a closed mesh with points, by the parity of crossings along the third axis.

use super::ClosedMesh;

/// Projection of a vertex along the third axis, with its height.
type Vertex = [f64; 3];

impl ClosedMesh {
    /// The points of a cubic lattice of the given spacing that lie inside, the third axis running fastest. Their number
    /// times the spacing cubed approaches the volume; nothing is normalised.
    ///
    /// A ray that hits an edge or a vertex is counted as if it passed beside it, always on the same side: see
    /// `crosses`.
    pub fn fill(&self, spacing: f64) -> Vec<[f64; 3]> {
        let (low, high) = self.bounds();
        let counts: [usize; 3] =
            std::array::from_fn(|axis| ((high[axis] - low[axis]) / spacing).ceil().max(1.0) as usize);
        // The lattice lies symmetrically in the box.
        let first: [f64; 3] =
            std::array::from_fn(|axis| 0.5 * (low[axis] + high[axis]) - 0.5 * (counts[axis] - 1) as f64 * spacing);
        let columns = Columns::new(self, first, spacing, counts);
        let at = |axis: usize, n: usize| first[axis] + n as f64 * spacing;
        let mut points = Vec::new();
        for i in 0..counts[0] {
            for j in 0..counts[1] {
                points.extend(columns.inside(i, j).map(|k| [at(0, i), at(1, j), at(2, k)]));
            }
        }
        points
    }
}

/// Where the columns of a lattice along the third axis cross a mesh.
pub(super) struct Columns {
    first: [f64; 3],
    spacing: f64,
    counts: [usize; 3],
    /// For each column its crossings from below.
    crossings: Vec<Vec<f64>>,
}

impl Columns {
    /// The crossings of a lattice whose first point and numbers of points are given.
    pub(super) fn new(mesh: &ClosedMesh, first: [f64; 3], spacing: f64, counts: [usize; 3]) -> Self {
        let mut columns = Self { first, spacing, counts, crossings: vec![Vec::new(); counts[0] * counts[1]] };
        for triangle in &mesh.triangles {
            let corners = triangle.map(|vertex| mesh.vertices[vertex as usize]);
            let extreme =
                |axis: usize, pick: fn(f64, f64) -> f64| corners.iter().map(|x| x[axis]).reduce(pick).unwrap_or(0.0);
            for i in columns.range(0, extreme(0, f64::min), extreme(0, f64::max)) {
                for j in columns.range(1, extreme(1, f64::min), extreme(1, f64::max)) {
                    if let Some(height) = crossing(corners, [columns.at(0, i), columns.at(1, j)]) {
                        columns.crossings[i * counts[1] + j].push(height);
                    }
                }
            }
        }
        columns.crossings.iter_mut().for_each(|column| column.sort_by(f64::total_cmp));
        columns
    }

    fn at(&self, axis: usize, n: usize) -> f64 {
        self.first[axis] + n as f64 * self.spacing
    }

    /// The lattice coordinates, from below, that can lie between two values; one more on each side than can, against
    /// rounding.
    fn range(&self, axis: usize, from: f64, to: f64) -> std::ops::Range<usize> {
        let from = ((from - self.first[axis]) / self.spacing).ceil() - 1.0;
        let to = ((to - self.first[axis]) / self.spacing).floor() + 2.0;
        (from.max(0.0) as usize)..(to.max(0.0) as usize).min(self.counts[axis])
    }

    /// Which points of a column lie inside the mesh, from below.
    pub(super) fn inside(&self, i: usize, j: usize) -> impl Iterator<Item = usize> {
        let (pairs, rest) = self.crossings[i * self.counts[1] + j].as_chunks::<2>();
        debug_assert!(rest.is_empty(), "a closed mesh is crossed an even number of times");
        pairs.iter().flat_map(move |&[enter, leave]| {
            let within = move |&k: &usize| enter <= self.at(2, k) && self.at(2, k) < leave;
            self.range(2, enter, leave).filter(within)
        })
    }
}

/// The height at which the line along the third axis through `point` crosses the triangle.
fn crossing([a, b, c]: [Vertex; 3], point: [f64; 2]) -> Option<f64> {
    let inside = crosses(a, b, point) ^ crosses(b, c, point) ^ crosses(c, a, point);
    inside.then(|| {
        let weights = [area(b, c, point), area(c, a, point), area(a, b, point)];
        let total: f64 = weights.iter().sum();
        let height = (weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]) / total;
        // A triangle seen edge-on, or nearly, is crossed somewhere between its corners.
        if total == 0.0 { a[2] } else { height.clamp(a[2].min(b[2]).min(c[2]), a[2].max(b[2]).max(c[2])) }
    })
}

/// Twice the signed area of a projected edge and the point.
fn area(from: Vertex, to: Vertex, point: [f64; 2]) -> f64 {
    (from[0] - point[0]) * (to[1] - point[1]) - (from[1] - point[1]) * (to[0] - point[0])
}

/// Whether the half-line from the point along the first axis crosses the projected edge. The answer belongs to the
/// edge, to the last bit and in whichever direction it is run through, and an edge of a closed mesh has two triangles:
/// so the number of triangles found inside above any point is even, whatever is hit or rounded.
fn crosses(from: Vertex, to: Vertex, point: [f64; 2]) -> bool {
    let (low, high) = if from[1] <= to[1] { (from, to) } else { (to, from) };
    low[1] <= point[1] && point[1] < high[1] && area(low, high, point) > 0.0
}
