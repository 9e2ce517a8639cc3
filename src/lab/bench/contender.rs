//! What is compared, while it runs, and whether all end alike.

use std::time::{Duration, Instant};

use allotrope::Schedule;
use allotrope_solvers::{Scene, Simulation, SolverInfo};

use crate::lab::errors::LabError;
use crate::lab::hardware::{Counted, Counters};
use crate::lab::machine::NamedSchedule;

/// A layout with a schedule, while it runs.
pub(in crate::lab) struct Contender {
    pub(in crate::lab) layout: &'static str,
    pub(in crate::lab) named: NamedSchedule,
    schedule: Schedule,
    pub(in crate::lab) simulation: Box<dyn Simulation>,
    /// Milliseconds a step of each repetition, without sorting.
    pub(in crate::lab) samples: Vec<f64>,
    /// The same in each kernel.
    pub(in crate::lab) kernels: Vec<Vec<f64>>,
    /// Steps that were taken, also before the first repetition.
    taken: u64,
    /// The time that sorting took in them: sorts are rare, so that it is spread over all.
    sorting: Duration,
    /// What processor and system counted in all repetitions, if they were asked.
    counted: Option<Counted>,
    repeated: u64,
}

/// The part of a step that most steps do not have.
pub(in crate::lab) const SORT: &str = "sort";

impl Contender {
    /// A scene in a layout, at its start.
    ///
    /// # Errors
    /// If it cannot be built.
    pub(in crate::lab) fn new(
        solver: &SolverInfo,
        scene: &Scene,
        layout: &'static str,
        named: NamedSchedule,
        threads: Option<usize>,
    ) -> Result<Self, LabError> {
        let simulation = (solver.build)(scene, layout)?;
        Ok(Self {
            layout,
            named,
            schedule: named.with_threads(threads),
            samples: Vec::new(),
            kernels: vec![Vec::new(); simulation.kernel_names().len()],
            simulation,
            taken: 0,
            sorting: Duration::ZERO,
            counted: None,
            repeated: 0,
        })
    }

    /// Takes some steps; gives their time, and that in each kernel, without sorting.
    pub(in crate::lab) fn advance(&mut self, steps: u64) -> Result<(Duration, Vec<Duration>), LabError> {
        let Self { simulation, schedule, layout, named, taken, sorting, .. } = self;
        let mut spent = vec![Duration::ZERO; simulation.kernel_names().len()];
        let start = Instant::now();
        let done = schedule.run(|| (0..steps).try_for_each(|_| simulation.step_timed(&mut spent)));
        done.map_err(|error| LabError::failure(format!("{layout} with schedule {}: {error}", named.name)))?;
        let elapsed = start.elapsed();
        let sort = simulation.kernel_names().iter().position(|&name| name == SORT);
        let sorted = sort.map_or(Duration::ZERO, |sort| std::mem::take(&mut spent[sort]));
        *taken += steps;
        *sorting += sorted;
        Ok((elapsed.saturating_sub(sorted), spent))
    }

    /// Takes some steps; gives their time, sorting included.
    pub(in crate::lab) fn advance_with_sorts(&mut self, steps: u64) -> Result<Duration, LabError> {
        let before = self.sorting;
        let (time, _) = self.advance(steps)?;
        Ok(time + (self.sorting - before))
    }

    /// What processor and system counted a step.
    pub(in crate::lab) fn counted(&self) -> Vec<(String, f64)> {
        self.counted.as_ref().map_or_else(Vec::new, |counted| counted.per(self.repeated))
    }

    /// Milliseconds of sorting a step.
    pub(in crate::lab) fn sorting(&self) -> f64 {
        self.sorting.as_secs_f64() * 1e3 / self.taken.max(1) as f64
    }

    /// Takes some steps as one repetition, in which counters count.
    pub(in crate::lab) fn repeat(&mut self, steps: u64, counters: Option<&mut Counters>) -> Result<(), LabError> {
        let (time, spent) = match counters {
            None => self.advance(steps)?,
            Some(counters) => {
                let (done, counted) = counters.count(|| self.advance(steps));
                match &mut self.counted {
                    Some(all) => all.add(&counted),
                    none => *none = Some(counted),
                }
                done?
            }
        };
        self.repeated += steps;
        let each = |time: Duration| time.as_secs_f64() * 1e3 / steps as f64;
        self.samples.push(each(time));
        for (samples, time) in self.kernels.iter_mut().zip(spent) {
            samples.push(each(time));
        }
        Ok(())
    }
}

/// Checks that all contenders are in the state of the first: the order of additions alone may differ, which leaves
/// positions within some roundings of the domain's extent. Gives the largest difference.
pub(in crate::lab) fn verify<'c>(
    contenders: impl IntoIterator<Item = &'c Contender>,
    steps: u64,
) -> Result<f64, LabError> {
    let mut contenders = contenders.into_iter();
    let Some(first) = contenders.next() else { return Ok(0.0) };
    let reference = first.simulation.positions();
    let extent = first.simulation.extent().into_iter().fold(0.0, f64::max);
    let bound = 1e-5 * extent;
    let mut largest = 0.0f64;
    for contender in contenders {
        let (error, particle) = difference(&reference, &contender.simulation.positions());
        if error.is_nan() || error > bound {
            return Err(LabError::failure(format!(
                "after {steps} steps {} with schedule {} is in another state than {}: particle {particle} differs by \
                 {error:.3e}, above {bound:.3e}",
                contender.layout, contender.named.name, first.layout
            )));
        }
        largest = largest.max(error);
    }
    Ok(largest)
}

/// The largest difference along an axis, and the particle that has it. What is not a number differs most.
pub(in crate::lab) fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> (f64, usize) {
    let mut largest = (0.0, 0);
    for (particle, (a, b)) in a.iter().zip(b).enumerate() {
        for (a, b) in a.iter().zip(b) {
            let error = (a - b).abs();
            if error.is_nan() || error > largest.0 {
                largest = (error, particle);
            }
            if error.is_nan() {
                return largest;
            }
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_find_the_farthest_particle_and_what_is_not_a_number() {
        let a = [[0.0; 3], [1.0, 2.0, 3.0]];
        assert_eq!(difference(&a, &[[0.0; 3], [1.0, 2.5, 3.0]]), (0.5, 1));
        assert_eq!(difference(&a, &a).0, 0.0);
        assert!(difference(&a, &[[f64::NAN, 0.0, 0.0], [9.0; 3]]).0.is_nan());
    }
}
