//! What a solver's scenes have beside what all scenes have.

use std::any::Any;
use std::fmt::Debug;

use super::{Collider, Folder, Particles, Reorder, Scene, SceneError};

/// The own part of a solver's scenes: what the laboratory asks of it, whatever the solver.
/// [`Scene::setup`](super::Scene::setup) gives it in its own type.
pub trait Setup: Any + Debug + Send + Sync {
    /// Metres along each axis of the domain, which begins at the origin; zero along axes that the scene does not have.
    fn extent(&self) -> [f64; 3];

    /// The particles with which the scene starts, which is given with this setup in it.
    ///
    /// # Errors
    /// As [`Scene::particles`].
    fn particles(&self, scene: &Scene) -> Result<Particles, SceneError>;

    /// What particles are of, in the order in which they number it.
    fn substances(&self) -> Vec<Substance<'_>> {
        Vec::new()
    }

    /// What stands in the domain.
    fn colliders(&self) -> &[Collider] {
        &[]
    }

    /// The seeds of all that is placed at random; none, if nothing is.
    fn seeds(&self) -> Vec<u64> {
        Vec::new()
    }

    /// Whether particles can be sorted.
    fn sorts(&self) -> bool {
        false
    }

    /// When the particles are sorted.
    fn reorder(&self) -> Reorder {
        Reorder::Never
    }

    /// The scene, which has this setup, with its particles sorted at other times.
    ///
    /// # Errors
    /// If its particles are not sorted.
    fn with_reorder(&self, scene: Scene, reorder: Reorder) -> Result<Scene, SceneError> {
        match reorder {
            Reorder::Never => Ok(scene),
            _ => Err(cannot(&scene, format!("reorder = {reorder}"), "sorts nothing")),
        }
    }

    /// The scene, which has this setup, on another grid.
    ///
    /// # Errors
    /// If it cannot be, or there is no grid.
    fn with_grid(&self, scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
        Err(cannot(&scene, format!("grid = {nodes}"), "has no grid"))
    }

    /// The scene, which has this setup, in another domain of the same cells.
    ///
    /// # Errors
    /// If it cannot be, or there is no grid.
    fn with_room(&self, scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
        Err(cannot(&scene, format!("grid = {nodes}"), "has no grid"))
    }

    /// The scene, which has this setup, with another number of particles.
    ///
    /// # Errors
    /// If it cannot have so many.
    fn with_particles(&self, scene: Scene, count: usize) -> Result<Scene, SceneError> {
        Err(cannot(&scene, format!("particles = {count}"), "has as many particles as its scenes tell"))
    }
}

/// That a scene cannot be changed so, since its solver `why`.
fn cannot(scene: &Scene, key: String, why: &str) -> SceneError {
    scene.fault(key, format!("cannot be, since the solver `{}` {why}", scene.solver))
}

/// What particles are of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Substance<'a> {
    /// Its name.
    pub name: &'a str,
    /// At rest, in kg/m^3.
    pub density: f64,
    /// Whether it flows.
    pub fluid: bool,
}

/// What a solver knows of a scene when it reads its own part of it.
#[derive(Clone, Copy, Debug)]
pub struct Basics<'a> {
    /// From 1 to 3.
    pub dimensions: usize,
    /// Seconds a step, at most.
    pub dt: f64,
    /// Metres a second squared.
    pub gravity: [f64; 3],
    /// Of the generators of random numbers of all that has none of its own.
    pub seed: u64,
    /// Where files are looked for that the scene names.
    pub folder: &'a Folder,
}
