//! What holds the cloth and its weight make its momentum; it never has more energy than at the start, and stays its own
//! mirror image.

use allotrope::prelude::*;

use super::{SpringsSetup, within};
use crate::mass_spring::Integrator;
use crate::{Finding, Simulation, Watch};

pub(super) struct Cloth {
    setup: SpringsSetup,
    /// Numbers of the springs that pull fixed masses.
    holding: Vec<usize>,
    /// Momentum after the last look, and the force of weight and held masses then.
    last: Option<(DVec3, DVec3)>,
    /// The largest difference of momentum from the sum of forces, in kg m/s.
    error: f64,
    /// Energy with that of gravity at the start, and the most later, less that.
    start: f64,
    gained: f64,
    fallen: f64,
    asymmetry: f64,
}

const STEPS: u64 = 1000;

impl Cloth {
    pub(super) fn new(setup: &SpringsSetup) -> Self {
        let held = |n: &usize| setup.springs[*n].ends.iter().any(|&end| setup.masses[end as usize].fixed);
        Self {
            holding: (0..setup.springs.len()).filter(held).collect(),
            setup: setup.clone(),
            last: None,
            error: 0.0,
            start: 0.0,
            gained: 0.0,
            fallen: 0.0,
            asymmetry: 0.0,
        }
    }

    /// The weight of free masses, and what the fixed ones pull them with.
    fn force(&self, x: &[[f64; 3]], v: &[[f64; 3]]) -> DVec3 {
        let free = self.setup.masses.iter().filter(|mass| !mass.fixed);
        let mut force = self.setup.parameters.gravity * free.map(|mass| mass.mass).sum::<f64>();
        for spring in self.holding.iter().map(|&n| &self.setup.springs[n]) {
            let [a, b] = spring.ends.map(|end| end as usize);
            let (held, free) = if self.setup.masses[a].fixed { (a, b) } else { (b, a) };
            if self.setup.masses[free].fixed {
                continue;
            }
            let d = DVec3::from(x[held]) - DVec3::from(x[free]);
            let u = DVec3::from(v[held]) - DVec3::from(v[free]);
            let n = d.normalize();
            force += n * (spring.bond.stiffness * (d.length() - spring.bond.rest) + spring.bond.dashpot * u.dot(n));
        }
        force
    }
}

impl Watch for Cloth {
    fn steps(&self) -> u64 {
        STEPS
    }

    fn every(&self) -> u64 {
        1
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let (x, v) = (simulation.positions(), simulation.velocities());
        let parameters = &self.setup.parameters;
        let momentum = DVec3::from(simulation.totals().momentum);
        if let Some((before, force)) = self.last {
            let decay = (-parameters.dt * parameters.drag).exp();
            let expected = (before + force * parameters.dt) * decay;
            self.error = self.error.max(momentum.distance(expected));
        }
        self.last = Some((momentum, self.force(&x, &v)));
        if !simulation.steps().is_multiple_of(50) {
            return;
        }
        let gravity = parameters.gravity;
        let height = |(x, mass): (&[f64; 3], &super::super::Mass)| -mass.mass * gravity.dot(DVec3::from(*x));
        let potential: f64 = x.iter().zip(&self.setup.masses).map(height).sum();
        let energy = simulation.energy();
        let total = energy.kinetic + energy.elastic + potential;
        if simulation.steps() == 0 {
            (self.start, self.fallen) = (total, potential);
        }
        self.gained = self.gained.max(total - self.start);
        if simulation.steps() == STEPS {
            self.fallen -= potential;
        }
        // Rows run along the first axis, between the held corners.
        let columns = self.setup.masses.iter().skip(1).position(|mass| mass.fixed).map_or(1, |n| n + 2);
        let middle = x[0][0] + x[columns - 1][0];
        for row in x.chunks_exact(columns) {
            for (left, right) in row.iter().zip(row.iter().rev()) {
                let across = (left[0] + right[0] - middle).abs();
                self.asymmetry =
                    self.asymmetry.max(across).max((left[1] - right[1]).abs()).max((left[2] - right[2]).abs());
            }
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let weight =
            self.setup.parameters.gravity.length() * self.setup.masses.iter().map(|mass| mass.mass).sum::<f64>();
        let mut findings = vec![
            Finding {
                what: "energy gained from the start on, over what gravity gave".into(),
                measured: self.gained / self.fallen,
                expected: 0.0,
                least: 0.0,
                most: 1e-2,
                source: "drag and dashpots take energy; symplectic Euler keeps it within w dt",
            },
            within(
                "largest asymmetry in m".into(),
                self.asymmetry,
                0.0,
                1e-9,
                "the mirror image of the start is the start",
            ),
        ];
        if self.setup.parameters.integrator == Integrator::SymplecticEuler {
            findings.push(within(
                "largest change of momentum in a step not by weight, held corners and drag, over weight times dt"
                    .into(),
                self.error / (weight * self.setup.parameters.dt),
                0.0,
                1e-8,
                "Newton's third law: springs between free masses change no momentum",
            ));
        }
        findings
    }
}
