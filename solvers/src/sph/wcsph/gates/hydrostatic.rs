//! Pressure in water at rest.

use super::{MOST_STEPS, WcsphSetup, corners, within};
use crate::scene::Body;
use crate::{Finding, Scene, Simulation, Watch};

const SOURCE: &str = "p = rho g (H - y); the tank is that of Adami, Hu & Adams 2012";

/// From when on, and until when, in s, pressure is averaged.
const FROM: f64 = 1.9;
const UNTIL: f64 = 2.0;

/// Layers of the water that are told apart.
const LAYERS: usize = 9;

/// How far from the exact pressure passes, as a share of that at the bottom.
const SHARE: f64 = 0.05;

pub(super) struct Hydrostatic {
    depth: f64,
    weight: f64,
    /// Of each layer, how many particles were seen, and the sums of their heights and pressures.
    layers: [(f64, f64, f64); LAYERS],
}

impl Hydrostatic {
    pub(super) fn new(scene: &Scene, setup: &WcsphSetup, body: &Body) -> Self {
        let (from, to) = corners(body);
        let weight = setup.fluid.density * scene.gravity[1].abs();
        Self { depth: to[1] - from[1], weight, layers: [(0.0, 0.0, 0.0); LAYERS] }
    }
}

impl Watch for Hydrostatic {
    fn steps(&self) -> u64 {
        MOST_STEPS
    }

    fn until(&self) -> Option<f64> {
        Some(UNTIL)
    }

    fn every(&self) -> u64 {
        8
    }

    fn look(&mut self, simulation: &dyn Simulation) {
        if simulation.time() < FROM {
            return;
        }
        for (x, pressure) in simulation.positions().iter().zip(simulation.pressures()) {
            let layer = (x[1] / self.depth * LAYERS as f64).clamp(0.0, LAYERS as f64 - 1.0);
            let (count, heights, pressures) = &mut self.layers[layer as usize];
            *count += 1.0;
            *heights += x[1];
            *pressures += pressure;
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let mean = |(count, heights, pressures): (f64, f64, f64)| (heights / count, pressures / count);
        let tolerance = SHARE * self.weight * self.depth;
        let mut findings: Vec<Finding> = Vec::new();
        for (height, measured) in self.layers.map(mean) {
            let expected = self.weight * (self.depth - height);
            let what = format!("pressure around {height:.3} m, in Pa");
            let (least, most) = (expected - tolerance, expected + tolerance);
            findings.push(Finding { what, measured, expected, least, most, source: SOURCE });
        }
        // The line through all layers but those at the bottom and the surface tells the pressure at the bottom.
        let inner: Vec<_> = self.layers[1..LAYERS - 1].iter().map(|layer| mean(*layer)).collect();
        let n = inner.len() as f64;
        let (y, p) = (inner.iter().map(|at| at.0).sum::<f64>() / n, inner.iter().map(|at| at.1).sum::<f64>() / n);
        let spread: f64 = inner.iter().map(|at| (at.0 - y).powi(2)).sum();
        let slope = inner.iter().map(|at| (at.0 - y) * (at.1 - p)).sum::<f64>() / spread;
        let bottom = self.weight * self.depth;
        findings.push(within("pressure at the bottom, in Pa".into(), p - slope * y, bottom, SHARE, SOURCE));
        findings
    }
}
