//! The scene in words and pictures.

use super::{Findings, Html, Section, listed};
use crate::lab::errors::LabError;
use crate::lab::scene::size;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let Findings { solver, scene, report, ranking, .. } = findings;
    let extent: Vec<String> = findings.extent.iter().map(|side| format!("{side:.4}")).map(trimmed).collect();
    let gravity: Vec<String> = scene.gravity[..scene.dimensions].iter().map(f64::to_string).collect();
    let mut terms = vec![
        ("Scene".to_string(), about(&report.scene, &scene.about)),
        ("Solver".into(), about(solver.name, solver.about)),
        ("Size".into(), size(report.particles, "", &report.grid)),
        ("Domain".into(), format!("{} m, in {} dimensions", extent.join(" x "), scene.dimensions)),
    ];
    if !findings.materials.is_empty() {
        terms.push(("Materials".into(), listed(&findings.materials)));
    }
    terms.push(("Gravity".into(), format!("({}) m/s\u{b2}", gravity.join(", "))));
    terms.push(("Time step".into(), format!("{:e} s", scene.dt)));
    if scene.setup.sorts() {
        let sorted = match scene.reorder().to_string().as_str() {
            "0" => "never".to_string(),
            "auto" => "when their order in memory has decayed so far that it pays".into(),
            steps => format!("every {steps} steps"),
        };
        terms.push(("Particles are sorted".into(), sorted));
    }
    let pictures: String = findings.pictures.iter().map(super::super::pictures::Pictured::element).collect();
    let mut body = Html::default().terms(&terms).markup(&format!("<div class=\"pictures\">{pictures}</div>"));
    if let Some(best) = ranking.first() {
        let run = findings.commands.run(&best.layout, &best.schedule, findings.steps());
        body = body.command("The pictures are made again, in the folder `allotrope-out`, by:", &run);
    }
    body = body.folded("All values of the scene", &scene.text);
    Ok(Some(Section { id: "scene", title: "What was simulated", body }))
}

fn about(name: &str, about: &str) -> String {
    if about.is_empty() { format!("`{name}`") } else { format!("`{name}`: {about}") }
}

/// A number without zeros at its end.
fn trimmed(number: String) -> String {
    number.trim_end_matches('0').trim_end_matches('.').to_string()
}
