//! `allotrope list`: what there is.

use std::fmt::Write;

use allotrope_solvers::solvers;

use super::machine;
use super::table::Table;

/// All solvers with their scenes and layouts, and the schedules, as text.
pub fn text() -> String {
    let mut text = String::new();
    for solver in solvers() {
        let _ = writeln!(text, "solver {}: {}", solver.name, solver.about);
        let mut scenes = Table::new(["  scene", ""], 2);
        for scene in solver.scenes {
            scenes.row([format!("    {}", scene.name), scene.about.to_string()]);
        }
        let mut layouts = Table::new(["  layout", ""], 2);
        for layout in solver.layouts {
            layouts.row([format!("    {}", layout.name), layout.about.to_string()]);
        }
        text.push_str(&scenes.text());
        text.push_str(&layouts.text());
    }
    let mut schedules = Table::new(["schedule", ""], 2);
    for schedule in machine::SCHEDULES {
        schedules.row([format!("    {}", schedule.name), schedule.about.to_string()]);
    }
    text.push_str(&schedules.text());
    let _ = writeln!(
        text,
        "The first scene, layout and schedule are the defaults. Scenes can also be files: see solvers/SCENES.md."
    );
    text
}
