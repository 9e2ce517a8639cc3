//! Scenes: what is simulated. A scene is a TOML text; `SCENES.md` is the schema.

mod body;
mod camera;
mod contact;
mod difference;
mod error;
mod folder;
mod keys;
mod material;
mod memory;
mod region;
mod reorder;
mod sizes;
mod sources;
mod transfer;

use std::path::Path;

pub use body::{Body, Fill, Shape};
pub use camera::CameraPlace;
pub use contact::{Collider, ColliderShape, Contact, SIDES, Wall, Walls};
pub use error::SceneError;
pub use folder::Folder;
use keys::Keys;
pub use material::Material;
pub use memory::available_memory;
pub use reorder::Reorder;
use sources::Sources;
pub use transfer::{Forces, Scheme, Spline, Transfer};

/// The version of the schema.
const VERSION: i64 = 1;

/// More particles than this are refused, before memory is asked for.
pub(crate) const MOST_PARTICLES: usize = 1 << 25;

/// Axes of more nodes are refused.
const LONGEST: i64 = 1 << 15;

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
    /// Whether the domain may be larger than a dense grid can be, for layouts whose grid holds the nodes near particles alone.
    pub sparse: bool,
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
    /// When the particles are sorted by cell.
    pub reorder: Reorder,
    /// Steps that a run takes if none are asked for.
    pub steps: u64,
    /// What it holds.
    pub bodies: Vec<Body>,
    /// The scene as one TOML text, its keys in alphabetical order: with what it includes and what was overridden, and
    /// with another grid or number of particles, if there are.
    pub text: String,
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
    "sparse",
    "length",
    "dt",
    "gravity",
    "spacing",
    "wall",
    "reorder",
    "steps",
    "include",
    "material",
    "transfer",
    "walls",
    "camera",
    "seed",
    "body",
    "collider",
];

impl Scene {
    /// Reads a scene from a file.
    ///
    /// # Errors
    /// One line that names file, key and value.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::load_with(path, &[])
    }

    /// Reads a scene from a file, and replaces values of it: `dt=1e-4`, `body.0.velocity=[1, 0]`. Each is the path of a
    /// key, with numbers in lists from zero on, and a value in TOML; a bare word is a text.
    ///
    /// # Errors
    /// One line that names file, key and value, and the override that it comes from.
    pub fn load_with(path: &Path, overrides: &[String]) -> Result<Self, SceneError> {
        let file = path.display().to_string();
        let bytes = std::fs::read(path).map_err(|error| SceneError::new(&*file, format!("cannot be read: {error}")))?;
        let text = String::from_utf8(bytes).map_err(|_| SceneError::new(&*file, "is not a text in UTF-8"))?;
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        Self::parse_with(&text, &file, Folder::Path(folder), overrides)
    }

    /// Reads a scene from its text. `file` is its name in messages; files that it names are looked for in `folder`.
    ///
    /// # Errors
    /// One line that names file, key and value.
    pub fn parse(text: &str, file: &str, folder: Folder) -> Result<Self, SceneError> {
        Self::parse_with(text, file, folder, &[])
    }

    /// Reads a scene from its text, and replaces values of it as [`load_with`](Self::load_with) does.
    ///
    /// # Errors
    /// One line that names file, key and value, and the override that it comes from.
    pub fn parse_with(text: &str, file: &str, folder: Folder, overrides: &[String]) -> Result<Self, SceneError> {
        let sources = Sources::read(text, file, &folder, overrides)?;
        Self::read(&sources.table, file, &folder).map_err(|error| sources.with_origin(error))
    }

    fn read(table: &toml::Table, file: &str, folder: &Folder) -> Result<Self, SceneError> {
        let keys = Keys::new(file, String::new(), table, KEYS)?;
        if keys.whole("version", i64::MIN, i64::MAX)? != Some(VERSION) {
            return Err(keys.fault("version", format!("must be there and {VERSION}, the version of the schema")));
        }
        let solver = keys.required_text("solver", "\"mpm\"")?.to_string();
        let Some(dimensions) = keys.whole("dimensions", 2, 3)? else {
            return Err(keys.fault("dimensions", "is missing; write `dimensions = 2` or `dimensions = 3`"));
        };
        let dimensions = dimensions as usize;
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
            return Err(
                keys.fault("spacing", "is not from 0.05 to 1 cell; fewer than one particle a cell tears the fluid")
            );
        }
        let materials = material::read(&keys)?;
        let walls = keys.table("walls", contact::WALLS)?;
        let camera = keys.table("camera", camera::KEYS)?;
        if camera.is_some() && dimensions == 2 {
            return Err(keys.fault("camera", "is for `dimensions = 3`; the whole of a plane is seen"));
        }
        let seed = keys.whole("seed", 0, i64::MAX)?.unwrap_or(0) as u64;
        let scene = Self {
            file: file.to_string(),
            about: keys.text("about")?.unwrap_or_default().to_string(),
            solver,
            dimensions,
            grid,
            sparse,
            length: keys.positive("length", "1.0")?,
            dt: keys.positive("dt", "2e-4")?,
            gravity: keys.vector("gravity", dimensions)?.unwrap_or_default(),
            spacing,
            wall,
            transfer,
            walls: walls.map(|keys| contact::read_walls(&keys, dimensions)).transpose()?.unwrap_or_default(),
            colliders: keys
                .all_tables("collider")?
                .iter()
                .map(|keys| Collider::read(keys, dimensions, folder))
                .collect::<Result<_, _>>()?,
            camera: camera.map(|keys| CameraPlace::read(&keys)).transpose()?.unwrap_or_default(),
            seed,
            reorder: keys.reorder("reorder")?.unwrap_or_default(),
            steps: keys.whole("steps", 1, i64::MAX)?.unwrap_or(1000) as u64,
            bodies: keys
                .all_tables("body")?
                .iter()
                .enumerate()
                .map(|(n, keys)| Body::read(keys, dimensions, &materials, seed + n as u64, folder))
                .collect::<Result<_, _>>()?,
            materials,
            text: table.to_string(),
        };
        if scene.bodies.is_empty() {
            return Err(keys.fault("body", "is missing; write a table `[[body]]` for each body"));
        }
        Ok(scene)
    }

    /// In what this scene differs from another, given by its [`text`](Self::text): the first key whose value differs,
    /// with both values. `about`, `camera` and `steps` change nothing of what is simulated, and are not compared; nor
    /// are files of meshes and points, beside their names.
    pub fn difference(&self, other: &str) -> Option<String> {
        difference::first(&self.text, other)
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

    /// The particles with which the scene starts, body after body.
    ///
    /// # Errors
    /// If a particle lies outside the domain, or there are none, or too many for the machine's memory.
    pub fn particles(&self) -> Result<Particles, SceneError> {
        if let Some(available) = available_memory() {
            let bodies = self.bodies.iter();
            let estimate: f64 = bodies.map(|body| body.shape.estimate(self.spacing * self.dx(), self.dimensions)).sum();
            self.check_memory((estimate as usize).min(MOST_PARTICLES), available)?;
        }
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
                let (dx, (first_node, last_node)) = (self.dx(), self.reach());
                let upper: Vec<_> = last_node[..self.dimensions].iter().map(|&n| format!("{:.4}", n * dx)).collect();
                let message = format!(
                    "puts particle {} at {} outside the domain, which reaches from {:.4} on each axis to ({})",
                    first + p,
                    place(positions[p], self.dimensions),
                    first_node * dx,
                    upper.join(", ")
                );
                return Err(self.fault(key, message));
            }
            body.set_off(positions, &mut particles);
        }
        Ok(particles)
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
}

/// A position for a message.
pub(crate) fn place(x: [f64; 3], dimensions: usize) -> String {
    let components: Vec<_> = x[..dimensions].iter().map(|component| format!("{component:.6}")).collect();
    format!("({})", components.join(", "))
}
