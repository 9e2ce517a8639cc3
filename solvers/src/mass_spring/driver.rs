//! What the laboratory asks of masses and springs in any layouts.

use std::time::Duration;

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::connectivity::Connectivity;
use super::setup::SpringsSetup;
use super::system::{MassSpring, PARTS};
use crate::state::Values;
use crate::{Array, Energy, Scene, SceneError, Simulation, State, StepError, Totals};

/// Masses and springs of a scene, with their clock.
pub(super) struct Driver<M: Layout<I>, C: Connectivity<M>> {
    system: MassSpring<M, C>,
    dimensions: usize,
    size: [f64; 3],
    spacing: f64,
    steps: u64,
}

impl<M: Layout<I>, C: Connectivity<M>> Driver<M, C> {
    pub(super) fn new(scene: &Scene) -> Result<Self, SceneError> {
        let SpringsSetup { size, parameters, masses, springs } = scene.setup()?;
        let system = MassSpring::<M, C>::with(*parameters, masses, springs)
            .map_err(|error| SceneError::new(&*scene.file, error.to_string()))?;
        if let Some(bound) = system.exceeded() {
            let fault = system.explain(&super::system::Fault::Unstable(bound));
            let key = format!("dt = {:e}", scene.dt);
            return Err(scene.fault(key, format!("is unstable: {fault}; or write `unstable = true` to see it")));
        }
        let rests = springs.iter().map(|spring| spring.bond.rest).filter(|rest| *rest > 0.0);
        let least = rests.fold(f64::INFINITY, f64::min);
        let longest = size.iter().copied().fold(0.0, f64::max);
        let spacing = if least.is_finite() { least } else { longest / masses.len() as f64 };
        Ok(Self { system, dimensions: scene.dimensions, size: *size, spacing, steps: 0 })
    }

    /// A vector a mass, of as many components as there are dimensions.
    fn vectors(&self, name: &'static str, of: fn(&super::Mass) -> DVec3) -> Array {
        let components = self.dimensions;
        let values = self.system.masses().iter().flat_map(|mass| {
            let vector = of(&mass).to_array().map(|component| component as f32);
            vector.into_iter().take(components)
        });
        Array::numbers(name, components, values)
    }
}

impl<M: Layout<I>, C: Connectivity<M>> Simulation for Driver<M, C> {
    fn kernel_names(&self) -> &'static [&'static str] {
        &PARTS
    }

    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        let outcome = self.system.step_timed(spent);
        self.steps += 1;
        match outcome {
            Ok(_) => Ok(()),
            Err(fault) => Err(StepError { step: self.steps, message: self.system.explain(&fault) }),
        }
    }

    fn steps(&self) -> u64 {
        self.steps
    }

    fn dt(&self) -> f64 {
        self.system.parameters().dt
    }

    fn time(&self) -> f64 {
        self.steps as f64 * self.dt()
    }

    fn largest_dt(&self) -> Option<f64> {
        self.system.largest_step().filter(|bound| bound.is_finite())
    }

    fn dimensions(&self) -> usize {
        self.dimensions
    }

    fn particles(&self) -> usize {
        self.system.masses().len()
    }

    fn extent(&self) -> [f64; 3] {
        self.size
    }

    fn spacing(&self) -> f64 {
        self.spacing
    }

    fn bytes(&self) -> usize {
        self.system.bytes()
    }

    fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        self.system.memory_maps()
    }

    fn positions(&self) -> Vec<[f64; 3]> {
        self.system.masses().iter().map(|mass| mass.x.to_array()).collect()
    }

    fn velocities(&self) -> Vec<[f64; 3]> {
        self.system.masses().iter().map(|mass| mass.v.to_array()).collect()
    }

    fn links(&self) -> Vec<[u32; 2]> {
        self.system.springs().iter().map(|spring| spring.ends).collect()
    }

    fn particle_arrays(&self) -> Vec<Array> {
        vec![
            self.vectors("position", |mass| mass.x),
            self.vectors("velocity", |mass| mass.v),
            Array::numbers("mass", 1, self.system.masses().iter().map(|mass| mass.mass as f32)),
            Array::whole("fixed", self.system.masses().iter().map(|mass| u32::from(mass.fixed)).collect()),
        ]
    }

    fn save(&self) -> State {
        let doubles = |name, of: fn(&super::Mass) -> DVec3| {
            let values = self.system.masses().iter().flat_map(|mass| of(&mass).to_array()).collect();
            Array { name, components: 3, values: Values::F64(values) }
        };
        let arrays = vec![doubles("position", |mass| mass.x), doubles("velocity", |mass| mass.v)];
        State { steps: self.steps, arrays }
    }

    fn restore(&mut self, state: &State) -> Result<(), String> {
        let vectors = |name| -> Result<Vec<DVec3>, String> {
            let values = state.doubles(name, 3, self.particles())?;
            Ok(values.as_chunks().0.iter().map(|&vector| DVec3::from_array(vector)).collect())
        };
        let (x, v) = (vectors("position")?, vectors("velocity")?);
        self.system.set_motion(&x, &v);
        self.steps = state.steps;
        Ok(())
    }

    fn energy(&self) -> Energy {
        Energy { kinetic: self.system.kinetic_energy(), elastic: self.system.elastic_energy() }
    }

    fn totals(&self) -> Totals {
        let mut totals = Totals { mass: 0.0, momentum: [0.0; 3], angular_momentum: [0.0; 3] };
        let (mut momentum, mut angular) = (DVec3::ZERO, DVec3::ZERO);
        for mass in self.system.masses().iter() {
            let own = mass.v * mass.mass;
            totals.mass += mass.mass;
            momentum += own;
            angular += mass.x.cross(own);
        }
        (totals.momentum, totals.angular_momentum) = (momentum.to_array(), angular.to_array());
        totals
    }
}
