//! The one list of solvers.

use std::ops::RangeInclusive;
use std::sync::Arc;

use crate::nearest::hint;
use crate::scene::{Basics, Folder, Keys, Setup};
use crate::{Gate, Scene, SceneError, Simulation, mass_spring, mpm, sph};

/// A solver: what it offers, and how a simulation is made.
#[derive(Debug)]
pub struct SolverInfo {
    /// The name by which it is asked for.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// How many dimensions its scenes may have, from 1 to 3.
    pub dimensions: RangeInclusive<usize>,
    /// The keys of its scenes beside those of all scenes.
    pub keys: &'static [&'static str],
    /// Reads them.
    pub read: fn(&Keys<'_>, &Basics<'_>) -> Read,
    /// Its built-in scenes; the first is the default.
    pub scenes: &'static [SceneInfo],
    /// The layouts in which it was compiled; the first is the default.
    pub layouts: &'static [LayoutInfo],
    /// Why a scene makes no sense in one of [`layouts`](Self::layouts), if it does not.
    pub unfit: fn(&Scene, layout: &str) -> Option<&'static str>,
    /// Makes the simulation of a scene in one of [`layouts`](Self::layouts).
    pub build: fn(&Scene, layout: &str) -> Built,
}

/// What a solver's scenes have beside what all scenes have, or what is wrong in it.
pub type Read = Result<Arc<dyn Setup>, SceneError>;

/// A simulation, or why its scene cannot be built.
pub type Built = Result<Box<dyn Simulation>, SceneError>;

/// A built-in scene.
#[derive(Debug)]
pub struct SceneInfo {
    /// The name by which it is asked for.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// Its TOML text (`SCENES.md` is the schema).
    pub text: &'static str,
    /// Its check against published numbers or closed forms, where there is one.
    pub gate: Option<Gate>,
}

/// A layout, or a combination of layouts, in which a solver was compiled.
#[derive(Debug)]
pub struct LayoutInfo {
    /// The name by which it is asked for; of solvers with a grid, `particles+grid`.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// Whether there is a grid whose memory follows the particles, so that its domain can be as large as one likes.
    pub sparse: bool,
}

/// All solvers. To add one, add its line here.
pub fn solvers() -> &'static [SolverInfo] {
    static SOLVERS: &[SolverInfo] = &[mpm::SOLVER, mass_spring::SOLVER, sph::wcsph::SOLVER];
    SOLVERS
}

/// The solver of that name.
///
/// # Errors
/// Names the nearest solver if there is none of that name.
pub fn solver(name: &str) -> Result<&'static SolverInfo, String> {
    let known = solvers().iter().map(|solver| solver.name);
    solvers()
        .iter()
        .find(|solver| solver.name == name)
        .ok_or_else(|| format!("there is no solver `{name}`{}", hint(name, known)))
}

impl SolverInfo {
    /// The built-in scene of that name.
    ///
    /// # Errors
    /// Names the nearest scene if there is none of that name.
    pub fn scene(&self, name: &str) -> Result<Scene, SceneError> {
        let known = self.scenes.iter().map(|scene| scene.name);
        let Some(info) = self.scenes.iter().find(|scene| scene.name == name) else {
            let solver = self.name;
            return Err(SceneError::new(name, format!("`{solver}` has no scene of this name{}", hint(name, known))));
        };
        Scene::parse(info.text, name, Folder::BuiltIn)
    }

    /// The layout of that name.
    ///
    /// # Errors
    /// Names the nearest layout if there is none of that name.
    pub fn layout(&self, name: &str) -> Result<&'static LayoutInfo, String> {
        let known = self.layouts.iter().map(|layout| layout.name);
        self.layouts
            .iter()
            .find(|layout| layout.name == name)
            .ok_or_else(|| format!("`{}` has no layout `{name}`{}", self.name, hint(name, known)))
    }
}
