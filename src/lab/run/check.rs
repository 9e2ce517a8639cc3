//! `allotrope run --check`: a scene's numbers against published ones or closed forms.

use std::time::Instant;

use allotrope::Schedule;
use allotrope_solvers::{Finding, Gate, Simulation, SolverInfo, Watch};

use super::progress::{Progress, Reporter};
use crate::lab::errors::LabError;
use crate::lab::output;
use crate::lab::table::Table;

/// The check of a built-in scene.
///
/// # Errors
/// If it has none; those that have one are named.
pub fn gate(solver: &SolverInfo, scene: &str) -> Result<Gate, LabError> {
    if let Some(gate) = solver.scenes.iter().find(|info| info.name == scene).and_then(|info| info.gate) {
        return Ok(gate);
    }
    let known: Vec<_> = solver.scenes.iter().filter(|info| info.gate.is_some()).map(|info| info.name).collect();
    let those = match &known[..] {
        [] => format!("no scene of `{}` has one", solver.name),
        known => format!("those that have one are `{}`", known.join("`, `")),
    };
    Err(LabError::usage(format!("scene `{scene}` has no check; {those}")))
}

/// Runs a simulation to the end of its check, and prints what was found.
///
/// # Errors
/// If a step is refused, the check's end is not reached, or a finding is out of its bounds.
pub fn check(
    simulation: &mut dyn Simulation,
    watch: &mut dyn Watch,
    schedule: Schedule,
    progress: Progress,
    quiet: bool,
) -> Result<(), LabError> {
    let (steps, every, start) = (watch.steps(), watch.every().max(1), Instant::now());
    let mut reporter = Reporter::new(progress, quiet, steps, 0);
    watch.look(simulation);
    let until = watch.until();
    let ended = |simulation: &dyn Simulation| until.is_some_and(|until| simulation.time() >= until);
    while simulation.steps() < steps && !ended(simulation) {
        let next = (simulation.steps() + every).min(steps);
        schedule.run(|| {
            while simulation.steps() < next && !ended(simulation) {
                simulation.step()?;
                reporter.step(simulation.steps());
            }
            Ok::<(), LabError>(())
        })?;
        watch.look(simulation);
    }
    reporter.clear();
    if let Some(until) = until.filter(|_| !ended(simulation)) {
        return Err(LabError::failure(format!(
            "the check ends after {} s, and {steps} steps came to {} s",
            number(until),
            number(simulation.time())
        )));
    }
    let (findings, steps) = (watch.findings(), simulation.steps());
    if !quiet {
        output::print(&text(&findings))?;
        output::print(&format!("{steps} steps in {:.2} s\n", start.elapsed().as_secs_f64()))?;
    }
    let failed: Vec<_> = findings.iter().filter(|finding| !finding.passes()).collect();
    match failed.first() {
        None => Ok(()),
        Some(first) => Err(LabError::failure(format!(
            "{} of {} checks failed; the first: {} is {}, where {} to {} passes",
            failed.len(),
            findings.len(),
            first.what,
            number(first.measured),
            number(first.least),
            number(first.most)
        ))),
    }
}

/// The table of findings.
fn text(findings: &[Finding]) -> String {
    // Numbers are aligned to the right, and what follows them is made as wide as it can be.
    let width = findings.iter().map(|finding| finding.source.chars().count()).max().unwrap_or(0).max(6);
    let source = |text: &str| format!("  {text:<width$}");
    let headline = ["what", "", "measured", "expected", "least", "most"].map(String::from);
    let mut table = Table::new(headline.into_iter().chain([source("source")]), 2);
    for finding in findings {
        let Finding { what, measured, expected, least, most, .. } = finding;
        let verdict = if finding.passes() { "ok" } else { "FAILED" };
        let numbers = [measured, expected, least, most].map(|&value| number(value));
        let cells = [what.clone(), verdict.to_string()].into_iter().chain(numbers);
        table.row(cells.chain([source(finding.source)]));
    }
    table.text()
}

/// Five digits, without a power where it can be read without.
fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.4e}");
    }
    let digits = (4 - size.log10().floor() as i32).clamp(0, 8) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

#[cfg(test)]
mod tests {
    use allotrope_solvers::{Scene, SceneError, SceneInfo};

    use super::*;

    /// Looks at the mass and the height of a fluid.
    struct Fall {
        looks: Vec<u64>,
        mass: f64,
        bound: f64,
    }

    impl Watch for Fall {
        fn steps(&self) -> u64 {
            5
        }

        fn every(&self) -> u64 {
            2
        }

        fn look(&mut self, simulation: &dyn Simulation) {
            self.looks.push(simulation.steps());
            self.mass = simulation.totals().mass;
        }

        fn findings(&self) -> Vec<Finding> {
            vec![Finding {
                what: "mass in kg".into(),
                measured: self.mass,
                expected: 0.125,
                least: 0.0,
                most: self.bound,
                source: "spacing squared times density",
            }]
        }
    }

    fn outcome(bound: f64) -> (Vec<u64>, Result<(), LabError>) {
        let solver = allotrope_solvers::solver("mpm").unwrap();
        let mut simulation = (solver.build)(&solver.scene("mpm88").unwrap(), "aos+row").unwrap();
        let mut watch = Fall { looks: Vec::new(), mass: 0.0, bound };
        let done = check(&mut *simulation, &mut watch, Schedule::default(), Progress::None, true);
        (watch.looks, done)
    }

    #[test]
    fn a_check_looks_at_the_start_now_and_then_and_at_the_end() {
        let (looks, done) = outcome(0.2);
        assert_eq!(looks, [0, 2, 4, 5]);
        done.unwrap();
    }

    #[test]
    fn a_failed_check_is_a_failure() {
        let error = outcome(0.1).1.unwrap_err();
        let wanted = "1 of 1 checks failed; the first: mass in kg is 0.125, where 0 to 0.1 passes";
        assert_eq!((error.status(), error.to_string().as_str()), (1, wanted));
    }

    #[test]
    fn findings_are_a_table() {
        let finding = |what: &str, measured, source| Finding {
            what: what.into(),
            measured,
            expected: 0.5,
            least: 0.25,
            most: 1.0,
            source,
        };
        let table = "what                   measured  expected  least  most    source\n\
                     a front in m  ok        0.51235       0.5   0.25     1    by hand\n\
                     a mass in kg  FAILED  1.2000e-5       0.5   0.25     1    by hand, twice\n";
        let findings =
            [finding("a front in m", 0.512_345_6, "by hand"), finding("a mass in kg", 1.2e-5, "by hand, twice")];
        assert_eq!(text(&findings), table);
    }

    #[test]
    fn numbers_have_five_digits() {
        assert_eq!(
            [12345.678, 0.0, -2.5, 1e9, 1e-6, f64::NAN].map(number),
            ["12346", "0", "-2.5", "1.0000e9", "1.0000e-6", "NaN"]
        );
    }

    #[test]
    fn a_scene_without_a_check_says_so() {
        fn fall(_scene: &Scene) -> Result<Box<dyn Watch>, SceneError> {
            Ok(Box::new(Fall { looks: Vec::new(), mass: 0.0, bound: 1.0 }))
        }
        const fn scene(name: &'static str, gate: Option<Gate>) -> SceneInfo {
            SceneInfo { name, about: "", text: "", gate }
        }
        const SOME: &[SceneInfo] = &[scene("pool", None), scene("dam", Some(fall)), scene("disk", Some(fall))];
        const NONE: &[SceneInfo] = &[scene("pool", None)];
        let mpm = allotrope_solvers::solver("mpm").unwrap();
        let with = |scenes| SolverInfo { name: "mpm", about: "", scenes, layouts: &[], dimensions: 2..=3, ..*mpm };
        let some = with(SOME);
        assert_eq!(gate(&some, "disk").unwrap()(&mpm.scene("mpm88").unwrap()).unwrap().steps(), 5);
        for name in ["pool", "my.toml"] {
            let error = gate(&some, name).unwrap_err();
            let wanted = format!("scene `{name}` has no check; those that have one are `dam`, `disk`");
            assert_eq!((error.status(), error.to_string()), (2, wanted));
        }
        let error = gate(&with(NONE), "pool").unwrap_err();
        assert_eq!(error.to_string(), "scene `pool` has no check; no scene of `mpm` has one");
    }
}
