//! Scenes: what is simulated. A scene is a TOML text; `SCENES.md` is the schema.

mod body;
mod camera;
mod contact;
mod error;
mod folder;
mod keys;
mod material;
mod transfer;

use std::path::Path;

pub use body::{Body, Fill, Shape};
pub use camera::CameraPlace;
pub use contact::{Collider, ColliderShape, Contact, SIDES, Wall, Walls};
pub use error::SceneError;
pub use folder::Folder;
use keys::Keys;
pub use material::Material;
pub use transfer::{Forces, Scheme, Spline, Transfer};

use crate::mpm::materials::Model;

/// The version of the schema.
const VERSION: i64 = 1;

/// More particles than this are refused, before memory is asked for.
pub(crate) const MOST_PARTICLES: usize = 1 << 25;

/// A grid of more nodes is refused too.
const MOST_NODES: usize = 1 << 28;

/// A scene, read and checked. Lengths are metres, times seconds; vectors have a third component of zero in 2D.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The name or file by which messages tell it.
    pub file: String,
    /// One line about it.
    pub about: String,
    /// The solver that it is for.
    pub solver: String,
    /// 2 or 3.
    pub dimensions: usize,
    /// Nodes along each axis; one along an axis that the scene does not have.
    pub grid: [usize; 3],
    /// Metres along the first axis; cells are cubes.
    pub length: f64,
    /// Seconds a step.
    pub dt: f64,
    /// Metres a second squared.
    pub gravity: [f64; 3],
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
    /// From where it is looked at.
    pub camera: CameraPlace,
    /// Of the generators of random numbers of all bodies that have none of their own.
    pub seed: u64,
    /// Steps after which the particles are sorted by cell; zero: never.
    pub reorder: u64,
    /// Steps that a run takes if none are asked for.
    pub steps: u64,
    /// What it holds.
    pub bodies: Vec<Body>,
}

/// The particles with which a scene starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Particles {
    /// Positions in metres.
    pub x: Vec<[f64; 3]>,
    /// Velocities in metres a second.
    pub v: Vec<[f64; 3]>,
    /// Gradients of the velocity, `c[row][column]`, in 1/s.
    pub c: Vec<[[f64; 3]; 3]>,
    /// Of which of the scene's materials.
    pub material: Vec<u32>,
}

const KEYS: &[&str] = &[
    "version",
    "about",
    "solver",
    "dimensions",
    "grid",
    "length",
    "dt",
    "gravity",
    "spacing",
    "wall",
    "reorder",
    "steps",
    "material",
    "body",
];

impl Scene {
    /// Reads a scene from a file.
    ///
    /// # Errors
    /// One line that names file, key and value.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let file = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|error| SceneError::new(&*file, format!("cannot be read: {error}")))?;
        let text = String::from_utf8(bytes).map_err(|_| SceneError::new(&*file, "is not a text in UTF-8"))?;
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        Self::parse(&text, &file, Folder::Path(folder))
    }

    /// Reads a scene from its text. `file` is its name in messages; files that it names are looked for in `folder`.
    ///
    /// # Errors
    /// One line that names file, key and value.
    pub fn parse(text: &str, file: &str, folder: Folder) -> Result<Self, SceneError> {
        let table: toml::Table = text.parse().map_err(|error: toml::de::Error| {
            let line = error.span().map_or(1, |span| text[..span.start.min(text.len())].lines().count().max(1));
            let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
            SceneError::new(file, format!("line {line} is not TOML: {message}"))
        })?;
        let keys = Keys::new(file, String::new(), &table, KEYS)?;
        if keys.whole("version", i64::MIN, i64::MAX)? != Some(VERSION) {
            return Err(keys.fault("version", format!("must be there and {VERSION}, the version of the schema")));
        }
        let solver = keys.required_text("solver", "\"mpm\"")?.to_string();
        let Some(dimensions) = keys.whole("dimensions", 2, 3)? else {
            return Err(keys.fault("dimensions", "is missing; write `dimensions = 2` or `dimensions = 3`"));
        };
        let dimensions = dimensions as usize;
        let wall = keys.whole("wall", 3, 64)?.unwrap_or(3) as usize;
        let grid = keys.extents("grid", dimensions, 2 * wall as i64 + 4, 1 << 15)?;
        if grid.iter().product::<usize>() > MOST_NODES {
            return Err(keys.fault("grid", "has more than 2^28 nodes"));
        }
        let spacing = if keys.has("spacing") { keys.positive("spacing", "0.5")? } else { 0.5 };
        if !(0.05..=1.0).contains(&spacing) {
            return Err(
                keys.fault("spacing", "is not from 0.05 to 1 cell; fewer than one particle a cell tears the fluid")
            );
        }
        let Some(material) = keys.table("material", &["stiffness", "density"])? else {
            return Err(keys.fault("material", "is missing; write a table `[material]` with `stiffness` and `density`"));
        };
        let scene = Self {
            file: file.to_string(),
            about: keys.text("about")?.unwrap_or_default().to_string(),
            solver,
            dimensions,
            grid,
            length: keys.positive("length", "1.0")?,
            dt: keys.positive("dt", "2e-4")?,
            gravity: keys.vector("gravity", dimensions)?.unwrap_or_default(),
            spacing,
            wall,
            materials: vec![Material {
                name: "fluid".into(),
                density: material.positive("density", "1.0")?,
                model: Model::Fluid { stiffness: material.positive("stiffness", "400.0")? as f32 },
            }],
            transfer: Transfer::default(),
            walls: Walls::default(),
            colliders: Vec::new(),
            camera: CameraPlace::default(),
            seed: 0,
            reorder: keys.whole("reorder", 0, i64::MAX)?.unwrap_or(0) as u64,
            steps: keys.whole("steps", 1, i64::MAX)?.unwrap_or(1000) as u64,
            bodies: keys
                .tables("body", body::KEYS)?
                .iter()
                .map(|keys| Body::read(keys, dimensions, &folder))
                .collect::<Result<_, _>>()?,
        };
        if scene.bodies.is_empty() {
            return Err(keys.fault("body", "is missing; write a table `[[body]]` for each body of fluid"));
        }
        Ok(scene)
    }

    /// The side of a cell in metres.
    pub fn dx(&self) -> f64 {
        self.length / self.grid[0] as f64
    }

    /// Metres along each axis; zero along an axis that the scene does not have.
    pub fn extent(&self) -> [f64; 3] {
        std::array::from_fn(|axis| if axis < self.dimensions { self.grid[axis] as f64 * self.dx() } else { 0.0 })
    }

    /// The volume of a particle in m^3 (in 2D, m^2).
    pub fn particle_volume(&self) -> f64 {
        (self.spacing * self.dx()).powi(self.dimensions as i32)
    }

    /// A fault of this scene's key; `key` may tell the value.
    pub(crate) fn fault(&self, key: impl Into<String>, message: impl Into<String>) -> SceneError {
        SceneError::at(&*self.file, key, message)
    }

    /// The same scene on `nodes` nodes along the first axis, and in proportion along the others. The time step is
    /// changed in proportion to the cell, so that the Courant number stays.
    ///
    /// # Errors
    /// If an axis becomes too short for its walls, or the grid too large.
    pub fn with_grid(mut self, nodes: usize) -> Result<Self, SceneError> {
        let (old, least) = (self.grid[0], 2 * self.wall + 4);
        for extent in &mut self.grid[..self.dimensions] {
            *extent = (*extent as f64 * nodes as f64 / old as f64).round() as usize;
        }
        let [i, j, k] = self.grid;
        if self.grid[..self.dimensions].iter().any(|&extent| !(least..=1 << 15).contains(&extent))
            || i * j * k > MOST_NODES
        {
            let message =
                format!("cannot be; an axis takes from {least} to {} nodes, all together at most 2^28", 1 << 15);
            return Err(self.fault(format!("grid = {nodes}"), message));
        }
        self.dt *= old as f64 / nodes as f64;
        Ok(self)
    }

    /// The same scene with `count` particles: exactly so many where they are drawn at random, about so many where they
    /// lie on a lattice, whose spacing is changed.
    ///
    /// # Errors
    /// If the spacing would leave its bounds, or positions are given one by one.
    pub fn with_particles(mut self, count: usize) -> Result<Self, SceneError> {
        let key = format!("particles = {count}");
        if count == 0 || count > MOST_PARTICLES {
            return Err(self.fault(key, format!("is not from 1 to {MOST_PARTICLES}")));
        }
        let random = |body: &Body| match &body.shape {
            Shape::Box { fill: Fill::Random { particles, .. }, .. } => Some(*particles),
            _ => None,
        };
        let drawn: Vec<usize> = self.bodies.iter().filter_map(random).collect();
        if self.bodies.iter().any(|body| matches!(body.shape, Shape::Points(_))) {
            return Err(self.fault(key, "cannot be, since the scene gives its particles one by one"));
        }
        if drawn.len() == self.bodies.len() {
            let total: usize = drawn.iter().sum();
            let mut left = count;
            for (n, body) in self.bodies.iter_mut().enumerate() {
                if let Shape::Box { fill: Fill::Random { particles, .. }, .. } = &mut body.shape {
                    let share = (*particles as f64 / total as f64 * count as f64).round() as usize;
                    *particles = if n + 1 == drawn.len() { left } else { share.min(left) };
                    left -= *particles;
                }
            }
        } else if drawn.is_empty() {
            let volume: f64 = self.bodies.iter().map(|body| body.shape.volume(self.dimensions)).sum();
            self.spacing = (volume / count as f64).powf(1.0 / self.dimensions as f64) / self.dx();
            if !(0.05..=1.0).contains(&self.spacing) {
                let message = format!(
                    "needs a spacing of {:.3} cells, which is not from 0.05 to 1; change the grid too",
                    self.spacing
                );
                return Err(self.fault(key, message));
            }
        } else {
            return Err(self.fault(key, "cannot be, since the scene has both random and regular bodies"));
        }
        Ok(self)
    }

    /// The particles with which the scene starts, body after body.
    ///
    /// # Errors
    /// If a particle lies outside the domain, or there are none, or too many.
    pub fn particles(&self) -> Result<Particles, SceneError> {
        let mut particles = Particles::default();
        for (n, body) in self.bodies.iter().enumerate() {
            let key = format!("body[{n}]");
            let first = particles.x.len();
            let room = MOST_PARTICLES - first;
            let positions = body
                .shape
                .fill(self.spacing * self.dx(), self.dimensions, room)
                .map_err(|fault| self.fault(&*key, fault))?;
            if positions.is_empty() {
                return Err(self.fault(key, "holds no particle; make it larger, or `spacing` smaller"));
            }
            if let Some(p) = positions.iter().position(|&x| !self.contains(x)) {
                let dx = self.dx();
                let upper: Vec<_> =
                    self.grid[..self.dimensions].iter().map(|&n| format!("{:.4}", (n as f64 - 1.5) * dx)).collect();
                let message = format!(
                    "puts particle {} at {} outside the domain, which reaches from {:.4} on each axis to ({})",
                    first + p,
                    place(positions[p], self.dimensions),
                    0.5 * dx,
                    upper.join(", ")
                );
                return Err(self.fault(key, message));
            }
            body.set_off(positions, &mut particles);
        }
        Ok(particles)
    }

    /// Whether the 3 nodes an axis around a particle are all in the grid, in the arithmetic of the kernels.
    fn contains(&self, x: [f64; 3]) -> bool {
        let inv_dx = (1.0 / self.dx()) as f32;
        (0..self.dimensions).all(|axis| {
            let base = x[axis] as f32 * inv_dx - 0.5;
            base >= 0.0 && base < self.grid[axis] as f32 - 2.0
        })
    }
}

/// A position for a message.
pub(crate) fn place(x: [f64; 3], dimensions: usize) -> String {
    let components: Vec<_> = x[..dimensions].iter().map(|component| format!("{component:.6}")).collect();
    format!("({})", components.join(", "))
}
