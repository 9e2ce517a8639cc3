//! `allotrope scene check`: scenes that are read, filled and checked, but not run.

use std::path::{Path, PathBuf};

use allotrope_solvers::mpm::largest_step;
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

/// What a scene amounts to.
fn numbers(scene: &Scene, solver: &SolverInfo, layout: &str) -> Result<String, LabError> {
    let simulation = (solver.build)(scene, layout)?;
    let speed = |v: &[f64; 3]| v.iter().map(|component| component * component).sum::<f64>().sqrt();
    let fastest = simulation.velocities().iter().map(speed).fold(0.0, f64::max);
    let nodes: Vec<String> = simulation.grid_shape().iter().map(usize::to_string).collect();
    let materials = simulation.materials();
    Ok(format!(
        "{}D, {} particles of {}, {} nodes, {:.1} MiB, dt {:e} of at most {:.2e}",
        scene.dimensions,
        simulation.particles(),
        materials.join(", "),
        nodes.join(" x "),
        simulation.bytes() as f64 / f64::from(1 << 20),
        scene.dt,
        largest_step(scene, fastest)
    ))
}
