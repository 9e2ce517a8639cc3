//! Two elastic disks that collide (Sulsky, Chen & Schreyer 1994).

use super::{scheme, step_at, within};
use crate::mpm::MpmSetup;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str = "Sulsky, Chen & Schreyer 1994; numbers of an independent program in double precision";

/// Kinetic energies are told at these times ..
const TIMES: [f64; 8] = [1.0, 1.5, 1.8, 2.0, 2.2, 2.5, 3.0, 3.5];

/// .. for these schemes and cells a metre, with the total energy at the end.
const TABLE: [(&str, f64, [f64; 8], f64); 6] = [
    ("FLIP", 20.0, [2.5133, 2.0994, 0.4424, 0.1807, 1.2655, 2.1623, 2.2025, 2.1681], 2.3286),
    ("APIC", 20.0, [2.5131, 1.7754, 0.1813, 0.1952, 1.0754, 1.5597, 1.3971, 1.3896], 1.4278),
    ("PIC", 20.0, [2.5131, 1.4286, 0.0298, 0.1675, 0.4477, 0.5095, 0.3875, 0.3820], 0.3898),
    ("FLIP", 40.0, [2.5133, 2.4721, 1.0073, 0.1015, 0.8477, 2.1735, 2.2401, 2.2227], 2.3949),
    ("APIC", 40.0, [2.5133, 2.3887, 0.8213, 0.0289, 0.8286, 1.8778, 1.7950, 1.7992], 1.8994),
    ("PIC", 40.0, [2.5133, 2.3301, 0.4211, 0.0471, 0.5522, 0.8310, 0.7367, 0.7359], 0.7414),
];

/// Kinetic energy at the start, to which those of the table are relative: here disks are cut into whole particles.
const EXACT: f64 = 2.513274;

/// When the disks' rims meet, and the speed at which they approach each other.
const CONTACT: f64 = 1.585786;
const APPROACH: f64 = 0.2828427;

pub(super) struct Disks {
    scene: Scene,
    setup: MpmSetup,
    start: f64,
    contact: Option<f64>,
    kinetic: Vec<(f64, f64)>,
    largest: f64,
    end: f64,
    momentum: f64,
}

impl Disks {
    pub(super) fn new(scene: &Scene, setup: &MpmSetup) -> Self {
        Self {
            scene: scene.clone(),
            setup: setup.clone(),
            start: 0.0,
            contact: None,
            kinetic: Vec::new(),
            largest: 0.0,
            end: 0.0,
            momentum: 0.0,
        }
    }
}

impl Watch for Disks {
    fn steps(&self) -> u64 {
        step_at(&self.scene, 3.5)
    }

    fn every(&self) -> u64 {
        1
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        let energy = simulation.energy();
        if simulation.steps() == 0 {
            self.start = energy.kinetic;
        }
        if self.contact.is_none() && energy.kinetic < 0.999 * self.start {
            self.contact = Some(simulation.time());
        }
        if let Some(&time) = TIMES.iter().find(|&&time| step_at(&self.scene, time) == simulation.steps()) {
            self.kinetic.push((time, energy.kinetic));
        }
        self.end = energy.kinetic + energy.elastic;
        self.largest = self.largest.max(self.end);
        let momentum = simulation.totals().momentum;
        self.momentum = self.momentum.max(momentum[0].abs().max(momentum[1].abs()));
    }

    fn findings(&self) -> Vec<Finding> {
        let early = 3.0 * self.setup.dx() / APPROACH;
        let mut findings = vec![
            within(
                "kinetic energy at the start in J".into(),
                self.start,
                EXACT,
                0.04 * EXACT,
                "rho pi R^2 v^2, cut into cells",
            ),
            Finding {
                what: "time of contact in s".into(),
                measured: self.contact.unwrap_or(f64::INFINITY),
                expected: CONTACT,
                least: CONTACT - early,
                most: CONTACT,
                source: "geometry; a spline's support lets them feel each other up to 3 cells apart",
            },
            Finding {
                what: "largest total energy over that at the start".into(),
                measured: self.largest / self.start,
                expected: 1.0,
                least: 0.99,
                most: 1.01,
                source: "conservation",
            },
            within("largest total momentum in kg m/s".into(), self.momentum, 0.0, 1e-3, "conservation"),
        ];
        let cells = 1.0 / self.setup.dx();
        let row = TABLE.iter().find(|row| Some(row.0) == scheme(&self.setup) && (row.1 - cells).abs() < 1e-6);
        if let Some((_, _, kinetic, end)) = row {
            for ((time, measured), expected) in self.kinetic.iter().zip(kinetic) {
                let what = format!("kinetic energy at {time} s over that at the start");
                findings.push(within(what, measured / self.start, expected / EXACT, 0.01, SOURCE));
            }
            let what = "total energy at 3.5 s over that at the start".into();
            findings.push(within(what, self.end / self.start, end / EXACT, 0.01, SOURCE));
        }
        findings
    }
}
