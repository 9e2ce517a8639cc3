//! What a page tells of.

use allotrope_solvers::{Scene, SolverInfo};

use super::Plan;
use super::commands::Commands;
use super::maps::{self, Drawn};
use super::pictures::{Photographer, Pictured};
use super::ranking::{Ranked, rank};
use super::surroundings::Surroundings;
use crate::lab::bench::text::About;
use crate::lab::bench::{Compared, Report, compare};
use crate::lab::errors::LabError;
use crate::lab::sweep::{Axis, Record, Unwritten};

/// What was measured, where, and how that is done again.
pub(in crate::lab) struct Findings {
    pub(in crate::lab) solver: &'static SolverInfo,
    pub(in crate::lab) scene: Scene,
    /// The comparison.
    pub(in crate::lab) report: Report,
    pub(in crate::lab) about: About,
    /// Its rows, the fastest first.
    pub(in crate::lab) ranking: Vec<Ranked>,
    /// Milliseconds a step in each repetition of each row of the comparison.
    pub(in crate::lab) samples: Vec<Vec<f64>>,
    /// Metres along each axis.
    pub(in crate::lab) extent: Vec<f64>,
    pub(in crate::lab) materials: Vec<String>,
    /// The scene before and after the comparison.
    pub(in crate::lab) pictures: Vec<Pictured>,
    pub(in crate::lab) maps: Vec<Drawn>,
    /// Layouts of which there is no map.
    pub(in crate::lab) unmapped: Vec<String>,
    pub(in crate::lab) sweep: Option<Swept>,
    /// What a step touches.
    pub(in crate::lab) counts: Option<crate::lab::counts::Report>,
    pub(in crate::lab) surroundings: Surroundings,
    pub(in crate::lab) commands: Commands,
}

/// The comparison at other sizes.
pub(in crate::lab) struct Swept {
    pub(in crate::lab) record: Record,
    pub(in crate::lab) points: Vec<String>,
    /// Timed steps of each row at each point.
    pub(in crate::lab) steps: u64,
}

impl Findings {
    /// Compares the layouts, and gathers what is told of that.
    pub(super) fn gather(plan: &Plan) -> Result<Self, LabError> {
        let bench = &plan.bench;
        // What would be refused is refused before anything is measured.
        let sweep = if plan.sweep { Some(Unwritten::new(bench.clone(), Axis::Size)?) } else { None };
        let surroundings = Surroundings::here();
        let start = (bench.solver.build)(&bench.scene, bench.layouts[0])?;
        let photographer = Photographer::new(&*start, &bench.scene);
        let first = photographer.picture(&*start, "at the start")?;
        drop(start);

        let compared = compare(bench, plan.budget)?;
        let report = compared.report(bench);
        let Compared { contenders, about } = compared;
        let samples: Vec<Vec<f64>> = contenders
            .iter()
            .map(|contender| contender.samples.iter().map(|time| time + contender.sorting()).collect())
            .collect();
        let simulation = &*contenders[0].simulation;
        let when = format!("after {} steps, {:.4} s later", simulation.steps(), simulation.time());
        let pictures = vec![first, photographer.picture(simulation, &when)?];
        let extent = simulation.extent()[..simulation.dimensions()].to_vec();
        let materials = simulation.materials();
        let (maps, unmapped) = maps::draw(&contenders);
        drop(contenders);

        let sweep = match sweep {
            Some(sweep) => Some(swept(sweep, &report, plan.budget)?),
            None => None,
        };
        Ok(Self {
            solver: bench.solver,
            scene: bench.scene.clone(),
            ranking: rank(&report, &samples),
            report,
            about,
            samples,
            extent,
            materials,
            pictures,
            maps,
            unmapped,
            sweep,
            counts: plan.counts.clone(),
            surroundings,
            commands: Commands::of(plan),
        })
    }

    /// Steps that all layouts have taken.
    pub(in crate::lab) fn steps(&self) -> u64 {
        self.about.verified + self.about.steps
    }
}

/// Compares at other sizes, for about so many seconds.
fn swept(sweep: Unwritten, report: &Report, seconds: f64) -> Result<Swept, LabError> {
    let points = sweep.points().to_vec();
    let each: f64 = report.rows.iter().map(|row| row.ms_per_step * 1e-3 / report.particles as f64).sum();
    let particles: f64 = points.iter().filter_map(|point| point.parse::<f64>().ok()).sum();
    // Each step is taken once to compare states, and once to be timed.
    let steps = ((seconds / (2.0 * each * particles)) as u64).clamp(11, 110);
    Ok(Swept { record: sweep.record(steps)?, points, steps })
}
