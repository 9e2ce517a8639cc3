//! What the laboratory asks of every simulation.

use std::fmt;
use std::time::Duration;

use allotrope::MemoryMap;

use crate::state::{Array, Energy, State};

/// A simulation in some layout, advanced a step at a time. Schedules are given from outside: `schedule.run(||
/// simulation.step())`.
pub trait Simulation: Send {
    /// The parts of a step whose times [`step_timed`](Self::step_timed) tells apart.
    fn kernel_names(&self) -> &'static [&'static str];

    /// Advances by one step and adds the time of each part to `spent`, which is as long as
    /// [`kernel_names`](Self::kernel_names).
    ///
    /// # Errors
    /// Where the step would be meaningless: something is not finite, or moves more than a cell.
    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError>;

    /// Advances by one step.
    ///
    /// # Errors
    /// As [`step_timed`](Self::step_timed).
    fn step(&mut self) -> Result<(), StepError> {
        let mut spent = vec![Duration::ZERO; self.kernel_names().len()];
        self.step_timed(&mut spent)
    }

    /// Steps done.
    fn steps(&self) -> u64;

    /// Seconds of the last step; before the first, those that it is to take, at most.
    fn dt(&self) -> f64;

    /// Simulated seconds.
    fn time(&self) -> f64;

    /// The longest step in s that would be stable now, where it is known.
    fn largest_dt(&self) -> Option<f64> {
        None
    }

    /// What a step must not be longer than, in s, as of the last step, each bound by the name of what sets it; empty where steps do not
    /// follow from such bounds.
    fn step_bounds(&self) -> Vec<(&'static str, f64)> {
        Vec::new()
    }

    /// From 1 to 3.
    fn dimensions(&self) -> usize;

    /// Number of particles.
    fn particles(&self) -> usize;

    /// Nodes along each axis; empty, if there is no grid.
    fn grid_shape(&self) -> Vec<usize> {
        Vec::new()
    }

    /// Metres along each axis (zero along axes that the simulation does not have).
    fn extent(&self) -> [f64; 3];

    /// Metres from each border to the wall that holds the particles.
    fn margin(&self) -> f64 {
        0.0
    }

    /// Metres between neighbouring particles at rest.
    fn spacing(&self) -> f64;

    /// Bytes of all fields.
    fn bytes(&self) -> usize;

    /// Where in memory the records of its fields lie, those whose layout was chosen, each by the field's name; empty, where that cannot be told.
    fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        Vec::new()
    }

    /// Positions in metres, in the order in which the particles were given, whatever order they lie in now.
    fn positions(&self) -> Vec<[f64; 3]>;

    /// Velocities in metres a second, in the same order.
    fn velocities(&self) -> Vec<[f64; 3]>;

    /// Which particles are joined, by their numbers in the same order, such as by a spring; each pair once.
    fn links(&self) -> Vec<[u32; 2]> {
        Vec::new()
    }

    /// What the particles hold, for pictures and files, in the same order: `position` and `velocity` (as many components
    /// as there are dimensions), and whatever else the solver has, such as `pressure` in Pa and `material` (its number
    /// in the scene).
    fn particle_arrays(&self) -> Vec<Array>;

    /// What the grid holds after the last step, in row-major order, the last axis fastest: `mass` in kg and `velocity`;
    /// empty, if there is no grid.
    fn grid_arrays(&self) -> Vec<Array> {
        Vec::new()
    }

    /// The names of the materials; empty, if there are none to tell apart.
    fn materials(&self) -> Vec<String> {
        Vec::new()
    }

    /// Of which material each particle is, in the same order as positions.
    fn material_of(&self) -> Vec<u32> {
        vec![0; self.particles()]
    }

    /// Pressure in Pa (the mean of the normal stresses, compression positive), in the same order; empty, if particles
    /// have none.
    fn pressures(&self) -> Vec<f64> {
        Vec::new()
    }

    /// All that the next step depends on.
    fn save(&self) -> State;

    /// Goes on from a saved state of the same scene in the same layout.
    ///
    /// # Errors
    /// If an array is missing, or has another length; then nothing is changed.
    fn restore(&mut self, state: &State) -> Result<(), String>;

    /// Energies of the particles.
    fn energy(&self) -> Energy;

    /// Conserved totals of the particles, summed in `f64`.
    fn totals(&self) -> Totals;

    /// The mass that the last step spread over the grid, summed in `f64`, if there is a grid.
    fn grid_mass(&self) -> Option<f64> {
        None
    }
}

/// Conserved totals of the particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Totals {
    /// kg (in 2D, of a slab one metre thick).
    pub mass: f64,
    /// kg m/s.
    pub momentum: [f64; 3],
    /// kg m^2/s about the origin, the affine part of the velocity included. In 2D the last component alone is used.
    pub angular_momentum: [f64; 3],
}

/// Why a step was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct StepError {
    /// The step, counted from one.
    pub step: u64,
    /// What is wrong, where, and the cure.
    pub message: String,
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stopped at step {}: {}", self.step, self.message)
    }
}

impl std::error::Error for StepError {}
