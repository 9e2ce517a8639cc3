//! What a scene of this solver has beside what all scenes have.

mod material;
mod memory;
mod walls;

use std::sync::Arc;

pub use material::{State, Water};

use super::{Boundary, Density};
use crate::scene::{
    Basics, Body, Collider, ColliderShape, Fill, Keys, MOST_PARTICLES, Particles, Reorder, SIDES, Scene, Setup, Shape,
    Substance, available_memory, fill, place,
};
use crate::sph::Spline;
use crate::{Read, SceneError};

/// What a scene of this solver has beside what all scenes have. Lengths are metres, times seconds; vectors have a third
/// component of zero in 2D.
#[derive(Clone, Debug)]
pub struct WcsphSetup {
    /// 2 or 3.
    pub dimensions: usize,
    /// The domain's extent along each axis, zero along one that the scene does not have.
    pub extent: [f64; 3],
    /// Metres between particles at rest.
    pub spacing: f64,
    /// The smoothing length, in spacings.
    pub smoothing: f64,
    /// The form of the smoothing kernel.
    pub kernel: Spline,
    /// How density follows the particles.
    pub density: Density,
    /// Whether steps are as long as the fluid bears, and `dt` at most, not all as long as `dt`.
    pub adaptive: bool,
    /// Seconds over which gravity rises from zero; zero, if it is there at once.
    pub ramp: f64,
    /// What flows.
    pub fluid: Water,
    /// What keeps the fluid off walls.
    pub boundary: Boundary,
    /// How much more viscous the fluid is beside walls than by itself.
    pub friction: f64,
    /// Layers of particles that walls are made of.
    pub layers: usize,
    /// By axis, whether the side below and that above are walls.
    pub closed: [[bool; 2]; 3],
    /// What stands in the domain: boxes.
    pub colliders: Vec<Collider>,
    /// How far stored lists of neighbours reach beyond the support, in smoothing lengths.
    pub skin: f64,
    /// The most neighbours that a stored list holds.
    pub most: usize,
    /// When particles are sorted by cell, where the way of finding neighbours leaves it open.
    pub reorder: Reorder,
    /// What it holds.
    pub bodies: Vec<Body>,
}

/// The keys of a scene that [`read`] reads.
pub(super) const KEYS: &[&str] = &[
    "extent",
    "spacing",
    "smoothing",
    "kernel",
    "density",
    "adaptive",
    "ramp",
    "fluid",
    "sides",
    "neighbours",
    "reorder",
    "body",
    "collider",
];

const SIDE_KEYS: &[&str] = &["boundary", "layers", "friction", "left", "right", "floor", "ceiling", "back", "front"];
const NEIGHBOUR_KEYS: &[&str] = &["skin", "most"];

/// Reads this solver's part of a scene.
pub(super) fn read(keys: &Keys<'_>, basics: &Basics<'_>) -> Read {
    let &Basics { dimensions, seed, folder, .. } = basics;
    let extent = keys.required_vector("extent", dimensions, "[2.0, 1.0]")?;
    let spacing = keys.positive("spacing", "0.02")?;
    if extent[..dimensions].iter().any(|&side| side < 2.0 * spacing || side > 1e5 * spacing) {
        return Err(keys.fault("extent", "is not from 2 to 100000 spacings along every axis"));
    }
    let kernel =
        keys.choice("kernel", "smoothing kernel", &[("cubic", Spline::Cubic), ("gaussian", Spline::Gaussian)])?;
    let densities = [("continuity", Density::Continuity), ("summation", Density::Summation)];
    let (kernel, density) = (kernel.unwrap_or_default(), keys.choice("density", "way to find density", &densities)?);
    let fluid = keys
        .table("fluid", material::KEYS)?
        .ok_or_else(|| keys.fault("fluid", "is missing; write a table `[fluid]`"))?;
    let smoothing = keys.between("smoothing", 0.8, 3.0)?.unwrap_or(1.2);
    let sides = keys.table("sides", SIDE_KEYS)?;
    let neighbours = keys.table("neighbours", NEIGHBOUR_KEYS)?;
    let colliders = keys.all_tables("collider")?;
    let bodies = keys.all_tables("body")?;
    let body = |(n, keys): (usize, &Keys<'_>)| Body::read(keys, dimensions, &["fluid"], seed + n as u64, folder);
    let mut setup = WcsphSetup {
        dimensions,
        extent,
        spacing,
        smoothing,
        kernel,
        density: density.unwrap_or_default(),
        adaptive: keys.flag("adaptive")?.unwrap_or(true),
        ramp: keys.between("ramp", 0.0, 1e6)?.unwrap_or(0.0),
        fluid: Water::read(&fluid)?,
        boundary: Boundary::Volumes,
        friction: 0.0,
        layers: 0,
        closed: std::array::from_fn(|axis| [axis < dimensions; 2]),
        colliders: colliders.iter().map(|keys| Collider::read(keys, dimensions, folder)).collect::<Result<_, _>>()?,
        skin: 0.3,
        most: 0,
        reorder: keys.reorder("reorder")?.unwrap_or(Reorder::Decayed),
        bodies: bodies.iter().enumerate().map(body).collect::<Result<_, _>>()?,
    };
    if let Some(keys) = &sides {
        setup.read_sides(keys)?;
    }
    // Layers as deep as the kernel reaches; a wall that repels is a line or a plane.
    let all = (setup.kernel.reach() * smoothing).ceil() as i64;
    let layers = sides.as_ref().map(|keys| keys.whole("layers", 1, 16)).transpose()?.flatten();
    setup.layers = layers.unwrap_or(if setup.boundary == Boundary::Repulsion { 1 } else { all }) as usize;
    if let Some(keys) = &neighbours {
        setup.skin = keys.between("skin", 0.0, 2.0)?.unwrap_or(setup.skin);
        setup.most = keys.whole("most", 8, 4096)?.unwrap_or(0) as usize;
    }
    if setup.most == 0 {
        setup.most = setup.usual_most();
    }
    if let Some(n) = setup.colliders.iter().position(|collider| !matches!(collider.shape, ColliderShape::Box { .. })) {
        let message = "has a shape that this solver makes no walls of; it takes boxes";
        return Err(colliders[n].fault("shape", message));
    }
    if setup.bodies.is_empty() {
        return Err(keys.fault("body", "is missing; write a table `[[body]]` for each body"));
    }
    Ok(Arc::new(setup))
}

impl WcsphSetup {
    fn read_sides(&mut self, keys: &Keys<'_>) -> Result<(), SceneError> {
        let boundaries = [("volumes", Boundary::Volumes), ("repulsion", Boundary::Repulsion)];
        self.boundary = keys.choice("boundary", "kind of wall", &boundaries)?.unwrap_or_default();
        self.friction = keys.between("friction", 0.0, 1e3)?.unwrap_or(0.0);
        for (axis, names) in SIDES.iter().enumerate() {
            for (side, name) in names.iter().enumerate() {
                match keys.flag(name)? {
                    Some(_) if axis >= self.dimensions => {
                        return Err(keys.fault(name, "is a side of `dimensions = 3`; in the plane there is none"));
                    }
                    Some(closed) => self.closed[axis][side] = closed,
                    None => {}
                }
            }
        }
        Ok(())
    }

    /// The smoothing length in m.
    pub fn smoothing_length(&self) -> f64 {
        self.smoothing * self.spacing
    }

    /// The volume of a particle at rest in m^3 (in 2D, m^2).
    pub fn particle_volume(&self) -> f64 {
        self.spacing.powi(self.dimensions as i32)
    }

    /// Thrice as many neighbours as at rest, those in the skin included.
    fn usual_most(&self) -> usize {
        let reach = (self.kernel.reach() + self.skin) * self.smoothing;
        let ball = if self.dimensions == 2 { reach * reach } else { 4.0 / 3.0 * reach.powi(3) };
        (3.0 * std::f64::consts::PI * ball).ceil() as usize
    }

    fn check_inside(&self, positions: &[[f64; 3]], first: usize) -> Result<(), String> {
        let inside = |x: &[f64; 3]| (0..self.dimensions).all(|axis| (0.0..=self.extent[axis]).contains(&x[axis]));
        if let Some(p) = positions.iter().position(|x| !inside(x)) {
            let (at, to) = (place(positions[p], self.dimensions), place(self.extent, self.dimensions));
            return Err(format!(
                "puts particle {} at {at} outside the domain, which reaches from 0 to {to}",
                first + p
            ));
        }
        for (n, collider) in self.colliders.iter().enumerate() {
            let ColliderShape::Box { from, to } = &collider.shape else { continue };
            let inside = |x: &[f64; 3]| (0..self.dimensions).all(|axis| (from[axis]..=to[axis]).contains(&x[axis]));
            if let Some(p) = positions.iter().position(inside) {
                let at = place(positions[p], self.dimensions);
                return Err(format!("puts particle {} at {at} into collider[{n}]", first + p));
            }
        }
        Ok(())
    }
}

impl Setup for WcsphSetup {
    fn extent(&self) -> [f64; 3] {
        self.extent
    }

    fn particles(&self, scene: &Scene) -> Result<Particles, SceneError> {
        if let Some(available) = available_memory() {
            let estimate: f64 = self.bodies.iter().map(|body| body.shape.estimate(self.spacing, self.dimensions)).sum();
            self.check_memory(scene, (estimate as usize).min(MOST_PARTICLES), available)?;
        }
        let check = |positions: &[_], first| self.check_inside(positions, first);
        fill(&scene.file, &self.bodies, self.spacing, self.dimensions, check)
    }

    fn substances(&self) -> Vec<Substance<'_>> {
        vec![Substance { name: "fluid", density: self.fluid.density, fluid: true }]
    }

    fn colliders(&self) -> &[Collider] {
        &self.colliders
    }

    fn seeds(&self) -> Vec<u64> {
        let random = self.bodies.iter().filter_map(|body| match &body.shape {
            Shape::Box { fill: Fill::Random { seed, .. }, .. } => Some(*seed),
            Shape::Box { fill: Fill::Lattice { jitter, seed }, .. } if *jitter > 0.0 => Some(*seed),
            _ => None,
        });
        random.collect()
    }

    fn sorts(&self) -> bool {
        true
    }

    fn reorder(&self) -> Reorder {
        self.reorder
    }

    fn with_reorder(&self, scene: Scene, reorder: Reorder) -> Result<Scene, SceneError> {
        Ok(Scene { setup: Arc::new(Self { reorder, ..self.clone() }), ..scene })
    }

    /// About so many, at another spacing; steps are longer or shorter with it.
    fn with_particles(&self, mut scene: Scene, count: usize) -> Result<Scene, SceneError> {
        let volume: f64 = self.bodies.iter().map(|body| body.shape.volume(self.dimensions)).sum();
        let key = format!("particles = {count}");
        if count == 0 || count > MOST_PARTICLES {
            return Err(scene.fault(key, format!("is not from 1 to {MOST_PARTICLES}")));
        }
        if volume == 0.0 {
            return Err(scene.fault(key, "cannot be, since the positions of a body are given one by one"));
        }
        let spacing = (volume / count as f64).powf(1.0 / self.dimensions as f64);
        if self.extent[..self.dimensions].iter().any(|&side| side < 2.0 * spacing) {
            return Err(scene.fault(key, "are too few: the domain would be narrower than two spacings"));
        }
        let dt = scene.dt * spacing / self.spacing;
        scene.rewrite(|table| {
            table.insert("spacing".into(), spacing.into());
            table.insert("dt".into(), dt.into());
        });
        Ok(Scene { dt, setup: Arc::new(Self { spacing, ..self.clone() }), ..scene })
    }
}
