//! What changes from point to point.

use std::cmp::Ordering;
use std::collections::HashSet;

use allotrope::MAX_THREADS;
use allotrope_solvers::scene::Reorder;
use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::lab::bench::Plan;
use crate::lab::errors::LabError;
use crate::lab::machine;

/// What changes from point to point.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// The number of particles, with the grid in proportion where there is one
    Size,
    /// Particles a cell, on the same grid
    ParticlesPerCell,
    /// The part of a grid's cells that holds particles, in a domain that grows around them
    Sparsity,
    /// The number of threads
    Threads,
    /// When particles are sorted: steps, 0 for never, or `auto`
    Order,
}

/// What a sweep begins with: the scene as it was asked for.
pub(super) struct Start {
    particles: usize,
    /// Nodes along the first axis, if there is a grid.
    nodes: Option<usize>,
    dimensions: usize,
    /// Particles a cell, of the cells in which there are any.
    density: f64,
    /// The part of the cells in which there are any.
    filled: f64,
}

/// Particles a cell, if nothing else is asked for.
const DENSITIES: [&str; 5] = ["1", "2", "4", "8", "16"];

/// Parts of the cells that hold particles, if nothing else is asked for; those that the scene can have.
const SPARSITIES: [f64; 6] = [0.3, 0.1, 0.03, 0.01, 0.003, 0.001];

/// Steps after which particles are sorted, if nothing else is asked for.
const ORDERS: [&str; 6] = ["0", "1", "8", "64", "512", "auto"];

impl Start {
    /// # Errors
    /// If the scene has nothing that could change along the axis, or cannot be built.
    pub(super) fn new(plan: &Plan, axis: Axis) -> Result<Self, LabError> {
        let Plan { solver, scene, layouts, .. } = plan;
        if axis == Axis::Order && !scene.setup.sorts() {
            return Err(cannot(axis, solver.name, "sorts nothing"));
        }
        let fits = |layout: &&&str| (solver.unfit)(scene, layout).is_none();
        let Some(layout) = layouts.iter().find(fits) else {
            return Err(LabError::usage(format!("no layout that is asked for fits scene `{}`", scene.file)));
        };
        let simulation = (solver.build)(scene, layout)?;
        let (nodes, dimensions) = (simulation.grid_shape().first().copied(), simulation.dimensions());
        if matches!(axis, Axis::ParticlesPerCell | Axis::Sparsity) && nodes.is_none() {
            return Err(cannot(axis, solver.name, "has no grid"));
        }
        let cell = simulation.extent()[0] / nodes.unwrap_or(1) as f64;
        let positions = simulation.positions();
        let cells: HashSet<_> =
            positions.iter().map(|x| x.map(|component| (component / cell).floor() as i64)).collect();
        let density = positions.len() as f64 / cells.len().max(1) as f64;
        let filled = cells.len() as f64 / simulation.grid_shape().iter().map(|&nodes| nodes as f64).product::<f64>();
        Ok(Self { particles: simulation.particles(), nodes, dimensions, density, filled })
    }

    /// What is compared at a point.
    ///
    /// # Errors
    /// If the scene cannot be so.
    pub(super) fn point(&self, plan: &Plan, axis: Axis, value: &str) -> Result<Plan, LabError> {
        let (fault, mut plan) = (|why: String| axis.fault(value, &why), plan.clone());
        match axis {
            Axis::Size => {
                let count: usize = value.parse().map_err(|_| fault("is no number of particles".into()))?;
                if let Some(nodes) = self.nodes {
                    let factor = (count as f64 / self.particles as f64).powf(1.0 / self.dimensions as f64);
                    plan.scene = plan.scene.with_grid((nodes as f64 * factor).round() as usize)?;
                }
                // Of the scene's own size nothing need be changed.
                if count != self.particles {
                    plan.scene = plan.scene.with_particles(count)?;
                }
            }
            Axis::ParticlesPerCell => {
                let wanted: f64 = value.parse().map_err(|_| fault("is no number of particles a cell".into()))?;
                plan.scene =
                    plan.scene.with_particles((self.particles as f64 * wanted / self.density).round() as usize)?;
            }
            Axis::Sparsity => {
                let wanted: f64 = value.parse().map_err(|_| fault("is no part of the cells".into()))?;
                if wanted > 1.1 * self.filled {
                    let filled = three_digits(self.filled);
                    return Err(fault(format!(
                        "cannot be: the scene fills {filled} of its cells, and can be given more room alone"
                    )));
                }
                let factor = (self.filled / wanted).powf(1.0 / self.dimensions as f64);
                let nodes = self.nodes.unwrap_or(1) as f64;
                plan.scene = plan.scene.with_room((nodes * factor.max(1.0)).round() as usize)?;
            }
            Axis::Threads => plan.threads = Some(value.parse().map_err(|_| fault("is no number of threads".into()))?),
            Axis::Order => plan.scene = plan.scene.with_reorder(value.parse().map_err(fault)?)?,
        }
        Ok(plan)
    }
}

/// That there is nothing that could change along the axis, since the solver `why`.
fn cannot(axis: Axis, solver: &str, why: &str) -> LabError {
    LabError::usage(format!("`--sweep {}` cannot be, since the solver `{solver}` {why}", axis.name()))
}

impl Axis {
    /// The values that are taken if none are asked for.
    pub(super) fn usual(self, start: &Start) -> Vec<String> {
        match self {
            Self::Size => {
                let factors = [(1, 16), (1, 4), (1, 1), (4, 1)];
                let mut counts: Vec<_> = factors.map(|(times, over)| (start.particles * times / over).max(1)).into();
                counts.dedup();
                counts.iter().map(usize::to_string).collect()
            }
            Self::ParticlesPerCell => DENSITIES.map(String::from).into(),
            Self::Sparsity => {
                let own = three_digits(start.filled);
                let emptier = SPARSITIES.iter().filter(|&&part| part < 0.7 * start.filled).map(f64::to_string);
                std::iter::once(own).chain(emptier.take(4)).collect()
            }
            Self::Threads => {
                let all = machine::threads(None);
                let powers = std::iter::successors(Some(1), |threads| Some(2 * threads)).take_while(|&n| n < all);
                powers.chain([all]).map(|threads: usize| threads.to_string()).collect()
            }
            Self::Order => ORDERS.map(String::from).into(),
        }
    }

    /// Refuses a value that cannot be.
    ///
    /// # Errors
    /// Names axis and value.
    pub(super) fn check(self, value: &str) -> Result<(), LabError> {
        let number = value.parse::<usize>();
        match (self, number) {
            (Self::Size | Self::Threads, Ok(0)) => Err(self.fault(value, "must be at least 1")),
            (Self::Threads, Ok(many)) if many > MAX_THREADS => {
                Err(self.fault(value, &format!("is more than the {MAX_THREADS} threads that are supported")))
            }
            (Self::Size | Self::Threads, Ok(_)) => Ok(()),
            (Self::Size | Self::Threads, Err(_)) => Err(self.fault(value, "is no whole number above zero")),
            (Self::ParticlesPerCell, _) => match value.parse::<f64>() {
                Ok(density) if density.is_finite() && density > 0.0 => Ok(()),
                _ => Err(self.fault(value, "is no number above zero")),
            },
            (Self::Sparsity, _) => match value.parse::<f64>() {
                Ok(part) if part > 0.0 && part <= 1.0 => Ok(()),
                _ => Err(self.fault(value, "is no number above zero and at most 1")),
            },
            (Self::Order, _) => {
                value.parse::<Reorder>().map(|_| ()).map_err(|why| self.fault(value, &format!("cannot be: {why}")))
            }
        }
    }

    fn fault(self, value: &str, why: &str) -> LabError {
        LabError::usage(format!("point `{value}` of `--sweep {}` {why}", self.name()))
    }

    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Self::Size => "size",
            Self::ParticlesPerCell => "particles-per-cell",
            Self::Sparsity => "sparsity",
            Self::Threads => "threads",
            Self::Order => "order",
        }
    }

    /// A value in words.
    pub(super) fn named(self, value: &str) -> String {
        match (self, value) {
            (Self::Size, _) => format!("{value} particles"),
            (Self::ParticlesPerCell, "1") => "1 particle a cell".into(),
            (Self::ParticlesPerCell, _) => format!("{value} particles a cell"),
            (Self::Sparsity, _) => format!("{value} of the cells filled"),
            (Self::Threads, "1") => "1 thread".into(),
            (Self::Threads, _) => format!("{value} threads"),
            (Self::Order, "0") => "particles that are never sorted".into(),
            (Self::Order, "1") => "particles sorted at each step".into(),
            (Self::Order, "auto") => "particles sorted when it pays".into(),
            (Self::Order, _) => format!("particles sorted every {value} steps"),
        }
    }

    /// Which of two values comes first: by number, never sorted first, `auto` last.
    pub(super) fn order(self, a: &str, b: &str) -> Ordering {
        let place = |value: &str| value.parse().unwrap_or(f64::INFINITY);
        place(a).total_cmp(&place(b))
    }
}

/// A part of one, in three digits.
fn three_digits(part: f64) -> String {
    let decimals = (2 - part.max(1e-9).log10().floor() as i32).max(0) as usize;
    let text = format!("{part:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_checked_before_anything_is_measured() {
        let refused = |axis: Axis, value| axis.check(value).unwrap_err().to_string();
        assert_eq!(refused(Axis::Size, "0"), "point `0` of `--sweep size` must be at least 1");
        assert_eq!(refused(Axis::Size, "many"), "point `many` of `--sweep size` is no whole number above zero");
        assert_eq!(
            refused(Axis::Threads, "100000"),
            "point `100000` of `--sweep threads` is more than the 256 threads that are supported"
        );
        let wanted = "point `often` of `--sweep order` cannot be: a number of steps, 0 for never, or `auto` is wanted";
        assert_eq!(refused(Axis::Order, "often"), wanted);
        for (axis, value) in [(Axis::Size, "8192"), (Axis::Threads, "2"), (Axis::Order, "0"), (Axis::Order, "auto")] {
            assert!(axis.check(value).is_ok(), "{value}");
        }
    }

    #[test]
    fn values_have_an_order() {
        let mut values = ["auto", "64", "0", "8"];
        values.sort_by(|a, b| Axis::Order.order(a, b));
        assert_eq!(values, ["0", "8", "64", "auto"]);
        assert!(Axis::ParticlesPerCell.order("0.5", "10").is_lt());
    }

    #[test]
    fn a_size_keeps_the_particles_of_a_cell() {
        let solver = allotrope_solvers::solver("mpm").unwrap();
        let plan = Plan {
            solver,
            name: "mpm88".into(),
            scene: solver.scene("mpm88").unwrap(),
            layouts: vec!["aos+row"],
            schedules: Vec::new(),
            threads: None,
            steps: None,
            hardware: false,
        };
        let start = Start::new(&plan, Axis::Size).unwrap();
        assert_eq!(Axis::Size.usual(&start), ["512", "2048", "8192", "32768"]);
        for (value, nodes) in [("512", 32), ("8192", 128), ("32768", 256)] {
            let scene = start.point(&plan, Axis::Size, value).unwrap().scene;
            let simulation = (solver.build)(&scene, "aos+row").unwrap();
            assert_eq!((simulation.particles().to_string().as_str(), simulation.grid_shape()[0]), (value, nodes));
        }
        assert_eq!(start.point(&plan, Axis::Threads, "2").unwrap().threads, Some(2));
        assert_eq!(start.point(&plan, Axis::Order, "64").unwrap().scene.reorder(), Reorder::Every(64));
        // 8192 particles at random on some 2621 cells.
        for (value, least, most) in [("1", 2450, 2700), ("4", 9800, 10800), ("0.5", 1200, 1400)] {
            let scene = start.point(&plan, Axis::ParticlesPerCell, value).unwrap().scene;
            let simulation = (solver.build)(&scene, "aos+row").unwrap();
            assert!((least..most).contains(&simulation.particles()), "{value}: {}", simulation.particles());
            assert_eq!(simulation.grid_shape()[0], 128);
        }
        assert_eq!(three_digits(start.filled), "0.156", "a box of 0.4 by 0.4, with few cells left out by chance");
        assert_eq!(Axis::Sparsity.usual(&start), ["0.156", "0.1", "0.03", "0.01", "0.003"]);
        for (value, part) in [("0.156", 0.156), ("0.03", 0.03), ("0.01", 0.01)] {
            let point = start.point(&plan, Axis::Sparsity, value).unwrap();
            let there = Start::new(&point, Axis::Sparsity).unwrap();
            assert!((there.filled / part - 1.0).abs() < 0.02 && there.particles == 8192, "{value}: {}", there.filled);
            let simulation = (solver.build)(&point.scene, "aos+row").unwrap();
            let cell = simulation.extent()[0] / simulation.grid_shape()[0] as f64;
            assert!((cell - 1.0 / 128.0).abs() < 1e-12, "cells stay as large as they are: {cell}");
        }
        let error = start.point(&plan, Axis::Sparsity, "0.5").unwrap_err().to_string();
        assert!(error.contains("fills 0.156 of its cells, and can be given more room alone"), "{error}");
        let error = start.point(&plan, Axis::Size, "99999999999").unwrap_err().to_string();
        assert!(error.contains("`grid = "), "{error}");
    }
}
