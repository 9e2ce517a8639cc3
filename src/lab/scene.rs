//! `allotrope scene check`: scenes that are read, filled and checked, but not run.

use std::path::{Path, PathBuf};

use allotrope_solvers::{Scene, SolverInfo};

use super::errors::{self, LabError};
use super::output;

/// Prints a line about each file that is a scene, and the fault of each that is none.
///
/// # Errors
/// If one of them is none.
pub fn check(files: &[PathBuf]) -> Result<(), LabError> {
    let mut wrong = Vec::new();
    for file in files {
        match about(file) {
            Ok(line) => output::print(&line)?,
            Err(error) => wrong.push(error),
        }
    }
    // The last fault is told as that of the program.
    let last = wrong.pop();
    for error in wrong {
        errors::tell(&format!("error: {error}"));
    }
    last.map_or(Ok(()), Err)
}

/// A line about a scene.
fn about(file: &Path) -> Result<String, LabError> {
    let scene = Scene::load(file)?;
    let solver = allotrope_solvers::solver(&scene.solver)
        .map_err(|fault| LabError::usage(format!("scene `{}`: `solver` is wrong: {fault}", scene.file)))?;
    let names = solver.layouts.iter().map(|layout| layout.name);
    let (fit, unfit): (Vec<_>, Vec<_>) = names.partition(|layout| (solver.unfit)(&scene, layout).is_none());
    let Some(first) = fit.first() else {
        return Err(LabError::usage(format!("scene `{}`: no layout of `{}` fits it", scene.file, solver.name)));
    };
    let layouts = match unfit[..] {
        [] => "in all layouts".to_string(),
        _ => format!("in {}", fit.join(", ")),
    };
    Ok(format!("{}: {}, {layouts}\n", file.display(), numbers(&scene, solver, first)?))
}

/// How many particles there are, of what, and how many nodes, if there is a grid.
pub(super) fn size(particles: usize, of: &str, grid: &[usize]) -> String {
    let nodes: Vec<String> = grid.iter().map(usize::to_string).collect();
    let nodes = if nodes.is_empty() { String::new() } else { format!(", {} nodes", nodes.join(" x ")) };
    format!("{particles} particles{of}{nodes}")
}

/// What a scene amounts to.
fn numbers(scene: &Scene, solver: &SolverInfo, layout: &str) -> Result<String, LabError> {
    let simulation = (solver.build)(scene, layout)?;
    let materials = match &simulation.materials()[..] {
        [] => String::new(),
        names => format!(" of {}", names.join(", ")),
    };
    let most = simulation.largest_dt().map_or(String::new(), |most| format!(" of at most {most:.2e}"));
    Ok(format!(
        "{}D, {}, {:.1} MiB, dt {:e}{most}",
        scene.dimensions,
        size(simulation.particles(), &materials, &simulation.grid_shape()),
        simulation.bytes() as f64 / f64::from(1 << 20),
        scene.dt,
    ))
}
