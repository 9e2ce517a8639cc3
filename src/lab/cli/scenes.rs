//! Which scene is asked for.

use std::path::{Path, PathBuf};

use allotrope_solvers::scene::{Folder, Reorder};
use allotrope_solvers::{Scene, SolverInfo};
use clap::Args;

use super::values;
use crate::lab::errors::LabError;
use crate::lab::search::Choice;

/// More particles than this are sorted by cell unless the command says otherwise: grid and particles no longer fit into
/// a core's second cache, and a scattered access costs more than the sort does.
const SORTED_ABOVE: usize = 1 << 16;

/// Which scene, in which size, and for how long.
#[derive(Args, Debug)]
pub(super) struct SceneArguments {
    /// The scene: a built-in name, or a TOML file [default: the first that `list` tells]
    #[arg(long, value_name = "S")]
    pub(super) scene: Option<String>,
    /// Another value than the scene's, such as `dt=1e-4` or `material.density=2.0`; may be given more than once
    #[arg(long, value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,
    /// Another number of particles than the scene's
    #[arg(long, value_name = "N", value_parser = values::count)]
    pub(super) particles: Option<usize>,
    /// Another number of nodes along the first axis than the scene's; the time step is scaled with the cells
    #[arg(long, value_name = "N", value_parser = values::count)]
    pub(super) grid: Option<usize>,
    /// When particles are sorted by cell: after so many steps, 0 for never, or `auto` for when their order has decayed so
    /// far that it pays [default: the scene's; with --particles above 65536, auto]
    #[arg(long, value_name = "N")]
    pub(super) reorder: Option<Reorder>,
    /// Threads [default: ALLOTROPE_THREADS, or as many as the processor runs]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub(super) threads: Option<usize>,
    /// Steps to take [default: the scene's; of `bench`, what takes about 20 seconds, 1100 at most]
    #[arg(long, value_name = "N", value_parser = values::steps)]
    pub(super) steps: Option<u64>,
}

impl SceneArguments {
    /// Takes over when particles are sorted, where no option tells it.
    ///
    /// # Errors
    /// If the file tells it in no known way.
    pub(super) fn tuned(&mut self, file: &Path, choice: &Choice) -> Result<(), LabError> {
        let reorder: Reorder = choice.reorder.parse().map_err(|why| {
            LabError::usage(format!("`{}`: `reorder = \"{}\"`: {why}", file.display(), choice.reorder))
        })?;
        self.reorder.get_or_insert(reorder);
        Ok(())
    }

    /// The options by which the scene is asked for, as words of a command; without threads and steps.
    pub(super) fn words(&self) -> Vec<String> {
        let option = |name: &str, value: &str| [format!("--{name}"), value.to_string()];
        let scene = self.scene.iter().map(|scene| option("scene", scene));
        let set = self.set.iter().map(|set| option("set", set));
        let sizes = [
            ("particles", self.particles.map(|count| count.to_string())),
            ("grid", self.grid.map(|nodes| nodes.to_string())),
            ("reorder", self.reorder.map(|reorder| reorder.to_string())),
        ];
        let sizes = sizes.iter().filter_map(|(name, value)| Some(option(name, value.as_deref()?)));
        scene.chain(set).chain(sizes).flatten().collect()
    }

    /// The name by which the scene is asked for.
    pub(super) fn name<'a>(&'a self, solver: &SolverInfo) -> &'a str {
        self.scene.as_deref().unwrap_or(solver.scenes[0].name)
    }

    /// The scene as it was asked for.
    pub(super) fn scene(&self, solver: &SolverInfo) -> Result<Scene, LabError> {
        self.scene_with(solver, &[])
    }

    /// The scene as it was asked for, with more values that are set.
    pub(super) fn scene_with(&self, solver: &SolverInfo, more: &[String]) -> Result<Scene, LabError> {
        let name = self.name(solver);
        let scene = named(solver, name, &[&self.set, more].concat())?;
        if scene.solver == solver.name {
            return self.sized(scene);
        }
        let of = scene.solver;
        Err(LabError::usage(format!("scene `{name}` is for the solver `{of}`, not `{}`", solver.name)))
    }

    /// A scene in the size that was asked for.
    pub(super) fn sized(&self, mut scene: Scene) -> Result<Scene, LabError> {
        if let Some(nodes) = self.grid {
            scene = scene.with_grid(nodes)?;
        }
        if let Some(particles) = self.particles {
            scene = scene.with_particles(particles)?;
        }
        if let Some(reorder) = self.reorder {
            return Ok(scene.with_reorder(reorder)?);
        }
        let many = self.particles.is_some_and(|particles| particles > SORTED_ABOVE);
        if many && scene.setup.sorts() && scene.reorder() == Reorder::Never {
            scene = scene.with_reorder(Reorder::Decayed)?;
        }
        Ok(scene)
    }
}

/// Whether a name is that of a file: with a dot or a separator in it, or there.
fn is_file(solver: &SolverInfo, name: &str) -> bool {
    let built_in = solver.scenes.iter().any(|scene| scene.name == name);
    !built_in && (name.contains(['/', '\\', '.']) || Path::new(name).is_file())
}

/// The scene of a built-in name or a file, with other values.
pub(super) fn named(solver: &SolverInfo, name: &str, set: &[String]) -> Result<Scene, LabError> {
    if is_file(solver, name) {
        return Ok(Scene::load_with(Path::new(name), set)?);
    }
    match solver.scenes.iter().find(|scene| scene.name == name) {
        Some(info) => Ok(Scene::parse_with(info.text, name, Folder::BuiltIn, set)?),
        // There is none of this name, which is told with the nearest one.
        None => Ok(solver.scene(name)?),
    }
}

/// The folder of the files that a scene of that name names; none for those of the built-in scenes.
pub(super) fn folder(solver: &SolverInfo, name: &str) -> Result<Option<PathBuf>, LabError> {
    if !is_file(solver, name) {
        return Ok(None);
    }
    let path = std::path::absolute(name)
        .map_err(|error| LabError::machine(format!("the folder of `{name}` cannot be told: {error}")))?;
    Ok(path.parent().map(Path::to_path_buf))
}

/// The layout of that name, or the first that fits the scene.
pub(super) fn fitting(
    solver: &'static SolverInfo,
    scene: &Scene,
    name: Option<&str>,
) -> Result<&'static str, LabError> {
    let fit = fit(solver, scene);
    let Some(name) = name else {
        let none = || LabError::usage(format!("no layout of `{}` fits scene `{}`", solver.name, scene.file));
        return fit.first().copied().ok_or_else(none);
    };
    let layout = solver.layout(name).map_err(LabError::usage)?.name;
    match (solver.unfit)(scene, layout) {
        None => Ok(layout),
        Some(why) => Err(LabError::usage(format!(
            "layout `{layout}` does not fit scene `{}`: {why}; those that fit are `{}`",
            scene.file,
            fit.join("`, `")
        ))),
    }
}

/// The layouts of a list with commas, which must fit the scene; `all` are those that do.
pub(super) fn asked(solver: &'static SolverInfo, scene: &Scene, list: &str) -> Result<Vec<&'static str>, LabError> {
    if list.trim() == "all" {
        return Ok(fit(solver, scene));
    }
    values::words(list).into_iter().map(|name| fitting(solver, scene, Some(name))).collect()
}

/// The layouts that fit a scene.
pub(super) fn fit(solver: &'static SolverInfo, scene: &Scene) -> Vec<&'static str> {
    let names = solver.layouts.iter().map(|layout| layout.name);
    names.filter(|layout| (solver.unfit)(scene, layout).is_none()).collect()
}

#[cfg(test)]
mod tests {
    use allotrope_solvers::scene::{Basics, Keys};
    use allotrope_solvers::{Built, LayoutInfo, Read, SceneError};

    use super::*;

    fn no_build(scene: &Scene, _layout: &str) -> Built {
        Err(SceneError::new(&*scene.file, "is not built here"))
    }

    fn no_setup(_keys: &Keys<'_>, _basics: &Basics<'_>) -> Read {
        Err(SceneError::new("none", "is not read here"))
    }

    fn unfit(scene: &Scene, layout: &str) -> Option<&'static str> {
        (scene.dimensions == 2 && layout != "soa").then_some("a plane is not stored in blocks")
    }

    const SOLVER: SolverInfo = SolverInfo {
        name: "mpm",
        about: "",
        dimensions: 2..=3,
        keys: &[],
        read: no_setup,
        scenes: &[],
        layouts: &[
            LayoutInfo { name: "blocked", about: "", sparse: false },
            LayoutInfo { name: "soa", about: "", sparse: false },
        ],
        unfit,
        build: no_build,
    };

    #[test]
    fn a_layout_that_does_not_fit_is_refused_with_the_reason() {
        static OF: SolverInfo = SOLVER;
        static NONE: SolverInfo = SolverInfo { unfit: |_, _| Some("nothing fits"), ..SOLVER };
        let mpm = allotrope_solvers::solver("mpm").unwrap();
        let (plane, space) = (mpm.scene("mpm88").unwrap(), mpm.scene("bunny").unwrap());
        assert_eq!((fit(&OF, &plane), fit(&OF, &space)), (vec!["soa"], vec!["blocked", "soa"]));
        let fitting = |solver, scene, name| fitting(solver, scene, name).map_err(|error| error.to_string());
        assert_eq!(fitting(&OF, &plane, None), Ok("soa"));
        assert_eq!(fitting(&OF, &space, Some("blocked")), Ok("blocked"));
        let why =
            "layout `blocked` does not fit scene `mpm88`: a plane is not stored in blocks; those that fit are `soa`";
        assert_eq!(fitting(&OF, &plane, Some("blocked")), Err(why.into()));
        assert_eq!(fitting(&NONE, &plane, None), Err("no layout of `mpm` fits scene `mpm88`".into()));
    }
}
