//! `allotrope list`: what there is.

use std::fmt::Write;

use allotrope_solvers::{Scene, solvers};

use super::machine;
use super::peers::WORKLOADS;
use super::table::Table;

/// All solvers with their scenes and layouts, the schedules, and the workloads that other systems have too, as text.
pub fn text() -> String {
    let mut text = String::new();
    for solver in solvers() {
        let _ = writeln!(text, "solver {}: {}", solver.name, solver.about);
        let mut scenes = Table::new(["  scene", ""], 2);
        for scene in solver.scenes {
            scenes.row([format!("    {}", scene.name), scene.about.to_string()]);
        }
        let mut layouts = Table::new(["  layout", ""], 2);
        let scenes_read: Vec<_> =
            solver.scenes.iter().filter_map(|info| Some((info.name, solver.scene(info.name).ok()?))).collect();
        for layout in solver.layouts {
            let fit = |scene: &Scene| (solver.unfit)(scene, layout.name).is_none();
            let unfit: Vec<_> = scenes_read.iter().filter(|(_, scene)| !fit(scene)).map(|(name, _)| *name).collect();
            layouts.row([format!("    {}", layout.name), format!("{}{}", layout.about, not_for(&unfit))]);
        }
        text.push_str(&scenes.text());
        text.push_str(&layouts.text());
    }
    let mut schedules = Table::new(["schedule", ""], 2);
    for schedule in machine::SCHEDULES {
        schedules.row([format!("    {}", schedule.name), schedule.about.to_string()]);
    }
    text.push_str(&schedules.text());
    let mut workloads = Table::new(["workload of `compare`", ""], 2);
    for workload in WORKLOADS {
        workloads.row([format!("    {}", workload.name), workload.about.to_string()]);
    }
    text.push_str(&workloads.text());
    let _ = writeln!(
        text,
        "The first scene, layout and schedule are the defaults. Scenes can also be files: see solvers/SCENES.md."
    );
    text
}

/// Marks a layout by the scenes that it does not fit.
fn not_for(scenes: &[&str]) -> String {
    if scenes.is_empty() { String::new() } else { format!(" [not for {}]", scenes.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layouts_are_marked_by_the_scenes_that_they_do_not_fit() {
        assert_eq!(not_for(&[]), "");
        assert_eq!(not_for(&["snow", "sand"]), " [not for snow, sand]");
        // As many marks as there are layouts that some scene does not fit.
        let unfit = |solver: &allotrope_solvers::SolverInfo, layout: &str| {
            solver.scenes.iter().any(|info| (solver.unfit)(&solver.scene(info.name).unwrap(), layout).is_some())
        };
        let marks = solvers()
            .iter()
            .flat_map(|solver| solver.layouts.iter().filter(|layout| unfit(solver, layout.name)))
            .count();
        assert_eq!(text().matches("[not for ").count(), marks);
    }
}
