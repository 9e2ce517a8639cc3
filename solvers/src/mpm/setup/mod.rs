//! What a scene of this solver has beside what all scenes have.

mod material;
mod memory;
mod sizes;
mod transfer;

use std::sync::Arc;

pub use material::Material;
pub use transfer::{Forces, Scheme, Spline, Transfer};

use super::materials::Model;
use crate::scene::{
    Basics, Body, Collider, Fill, Keys, MOST_PARTICLES, Particles, Reorder, Scene, Setup, Shape, Substance, WALLS,
    Walls, available_memory, fill, place, read_walls,
};
use crate::{Read, SceneError};

/// Axes of more nodes are refused.
const LONGEST: i64 = 1 << 15;

/// What a scene of this solver has beside what all scenes have. Lengths are metres, times seconds; vectors have a third
/// component of zero in 2D.
#[derive(Clone, Debug)]
pub struct MpmSetup {
    /// 2 or 3, as the scene has.
    pub dimensions: usize,
    /// Nodes along each axis; one along an axis that the scene does not have.
    pub grid: [usize; 3],
    /// Whether the domain may be larger than a dense grid can be, for layouts whose grid holds the nodes near particles alone.
    pub sparse: bool,
    /// Metres along the first axis; cells are cubes.
    pub length: f64,
    /// Distance between particles, in cells; a particle's volume is this to the power of the dimensions.
    pub spacing: f64,
    /// Nodes, from each border on, through which nothing flows outwards.
    pub wall: usize,
    /// What bodies are of; at least one.
    pub materials: Vec<Material>,
    /// How velocity moves between particles and grid.
    pub transfer: Transfer,
    /// What the sides of the domain do.
    pub walls: Walls,
    /// What stands in the domain.
    pub colliders: Vec<Collider>,
    /// When the particles are sorted by cell.
    pub reorder: Reorder,
    /// What it holds.
    pub bodies: Vec<Body>,
}

/// The keys of a scene that [`read`] reads.
pub(super) const KEYS: &[&str] =
    &["grid", "sparse", "length", "spacing", "wall", "reorder", "material", "transfer", "walls", "body", "collider"];

/// Reads this solver's part of a scene.
pub(super) fn read(keys: &Keys<'_>, basics: &Basics<'_>) -> Read {
    let &Basics { dimensions, seed, folder, .. } = basics;
    let transfer = keys.table("transfer", transfer::KEYS)?;
    let transfer = transfer.map(|keys| Transfer::read(&keys, dimensions)).transpose()?.unwrap_or_default();
    // All nodes of a particle that has come to rest belong to the wall.
    let least = transfer.spline.width().max(3);
    let wall = keys.whole("wall", least as i64, 64)?.map_or(least, |wall| wall as usize);
    let grid = keys.extents("grid", dimensions, 2 * wall as i64 + 4, LONGEST)?;
    let sparse = keys.flag("sparse")?.unwrap_or_default();
    if !sparse {
        sizes::check_nodes(grid, dimensions, transfer.scheme).map_err(|fault| keys.fault("grid", fault))?;
    }
    let spacing = if keys.has("spacing") { keys.positive("spacing", "0.5")? } else { 0.5 };
    if !(0.05..=1.0).contains(&spacing) {
        return Err(keys.fault("spacing", "is not from 0.05 to 1 cell; fewer than one particle a cell tears the fluid"));
    }
    let materials = material::read(keys)?;
    let names: Vec<&str> = materials.iter().map(|material| material.name.as_str()).collect();
    let walls = keys.table("walls", WALLS)?;
    let colliders = keys.all_tables("collider")?;
    let bodies = keys.all_tables("body")?;
    let body = |(n, keys): (usize, &Keys<'_>)| Body::read(keys, dimensions, &names, seed + n as u64, folder);
    let setup = MpmSetup {
        dimensions,
        grid,
        sparse,
        length: keys.positive("length", "1.0")?,
        spacing,
        wall,
        transfer,
        walls: walls.map(|keys| read_walls(&keys, dimensions)).transpose()?.unwrap_or_default(),
        colliders: colliders.iter().map(|keys| Collider::read(keys, dimensions, folder)).collect::<Result<_, _>>()?,
        reorder: keys.reorder("reorder")?.unwrap_or_default(),
        bodies: bodies.iter().enumerate().map(body).collect::<Result<_, _>>()?,
        materials,
    };
    if setup.bodies.is_empty() {
        return Err(keys.fault("body", "is missing; write a table `[[body]]` for each body"));
    }
    Ok(Arc::new(setup))
}

impl MpmSetup {
    /// The side of a cell in metres.
    pub fn dx(&self) -> f64 {
        self.length / self.grid[0] as f64
    }

    /// The volume of a particle in m^3 (in 2D, m^2).
    pub fn particle_volume(&self) -> f64 {
        (self.spacing * self.dx()).powi(self.dimensions as i32)
    }

    /// Between which coordinates, in cells, all nodes of a particle are in the grid: a particle's first node is
    /// `floor(x - offset)`, where the offset is half of what the spline is wider than a cell.
    fn reach(&self) -> (f64, [f64; 3]) {
        let width = self.transfer.spline.width();
        let offset = 0.5 * (width - 2) as f64;
        (offset, self.grid.map(|nodes| nodes as f64 + 1.0 - width as f64 + offset))
    }

    /// Whether the nodes around a particle are all in the grid, in the arithmetic of the kernels.
    fn contains(&self, x: [f64; 3]) -> bool {
        let inv_dx = (1.0 / self.dx()) as f32;
        let width = self.transfer.spline.width();
        let offset = 0.5 * (width - 2) as f32;
        (0..self.dimensions).all(|axis| {
            let base = x[axis] as f32 * inv_dx - offset;
            base >= 0.0 && base < (self.grid[axis] + 1 - width) as f32
        })
    }

    /// Refuses positions that are not all in the domain; `first` is the number of the first of them.
    fn check_inside(&self, positions: &[[f64; 3]], first: usize) -> Result<(), String> {
        let Some(p) = positions.iter().position(|&x| !self.contains(x)) else { return Ok(()) };
        let (dx, (first_node, last_node)) = (self.dx(), self.reach());
        let upper: Vec<_> = last_node[..self.dimensions].iter().map(|&n| format!("{:.4}", n * dx)).collect();
        Err(format!(
            "puts particle {} at {} outside the domain, which reaches from {:.4} on each axis to ({})",
            first + p,
            place(positions[p], self.dimensions),
            first_node * dx,
            upper.join(", ")
        ))
    }
}

impl Setup for MpmSetup {
    fn extent(&self) -> [f64; 3] {
        std::array::from_fn(|axis| if axis < self.dimensions { self.grid[axis] as f64 * self.dx() } else { 0.0 })
    }

    fn particles(&self, scene: &Scene) -> Result<Particles, SceneError> {
        let spacing = self.spacing * self.dx();
        if let Some(available) = available_memory() {
            let bodies = self.bodies.iter();
            let estimate: f64 = bodies.map(|body| body.shape.estimate(spacing, self.dimensions)).sum();
            self.check_memory(scene, (estimate as usize).min(MOST_PARTICLES), available)?;
        }
        let check = |positions: &[_], first| self.check_inside(positions, first);
        fill(&scene.file, &self.bodies, spacing, self.dimensions, check)
    }

    fn substances(&self) -> Vec<Substance<'_>> {
        let materials = self.materials.iter();
        let substances = materials.map(|Material { name, density, model }| Substance {
            name,
            density: *density,
            fluid: matches!(model, Model::Fluid { .. }),
        });
        substances.collect()
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

    fn with_grid(&self, scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
        sizes::with_grid(self.clone(), scene, nodes)
    }

    fn with_room(&self, scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
        sizes::with_room(self.clone(), scene, nodes)
    }

    fn with_particles(&self, scene: Scene, count: usize) -> Result<Scene, SceneError> {
        sizes::with_particles(self.clone(), scene, count)
    }
}
