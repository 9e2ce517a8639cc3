//! Colliders in space: what is seen of them, in depths that are compared with those of the fluid.

use std::sync::LazyLock;

use super::collider::Placed;
use super::colour::Colour;
use super::space::{SUN, View};

pub(super) type Vec3 = [f64; 3];

pub(super) fn minus(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub(super) fn plus(a: Vec3, b: Vec3, factor: f64) -> Vec3 {
    std::array::from_fn(|axis| a[axis] + factor * b[axis])
}

pub(super) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn unit(a: Vec3) -> Vec3 {
    let length = dot(a, a).sqrt().max(1e-30);
    a.map(|component| component / length)
}

/// Of the surfaces, and of what they mirror at their rims.
static GREYS: LazyLock<[Colour; 2]> = LazyLock::new(|| [0x7c8594, 0xb9c6da].map(Colour::hex));

/// The nearest collider in each pixel.
pub(super) struct Solid {
    columns: usize,
    /// Infinite where there is none.
    pub(super) depth: Vec<f32>,
    normal: Vec<[f32; 3]>,
}

impl Solid {
    /// Balls and boxes, meshes by their triangles, and of the plane of a half-space what lies in the tank.
    pub(super) fn new(view: &View, colliders: &[Placed<'_>]) -> Self {
        let pixels = if colliders.is_empty() { 0 } else { view.columns * view.rows };
        let mut solid = Self {
            columns: view.columns,
            depth: vec![f32::INFINITY; view.columns * view.rows],
            normal: vec![[0.0; 3]; pixels],
        };
        for shape in colliders {
            for corners in triangles(shape) {
                solid.triangle(view, corners);
            }
            if !matches!(shape, Placed::Mesh { .. }) {
                solid.cast(view, shape);
            }
        }
        solid
    }

    /// A shape that says itself where a ray meets it.
    fn cast(&mut self, view: &View, shape: &Placed<'_>) {
        // A plane that lies on a side of the tank is to be seen in spite of rounding.
        let room = 1e-6 * dot(minus(view.high, view.low), minus(view.high, view.low)).sqrt();
        let inside = |x: Vec3| (0..3).all(|axis| (view.low[axis] - room..=view.high[axis] + room).contains(&x[axis]));
        for pixel in 0..self.depth.len() {
            let ray = view.ray((pixel % self.columns) as f64, (pixel / self.columns) as f64);
            if let Some((depth, normal)) = shape.hit(view.eye, ray)
                && (!matches!(shape, Placed::HalfSpace { .. }) || inside(plus(view.eye, ray, depth)))
            {
                self.put(pixel, depth, normal);
            }
        }
    }

    /// A flat triangle, both sides of which are seen.
    fn triangle(&mut self, view: &View, corners: [Vec3; 3]) {
        let [a, b, c] = corners.map(|corner| view.project(corner));
        if [a, b, c].iter().any(|corner| corner.2 <= 0.0) {
            return;
        }
        let normal = unit(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
        let normal = if dot(normal, minus(view.eye, corners[0])) < 0.0 { normal.map(|n| -n) } else { normal };
        let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        let range = |a: f64, b: f64, c: f64, end: usize| {
            (a.min(b).min(c).ceil().max(0.0) as usize)
                ..((a.max(b).max(c).floor() + 1.0).clamp(0.0, end as f64) as usize)
        };
        for row in range(a.1, b.1, c.1, view.rows) {
            for column in range(a.0, b.0, c.0, view.columns) {
                let (x, y) = (column as f64, row as f64);
                let across =
                    |p: (f64, f64, f64), q: (f64, f64, f64)| ((q.0 - p.0) * (y - p.1) - (q.1 - p.1) * (x - p.0)) / area;
                let (u, v, w) = (across(b, c), across(c, a), across(a, b));
                if u >= 0.0 && v >= 0.0 && w >= 0.0 {
                    // It is the inverse of depth that is linear in the picture.
                    self.put(row * self.columns + column, 1.0 / (u / a.2 + v / b.2 + w / c.2), normal);
                }
            }
        }
    }

    fn put(&mut self, pixel: usize, depth: f64, normal: Vec3) {
        if (depth as f32) < self.depth[pixel] {
            self.depth[pixel] = depth as f32;
            self.normal[pixel] = normal.map(|component| component as f32);
        }
    }

    /// The colour of the collider that a pixel shows: grey, lit from above.
    pub(super) fn shade(&self, pixel: usize, ray: Vec3) -> Colour {
        let normal = self.normal[pixel].map(f64::from);
        let diffuse = (0.5 + 0.5 * dot(normal, unit(SUN))).clamp(0.0, 1.0).powi(2) as f32;
        let rim = (1.0 - (-dot(normal, unit(ray))).clamp(0.0, 1.0)).powi(3) as f32;
        GREYS[0] * (0.15 + 0.95 * diffuse) + GREYS[1] * (0.12 * rim)
    }
}

/// The triangles of a mesh where it stands; none of other shapes.
pub(super) fn triangles<'a>(shape: &Placed<'a>) -> impl Iterator<Item = [Vec3; 3]> + use<'a> {
    let (mesh, moved) = match *shape {
        Placed::Mesh { mesh, moved } => (Some(mesh), moved),
        _ => (None, [0.0; 3]),
    };
    let triangles = mesh.into_iter().flat_map(|mesh| mesh.corners());
    triangles.map(move |corners| corners.map(|corner| plus(corner, moved, 1.0)))
}
