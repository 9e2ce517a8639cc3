//! Pictures of space: particles as balls in a perspective view, their depths smoothed into a surface, which is lit;
//! particles that are joined as small balls with rods between them.

use std::sync::LazyLock;

use allotrope_solvers::Simulation;

use allotrope_solvers::scene::CameraPlace;

use super::canvas::{Canvas, for_pieces};
use super::collider::{self, Placed};
use super::colour::{Colour, NIGHT};
use super::solid::{self, Solid, Vec3, cross, dot, minus, plus, unit};
use super::wires::{self, Dot};
use super::{Camera, SIDE};

/// Radius of a ball, in distances between particles at rest: neighbours overlap.
const RADIUS: f64 = 0.95;

/// Depths are smoothed over so many radii of a ball, as they appear, ..
const SMOOTH: f64 = 1.6;

/// .. but not where they differ by more than so many radii.
const EDGE: f64 = 3.0;

/// Where the light comes from.
pub(super) const SUN: Vec3 = [-0.5, 1.0, 0.55];

pub(super) fn draw(camera: &Camera, simulation: &dyn Simulation) -> Canvas {
    let view = View::new(simulation, &camera.place);
    let positions = simulation.positions();
    let radius = RADIUS * simulation.spacing();

    let mut surface = Surface::new(&view);
    let (dots, rods) = wires::dots_and_lines(simulation, camera.colours(simulation), |x| x);
    if rods.is_empty() {
        for dot in &dots {
            surface.splat(&view, dot.at, radius, dot.colour);
        }
        surface.smooth(&view, radius);
    } else {
        // Masses far apart are no larger for it.
        let spacing = simulation.spacing().min(0.1 * simulation.extent().into_iter().fold(0.0, f64::max));
        for ends in &rods {
            surface.rod(&view, ends, wires::LINE * spacing);
        }
        for dot in &dots {
            surface.splat(&view, dot.at, view.visible(dot.at, wires::DOT * spacing), dot.colour);
        }
    }
    let colliders = collider::at(&camera.colliders, simulation.time());
    let solid = Solid::new(&view, &colliders);

    let shadow = Shadow::new(simulation, &positions, &colliders);
    let mut canvas =
        Canvas::of(view.columns, view.rows, |column, row| shade(&view, &surface, &solid, &shadow, column, row));
    for (from, to) in view.edges() {
        draw_line(&mut canvas, &view, &surface, &solid, from, to);
    }
    canvas.halved()
}

/// The eye, and the picture plane.
pub(super) struct View {
    pub(super) columns: usize,
    pub(super) rows: usize,
    pub(super) eye: Vec3,
    right: Vec3,
    up: Vec3,
    ahead: Vec3,
    /// Pixels of a length that is as far off as it is long.
    focus: f64,
    /// What lies in the middle of the picture, right of and above straight ahead, per depth.
    middle: [f64; 2],
    /// The inner corners of the tank.
    pub(super) low: Vec3,
    pub(super) high: Vec3,
}

impl View {
    /// The whole tank in sight, or its middle where the camera is nearer. The second axis points upwards.
    fn new(simulation: &dyn Simulation, place: &CameraPlace) -> Self {
        let (extent, margin) = (simulation.extent(), simulation.margin());
        let (low, high) = ([margin; 3], extent.map(|side| side - margin));
        let center: Vec3 = std::array::from_fn(|axis| 0.5 * extent[axis]);
        let size = 0.5 * dot(extent, extent).sqrt();
        let (azimuth, elevation) = (place.azimuth.to_radians(), place.elevation.to_radians());
        let level = elevation.cos();
        let toward = [azimuth.sin() * level, elevation.sin(), azimuth.cos() * level];
        let eye = plus(center, toward, 3.2 * size);
        let ahead = toward.map(|component| -component);
        // Right is level, also for who looks straight down.
        let right = [azimuth.cos(), 0.0, -azimuth.sin()];
        let up = cross(right, ahead);
        // Twice the size of the picture, for smooth edges.
        let (columns, rows) = (2 * SIDE, 2 * SIDE * 7 / 8);
        let mut view = Self { columns, rows, eye, right, up, ahead, focus: 1.0, middle: [0.0; 2], low, high };
        // The focus and the middle with which the tank just fits.
        let corners = view.corners().map(|corner| {
            let (x, y, depth) = view.turned(corner);
            [x / depth, y / depth]
        });
        let end = |axis: usize, pick: fn(f64, f64) -> f64| {
            corners.iter().map(|corner| corner[axis]).reduce(pick).unwrap_or(0.0)
        };
        let (low, high) = ([end(0, f64::min), end(1, f64::min)], [end(0, f64::max), end(1, f64::max)]);
        view.focus = (0.94 * columns as f64 / (high[0] - low[0])).min(0.94 * rows as f64 / (high[1] - low[1]));
        view.focus *= place.zoom;
        view.middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        view
    }

    /// Right of, above and ahead of the eye.
    fn turned(&self, x: Vec3) -> (f64, f64, f64) {
        let arm = minus(x, self.eye);
        (dot(arm, self.right), dot(arm, self.up), dot(arm, self.ahead))
    }

    /// Column, row and depth.
    pub(super) fn project(&self, x: Vec3) -> (f64, f64, f64) {
        let (right, up, depth) = self.turned(x);
        let (x, y) = (right / depth - self.middle[0], up / depth - self.middle[1]);
        (0.5 * self.columns as f64 + x * self.focus, 0.5 * self.rows as f64 - y * self.focus, depth)
    }

    /// A radius at a place, or what is seen as a dot there, if that is more.
    fn visible(&self, x: Vec3, radius: f64) -> f64 {
        const LEAST: f64 = 1.3;
        radius.max(LEAST * self.turned(x).2 / self.focus)
    }

    /// The direction in which a pixel looks, one long along the view.
    pub(super) fn ray(&self, column: f64, row: f64) -> Vec3 {
        let (x, y) = ((column - 0.5 * self.columns as f64) / self.focus, (0.5 * self.rows as f64 - row) / self.focus);
        plus(plus(self.ahead, self.right, x + self.middle[0]), self.up, y + self.middle[1])
    }

    fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|n| {
            std::array::from_fn(|axis| if n >> axis & 1 == 0 { self.low[axis] } else { self.high[axis] })
        })
    }

    /// The edges of the tank that lie behind the fluid: those which do not meet the corner next to the eye.
    fn edges(&self) -> Vec<(Vec3, Vec3)> {
        let corners = self.corners();
        let near = (0..8).min_by(|&a, &b| self.turned(corners[a]).2.total_cmp(&self.turned(corners[b]).2)).unwrap_or(0);
        let edges = (0..8usize).flat_map(|a| (0..3).map(move |axis| (a, a | 1 << axis))).filter(|(a, b)| a != b);
        edges.filter(|&(a, b)| a != near && b != near).map(|(a, b)| (corners[a], corners[b])).collect()
    }
}

/// The nearest fluid in a pixel.
#[derive(Clone, Copy)]
struct Sample {
    /// Infinite where there is none.
    depth: f32,
    colour: Colour,
}

/// The nearest fluid in each pixel.
struct Surface(Vec<Sample>);

impl Surface {
    fn new(view: &View) -> Self {
        Self(vec![Sample { depth: f32::INFINITY, colour: Colour::default() }; view.columns * view.rows])
    }

    fn splat(&mut self, view: &View, x: Vec3, radius: f64, colour: Colour) {
        let (column, row, depth) = view.project(x);
        let size = radius * view.focus / depth;
        let clip = |middle: f64, end: usize| {
            ((middle - size).ceil().max(0.0) as usize)..((middle + size).floor() + 1.0).clamp(0.0, end as f64) as usize
        };
        for r in clip(row, view.rows) {
            for c in clip(column, view.columns) {
                let square = ((c as f64 - column).powi(2) + (r as f64 - row).powi(2)) / (size * size);
                if square < 1.0 {
                    let here = (depth - radius * (1.0 - square).sqrt()) as f32;
                    let pixel = r * view.columns + c;
                    if here < self.0[pixel].depth {
                        self.0[pixel] = Sample { depth: here, colour };
                    }
                }
            }
        }
    }

    /// A rod, as balls that lie less than half a pixel apart.
    fn rod(&mut self, view: &View, ends: &[Dot<Vec3>; 2], radius: f64) {
        let [from, to] = ends.map(|end| end.at);
        let (a, b) = (view.project(from), view.project(to));
        if a.2 <= 0.0 || b.2 <= 0.0 {
            return;
        }
        let steps = (2.0 * (a.0 - b.0).hypot(a.1 - b.1)).ceil().clamp(1.0, (4 * view.columns) as f64) as usize;
        for n in 0..=steps {
            let x = plus(from, minus(to, from), n as f64 / steps as f64);
            self.splat(view, x, view.visible(x, radius), wires::between(ends));
        }
    }

    /// Smooths depths and colours along rows, then columns, twice, but not over edges.
    fn smooth(&mut self, view: &View, radius: f64) {
        let (_, _, middle) = view.project(view.low.map(|low| low + 0.5));
        let reach = ((SMOOTH * radius * view.focus / middle).ceil() as usize).clamp(1, 24);
        let edge = (EDGE * radius) as f32;
        for _ in 0..2 {
            self.pass(reach, edge, 1, view.columns);
            self.pass(reach, edge, view.columns, view.rows);
        }
    }

    /// One pass along lines of `count` pixels that lie `stride` apart.
    fn pass(&mut self, reach: usize, edge: f32, stride: usize, count: usize) {
        let weights: Vec<f32> = (0..=reach).map(|n| (-2.0 * (n as f32 / reach as f32).powi(2)).exp()).collect();
        let before = self.0.clone();
        for_pieces(&mut self.0, |first, piece| {
            for (pixel, sample) in piece.iter_mut().enumerate().map(|(n, sample)| (first + n, sample)) {
                if sample.depth.is_infinite() {
                    continue;
                }
                let (here, place) = (sample.depth, pixel / stride % count);
                let (mut total, mut depths, mut colours) = (0.0, 0.0, Colour::default());
                for n in place.saturating_sub(reach)..=(place + reach).min(count - 1) {
                    let other = before[pixel + n * stride - place * stride];
                    if (other.depth - here).abs() < edge {
                        let weight = weights[n.abs_diff(place)];
                        total += weight;
                        depths += weight * (other.depth - here);
                        colours = colours + other.colour * weight;
                    }
                }
                *sample = Sample { depth: here + depths / total, colour: colours * (1.0 / total) };
            }
        });
    }

    /// The surface's normal in a pixel, by the smaller of the differences to both sides.
    fn normal(&self, view: &View, column: usize, row: usize) -> Vec3 {
        let at = |c: usize, r: usize| {
            let ray = view.ray(c as f64, r as f64);
            plus(view.eye, ray, f64::from(self.0[r * view.columns + c].depth))
        };
        let here = at(column, row);
        let smaller = |a: Vec3, b: Vec3| if dot(a, a) <= dot(b, b) || !dot(b, b).is_finite() { a } else { b };
        let (c, r) = (column.clamp(1, view.columns - 2), row.clamp(1, view.rows - 2));
        let across = smaller(minus(at(c + 1, row), here), minus(here, at(c - 1, row)));
        let down = smaller(minus(at(column, r + 1), here), minus(here, at(column, r - 1)));
        let normal = unit(cross(down, across));
        if normal.iter().all(|component| component.is_finite()) {
            normal
        } else {
            view.ahead.map(|component| -component)
        }
    }
}

/// How much of the light from above each place of the floor misses.
struct Shadow {
    cells: usize,
    low: Vec3,
    size: Vec3,
    cover: Vec<f32>,
}

impl Shadow {
    fn new(simulation: &dyn Simulation, positions: &[Vec3], colliders: &[Placed<'_>]) -> Self {
        const CELLS: usize = 96;
        let (margin, extent) = (simulation.margin(), simulation.extent());
        let size = extent.map(|side| side - 2.0 * margin);
        let mut shadow = Self { cells: CELLS, low: [margin; 3], size, cover: vec![0.0; CELLS * CELLS] };
        let share = (simulation.spacing().powi(2) * (CELLS * CELLS) as f64 / (size[0] * size[2])) as f32;
        for x in positions {
            let (i, k) = shadow.cell(*x);
            if (0.0..CELLS as f64).contains(&i) && (0.0..CELLS as f64).contains(&k) {
                shadow.cover[i as usize * CELLS + k as usize] += share;
            }
        }
        // From so high above that no collider reaches it.
        shadow.add_colliders(colliders, 4.0 * extent[1]);
        shadow.blur();
        shadow
    }

    fn cell(&self, x: Vec3) -> (f64, f64) {
        let along = |axis: usize| (x[axis] - self.low[axis]) / self.size[axis] * self.cells as f64;
        (along(0), along(2))
    }

    /// Colliders that hang over the floor; of meshes, points on their triangles that lie less than a cell apart.
    fn add_colliders(&mut self, colliders: &[Placed<'_>], height: f64) {
        /// As much as of fluid some four particles deep.
        const COVER: f32 = 2.0;
        for n in 0..if colliders.is_empty() { 0 } else { self.cover.len() } {
            let along =
                |axis: usize, place: usize| self.low[axis] + (place as f64 + 0.5) * self.size[axis] / self.cells as f64;
            let above = [along(0, n / self.cells), height, along(2, n % self.cells)];
            // A half-space is no shape that hangs over the floor: it stands on it.
            let hangs = |shape: &&Placed<'_>| !matches!(shape, Placed::HalfSpace { .. });
            if colliders.iter().filter(hangs).any(|shape| shape.hit(above, [0.0, -1.0, 0.0]).is_some()) {
                self.cover[n] = self.cover[n].max(COVER);
            }
        }
        for [a, b, c] in colliders.iter().flat_map(solid::triangles) {
            let reach = [0, 2].map(|axis| {
                let places = [a, b, c].map(|corner| corner[axis] / self.size[axis] * self.cells as f64);
                places.iter().copied().fold(f64::MIN, f64::max) - places.iter().copied().fold(f64::MAX, f64::min)
            });
            let pieces = (2.0 * reach[0].max(reach[1])).ceil().clamp(1.0, 2.0 * self.cells as f64) as usize;
            for u in 0..=pieces {
                for v in 0..=pieces - u {
                    let share = |part: usize| part as f64 / pieces as f64;
                    let (i, k) = self.cell(plus(plus(a, minus(b, a), share(u)), minus(c, a), share(v)));
                    if (0.0..self.cells as f64).contains(&i) && (0.0..self.cells as f64).contains(&k) {
                        let cell = i as usize * self.cells + k as usize;
                        self.cover[cell] = self.cover[cell].max(COVER);
                    }
                }
            }
        }
    }

    fn blur(&mut self) {
        for stride in [1, self.cells, 1, self.cells] {
            let before = self.cover.clone();
            for (n, cover) in self.cover.iter_mut().enumerate() {
                let place = n / stride % self.cells;
                let range = place.saturating_sub(2)..=(place + 2).min(self.cells - 1);
                *cover = range.clone().map(|other| before[n + other * stride - place * stride]).sum::<f32>()
                    / range.count() as f32;
            }
        }
    }

    /// The light that arrives at a place of the floor.
    fn light(&self, x: Vec3) -> f32 {
        let (i, k) = self.cell(x);
        let at = |i: f64, k: f64| {
            let (i, k) =
                (i.clamp(0.0, (self.cells - 1) as f64) as usize, k.clamp(0.0, (self.cells - 1) as f64) as usize);
            self.cover[i * self.cells + k]
        };
        let (i, k) = (i - 0.5, k - 0.5);
        let (fi, fk) = ((i - i.floor()) as f32, (k - k.floor()) as f32);
        let row = |i: f64| at(i, k.floor()) * (1.0 - fk) + at(i, k.floor() + 1.0) * fk;
        let cover = row(i.floor()) * (1.0 - fi) + row(i.floor() + 1.0) * fi;
        0.25 + 0.75 * (-0.9 * cover).exp()
    }
}

/// The colours of what is around the fluid.
struct Backdrop {
    low: Colour,
    high: Colour,
    floor: Colour,
    /// What smooth surfaces mirror at their rims.
    sky: Colour,
}

/// Made once, since powers are too slow for every pixel.
static BACKDROP: LazyLock<Backdrop> = LazyLock::new(|| Backdrop {
    low: Colour::hex(NIGHT),
    high: Colour::hex(0x1a2338),
    floor: Colour::hex(0x46536e),
    sky: Colour::hex(0x9fc4ff),
});

/// The colour of a pixel: the nearer of fluid and colliders, else the floor, else the background.
fn shade(view: &View, surface: &Surface, solid: &Solid, shadow: &Shadow, column: usize, row: usize) -> Colour {
    let ray = view.ray(column as f64, row as f64);
    let pixel = row * view.columns + column;
    let Sample { depth, colour } = surface.0[pixel];
    if solid.depth[pixel] < depth {
        return solid.shade(pixel, ray);
    }
    if depth.is_finite() {
        let sun = unit(SUN);
        let normal = surface.normal(view, column, row);
        let to_eye = unit(ray).map(|component| -component);
        let half = unit(plus(sun, to_eye, 1.0));
        let facing = dot(normal, to_eye).clamp(0.0, 1.0);
        let diffuse = (0.5 + 0.5 * dot(normal, sun)).clamp(0.0, 1.0).powi(2) as f32;
        let glint = dot(normal, half).max(0.0).powi(60) as f32;
        let rim = (1.0 - facing).powi(4) as f32;
        let sky = BACKDROP.sky;
        return colour * (0.18 + 0.95 * diffuse) + Colour([1.0; 3]) * (0.45 * glint) + sky * (0.25 * rim);
    }
    let background = BACKDROP.low.mix(BACKDROP.high, 1.0 - row as f32 / view.rows as f32);
    let distance = (view.low[1] - view.eye[1]) / ray[1];
    let floor = plus(view.eye, ray, distance);
    let on_floor =
        distance > 0.0 && [0, 2].into_iter().all(|axis| (view.low[axis]..=view.high[axis]).contains(&floor[axis]));
    if on_floor { BACKDROP.floor * shadow.light(floor) } else { background }
}

/// A line of the tank, two of the large pixels wide, where nothing hides it.
fn draw_line(canvas: &mut Canvas, view: &View, surface: &Surface, solid: &Solid, from: Vec3, to: Vec3) {
    let colour = Colour::hex(0x5f7196);
    let (a, b) = (view.project(from), view.project(to));
    let steps = (2.0 * (a.0 - b.0).hypot(a.1 - b.1)).ceil().max(1.0) as usize;
    for n in 0..=steps {
        let (column, row, depth) = view.project(plus(from, minus(to, from), n as f64 / steps as f64));
        for (c, r) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let (column, row) = (column as i64 + c, row as i64 + r);
            if (0..view.columns as i64).contains(&column) && (0..view.rows as i64).contains(&row) {
                let pixel = row as usize * view.columns + column as usize;
                if f64::from(surface.0[pixel].depth.min(solid.depth[pixel])) > depth {
                    canvas.pixels[pixel] = colour;
                }
            }
        }
    }
}
