//! Scenes: what is simulated. A scene is a TOML text; `SCENES.md` is the schema.
//!
//! [`Scene`] holds what the scenes of all solvers have, and its solver's own part behind the trait [`Setup`].

mod body;
mod camera;
mod contact;
mod difference;
mod error;
mod folder;
mod keys;
mod memory;
mod particles;
pub(crate) mod region;
mod reorder;
mod setup;
mod sources;

use std::any::Any;
use std::path::Path;
use std::sync::Arc;

pub use body::{Body, Fill, Shape};
pub use camera::CameraPlace;
pub use contact::{Collider, ColliderShape, Contact, SIDES, Wall, Walls};
pub(crate) use contact::{WALLS, read_walls};
pub use error::SceneError;
pub use folder::Folder;
pub use keys::Keys;
pub use memory::available_memory;
pub(crate) use memory::gibibytes;
pub use particles::Particles;
pub(crate) use particles::fill;
pub use reorder::Reorder;
pub use setup::{Basics, Setup, Substance};
use sources::Sources;
use toml::Table;

use crate::SolverInfo;
use crate::registry::{self, solvers};

/// The version of the schema.
const VERSION: i64 = 1;

/// More particles than this are refused, before memory is asked for.
pub(crate) const MOST_PARTICLES: usize = 1 << 25;

/// A scene, read and checked. Lengths are metres, times seconds; vectors have components of zero along axes that the
/// scene does not have.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The name or file by which messages tell it.
    pub file: String,
    /// One line about it.
    pub about: String,
    /// The solver that it is for.
    pub solver: String,
    /// From 1 to 3, as the solver allows.
    pub dimensions: usize,
    /// Seconds a step; the longest step, where the solver chooses its steps as it runs.
    pub dt: f64,
    /// Metres a second squared.
    pub gravity: [f64; 3],
    /// From where it is looked at.
    pub camera: CameraPlace,
    /// Of the generators of random numbers of all that has none of its own.
    pub seed: u64,
    /// Steps that a run takes if none are asked for.
    pub steps: u64,
    /// What its solver's scenes have beside that.
    pub setup: Arc<dyn Setup>,
    /// The scene as one TOML text, its keys in alphabetical order: with what it includes and what was overridden, and
    /// in another size, if it was changed.
    pub text: String,
}

/// The keys of all scenes; their solvers have others beside them.
const KEYS: &[&str] =
    &["version", "about", "solver", "dimensions", "dt", "gravity", "steps", "include", "camera", "seed"];

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

    fn read(table: &Table, file: &str, folder: &Folder) -> Result<Self, SceneError> {
        let info = table.get("solver").and_then(|name| solvers().iter().find(|info| Some(info.name) == name.as_str()));
        let own: Vec<&str> = match info {
            Some(info) => info.keys.to_vec(),
            None => solvers().iter().flat_map(|info| info.keys).copied().collect(),
        };
        let keys = Keys::new(file, String::new(), table, &[KEYS, &own].concat())?;
        if keys.whole("version", i64::MIN, i64::MAX)? != Some(VERSION) {
            return Err(keys.fault("version", format!("must be there and {VERSION}, the version of the schema")));
        }
        let info = read_solver(&keys)?;
        let dimensions = read_dimensions(&keys, info)?;
        let camera = keys.table("camera", camera::KEYS)?;
        if camera.is_some() && dimensions < 3 {
            return Err(keys.fault("camera", "is for `dimensions = 3`; the whole of a plane is seen"));
        }
        let basics = Basics {
            dimensions,
            dt: keys.positive("dt", "2e-4")?,
            gravity: keys.vector("gravity", dimensions)?.unwrap_or_default(),
            seed: keys.whole("seed", 0, i64::MAX)?.unwrap_or(0) as u64,
            folder,
        };
        Ok(Self {
            file: file.to_string(),
            about: keys.text("about")?.unwrap_or_default().to_string(),
            solver: info.name.to_string(),
            dimensions,
            dt: basics.dt,
            gravity: basics.gravity,
            camera: camera.map(|keys| CameraPlace::read(&keys)).transpose()?.unwrap_or_default(),
            seed: basics.seed,
            steps: keys.whole("steps", 1, i64::MAX)?.unwrap_or(1000) as u64,
            setup: (info.read)(&keys, &basics)?,
            text: table.to_string(),
        })
    }

    /// In what this scene differs from another, given by its [`text`](Self::text): the first key whose value differs,
    /// with both values. `about`, `camera` and `steps` change nothing of what is simulated, and are not compared; nor
    /// are files of meshes and points, beside their names.
    pub fn difference(&self, other: &str) -> Option<String> {
        difference::first(&self.text, other)
    }

    /// Its solver's own part.
    ///
    /// # Errors
    /// If the scene is for a solver with another one.
    pub fn setup<S: Setup>(&self) -> Result<&S, SceneError> {
        let setup: &dyn Any = &*self.setup;
        setup.downcast_ref().ok_or_else(|| self.of_another())
    }

    /// The same, to change it. The scene's [`text`](Self::text) stays as it was.
    ///
    /// # Errors
    /// If the scene is for a solver with another one.
    pub fn setup_mut<S: Setup + Clone>(&mut self) -> Result<&mut S, SceneError> {
        let (own, fault) = (self.setup::<S>()?, self.of_another());
        if Arc::strong_count(&self.setup) > 1 {
            self.setup = Arc::new(own.clone());
        }
        let setup: Option<&mut dyn Any> = Arc::get_mut(&mut self.setup).map(|setup| setup as _);
        setup.and_then(<dyn Any>::downcast_mut).ok_or(fault)
    }

    fn of_another(&self) -> SceneError {
        SceneError::new(&*self.file, format!("is for the solver `{}`", self.solver))
    }

    /// Metres along each axis; zero along an axis that the scene does not have.
    pub fn extent(&self) -> [f64; 3] {
        self.setup.extent()
    }

    /// The particles with which the scene starts.
    ///
    /// # Errors
    /// If one lies outside the domain, or there are none, or too many for the machine's memory.
    pub fn particles(&self) -> Result<Particles, SceneError> {
        self.setup.particles(self)
    }

    /// The same scene on `nodes` nodes along the first axis, and in proportion along the others. The time step is
    /// changed in proportion to the cell, so that the Courant number stays.
    ///
    /// # Errors
    /// If an axis becomes too short for its walls, or the grid too large, or the solver has none.
    pub fn with_grid(self, nodes: usize) -> Result<Self, SceneError> {
        self.setup.clone().with_grid(self, nodes)
    }

    /// The same scene in a domain of `nodes` nodes along the first axis, and in proportion along the others, whose cells and time step stay as they
    /// are: what it holds stands in more room, or in less.
    ///
    /// # Errors
    /// If an axis becomes too short for its walls, or the grid too large, or the solver has none. That bodies no longer lie within is told by
    /// [`particles`](Self::particles).
    pub fn with_room(self, nodes: usize) -> Result<Self, SceneError> {
        self.setup.clone().with_room(self, nodes)
    }

    /// The same scene with `count` particles, or about so many, as its setup can have them.
    ///
    /// # Errors
    /// If it cannot have so many.
    pub fn with_particles(self, count: usize) -> Result<Self, SceneError> {
        self.setup.clone().with_particles(self, count)
    }

    /// When the particles are sorted.
    pub fn reorder(&self) -> Reorder {
        self.setup.reorder()
    }

    /// The same scene with its particles sorted at other times.
    ///
    /// # Errors
    /// If its solver does not sort particles.
    pub fn with_reorder(self, reorder: Reorder) -> Result<Self, SceneError> {
        self.setup.clone().with_reorder(self, reorder)
    }

    /// Changes the text in the way in which the scene was changed.
    pub(crate) fn rewrite(&mut self, change: impl FnOnce(&mut Table)) {
        if let Ok(mut table) = self.text.parse::<Table>() {
            change(&mut table);
            self.text = table.to_string();
        }
    }

    /// A fault of this scene's key; `key` may tell the value.
    pub(crate) fn fault(&self, key: impl Into<String>, message: impl Into<String>) -> SceneError {
        SceneError::at(&*self.file, key, message)
    }
}

fn read_solver(keys: &Keys<'_>) -> Result<&'static SolverInfo, SceneError> {
    let name = keys.required_text("solver", "\"mpm\"")?;
    registry::solver(name).map_err(|fault| SceneError::at(keys.file_name(), "solver", format!("is wrong: {fault}")))
}

fn read_dimensions(keys: &Keys<'_>, info: &SolverInfo) -> Result<usize, SceneError> {
    let (least, most) = (*info.dimensions.start(), *info.dimensions.end());
    let dimensions = keys.whole("dimensions", least as i64, most as i64)?.ok_or_else(|| {
        let choices: Vec<_> = (least..=most).map(|dimensions| format!("`dimensions = {dimensions}`")).collect();
        keys.fault("dimensions", format!("is missing; write {}", choices.join(" or ")))
    })?;
    Ok(dimensions as usize)
}

/// A position for a message.
pub(crate) fn place(x: [f64; 3], dimensions: usize) -> String {
    let components: Vec<_> = x[..dimensions].iter().map(|component| format!("{component:.6}")).collect();
    format!("({})", components.join(", "))
}
