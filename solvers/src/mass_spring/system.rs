//! Masses and springs in some layouts, advanced a step at a time.

use std::time::{Duration, Instant};

use allotrope::MemoryMap;
use allotrope::prelude::*;

use super::connectivity::Connectivity;
use super::implicit::{self, Work};
use super::kernels::{self, Motion};
use super::parameters::Parameters;
use super::records::{Bond, Mass, Spring};
use super::stability::largest_step;
use super::topology::{EditError, check_masses, check_springs, pairs_within};
use crate::linear::Report;

/// The parts of a step, in the order of times in [`MassSpring::step_timed`].
pub(super) const PARTS: [&str; 3] = ["springs", "solve", "masses"];

/// Masses in the layout `M` and springs in the connectivity `C`, advanced a step at a time. All is in space; in a plane
/// third components stay zero.
///
/// Masses and springs may be added between steps.
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope_solvers::mass_spring::{Bond, List, Mass, MassSpring, Parameters};
/// let mut system = MassSpring::<Aos, List>::new(Parameters::default()).unwrap();
/// let mass = |x, y, fixed| Mass { x: dvec3(x, y, 0.0), mass: 1.0, fixed, ..Mass::default() };
/// system.add_masses(&[mass(0.3, 0.3, true), mass(0.3, 0.4, false), mass(0.4, 0.4, false)]).unwrap();
/// // Joins what is nearer than 0.15 m; the diagonal, too.
/// system.connect_within(0.15, 0, Bond { stiffness: 1e4, rest: 0.1, dashpot: 10.0 }).unwrap();
/// assert_eq!(system.springs().len(), 3);
/// (0..1000).for_each(|_| _ = system.step().unwrap());
/// assert!((system.mass(1).x.distance(system.mass(2).x) - 0.1).abs() < 1e-3);
/// ```
#[derive(Debug)]
pub struct MassSpring<M: Layout<I>, C: Connectivity<M>> {
    parameters: Parameters,
    masses: Field<Mass, M>,
    /// All springs, from which the connectivity is made.
    springs: Vec<Spring>,
    connectivity: C,
    work: Work,
    largest_step: Option<f64>,
}

/// Why a step was refused, or came to nothing.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Fault {
    /// It is longer than this bound.
    Unstable(f64),
    /// So many masses are not finite.
    NotFinite(u32),
    /// The system of an implicit step was not solved, and nothing has moved.
    Solve(crate::linear::SolveError),
}

/// Why a step was refused, or came to nothing: what is wrong, and the cure.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused(String);

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Refused {}

impl<M: Layout<I>, C: Connectivity<M>> MassSpring<M, C> {
    /// Without masses.
    ///
    /// # Errors
    /// If memory is refused.
    pub fn new(parameters: Parameters) -> Result<Self, EditError> {
        Self::with(parameters, &[], &[])
    }

    /// With these masses and springs.
    ///
    /// # Errors
    /// If something of a mass or spring makes no sense, two springs join the same masses, or there is no room.
    pub fn with(parameters: Parameters, masses: &[Mass], springs: &[Spring]) -> Result<Self, EditError> {
        check_masses(masses)?;
        check_springs(masses.len(), &[], springs)?;
        Self::build(parameters, masses, springs.to_vec())
    }

    fn build(parameters: Parameters, masses: &[Mass], springs: Vec<Spring>) -> Result<Self, EditError> {
        if masses.len() > C::MOST_MASSES {
            let most = C::MOST_MASSES;
            return Err(EditError::Room(format!("{} masses are more than the {most} of this layout", masses.len())));
        }
        let room = |fault: allotrope::ShapeError| EditError::Room(fault.to_string());
        let mut field = Field::<Mass, M>::try_new([masses.len()]).map_err(room)?;
        masses.iter().enumerate().for_each(|(n, &mass)| field.set(n, Mass { f: DVec3::ZERO, ..mass }));
        Ok(Self {
            masses: field,
            connectivity: C::new(masses.len(), &springs).map_err(EditError::Room)?,
            work: Work::new(if parameters.integrator.is_explicit() { 0 } else { masses.len() })
                .map_err(EditError::Room)?,
            largest_step: largest_step(masses, &springs, &parameters),
            springs,
            parameters,
        })
    }

    /// Adds masses behind those that there are.
    ///
    /// # Errors
    /// If something of a mass makes no sense, or there is no room; then nothing is changed.
    pub fn add_masses(&mut self, masses: &[Mass]) -> Result<(), EditError> {
        check_masses(masses)?;
        let all: Vec<Mass> = self.masses.iter().chain(masses.iter().copied()).collect();
        *self = Self::build(self.parameters, &all, self.springs.clone())?;
        Ok(())
    }

    /// Adds springs between masses that there are.
    ///
    /// # Errors
    /// If something of a spring makes no sense, its masses are joined already, or there is no room; then nothing is
    /// changed.
    pub fn add_springs(&mut self, springs: &[Spring]) -> Result<(), EditError> {
        check_springs(self.masses.len(), &self.springs, springs)?;
        let masses: Vec<Mass> = self.masses.iter().collect();
        *self = Self::build(self.parameters, &masses, [&self.springs, springs].concat())?;
        Ok(())
    }

    /// Joins the masses from `first` on with all others nearer than `radius` in m that they are not joined with, and
    /// tells how many springs were added.
    ///
    /// # Errors
    /// If the bond makes no sense, or there is no room; then nothing is changed.
    pub fn connect_within(&mut self, radius: f64, first: usize, bond: Bond) -> Result<usize, EditError> {
        let springs = springs_within(&self.positions(), &self.springs, first, radius, |_| bond);
        self.add_springs(&springs)?;
        Ok(springs.len())
    }

    /// Advances by one step; tells of the solution of an implicit one.
    ///
    /// # Errors
    /// If the step is longer than an explicit integrator bears (with the bound; nothing has moved), a mass is not finite
    /// after it, or the system of an implicit step is not solved (nothing has moved).
    pub fn step(&mut self) -> Result<Option<Report>, Refused> {
        self.step_timed(&mut [Duration::ZERO; PARTS.len()]).map_err(|fault| Refused(self.explain(&fault)))
    }

    /// The same, and adds the times of its parts.
    pub(super) fn step_timed(&mut self, spent: &mut [Duration]) -> Result<Option<Report>, Fault> {
        if let Some(bound) = self.exceeded() {
            return Err(Fault::Unstable(bound));
        }
        let mut last = Instant::now();
        let mut lap = |part: usize| {
            let now = Instant::now();
            spent[part] += now - last;
            last = now;
        };
        let motion = Motion::new(&self.parameters);
        self.connectivity.add_forces(&mut self.masses);
        lap(0);
        let (broken, report) = if self.parameters.integrator.is_explicit() {
            (kernels::advance(&mut self.masses, &motion), None)
        } else {
            let report =
                implicit::solve(&mut self.masses, &self.connectivity, &self.parameters, &motion, &mut self.work)
                    .map_err(Fault::Solve)?;
            lap(1);
            (implicit::advance(&mut self.masses, &motion, &self.work), Some(report))
        };
        lap(2);
        if broken == 0 { Ok(report) } else { Err(Fault::NotFinite(broken)) }
    }

    /// The bound that the step is beyond, if it is not to be.
    pub(super) fn exceeded(&self) -> Option<f64> {
        self.largest_step.filter(|&bound| !self.parameters.unstable && self.parameters.dt > bound)
    }

    /// A fault in words.
    pub(super) fn explain(&self, fault: &Fault) -> String {
        let dt = self.parameters.dt;
        match fault {
            Fault::Unstable(0.0) => {
                "forward Euler is stable with no step where a spring has no dashpot: energy grows by \
                                     1 + (w dt)^2 a step; take symplectic Euler"
                    .into()
            }
            Fault::Unstable(bound) => {
                format!(
                    "steps of {dt:e} s are beyond the bound of stability, {bound:.3e} s; make `dt` smaller, or take an implicit integrator"
                )
            }
            Fault::NotFinite(count) => {
                let sound = |mass: &Mass| (mass.x + mass.v).is_finite();
                let first = self.masses.iter().position(|mass| !sound(&mass)).unwrap_or(0);
                let others = if *count > 1 { format!(", and {} others", count - 1) } else { String::new() };
                format!("mass {first} is not finite{others}; make `dt = {dt:e}` smaller")
            }
            Fault::Solve(error) => format!("the implicit step was not solved: {error}"),
        }
    }

    /// The longest stable step in s, if the integrator is explicit (see [`largest_step`]).
    pub fn largest_step(&self) -> Option<f64> {
        self.largest_step
    }

    /// How time runs, and what acts on masses.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Changes how time runs, and what acts on masses.
    ///
    /// # Errors
    /// If memory is refused; then nothing is changed.
    pub fn set_parameters(&mut self, parameters: Parameters) -> Result<(), EditError> {
        let masses: Vec<Mass> = self.masses.iter().collect();
        *self = Self::build(parameters, &masses, self.springs.clone())?;
        Ok(())
    }

    /// The masses.
    pub fn masses(&self) -> &Field<Mass, M> {
        &self.masses
    }

    /// A mass.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn mass(&self, number: usize) -> Mass {
        self.masses.get(number)
    }

    /// Replaces a mass.
    ///
    /// # Errors
    /// If it makes no sense.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn set_mass(&mut self, number: usize, mass: Mass) -> Result<(), EditError> {
        check_masses(&[mass])?;
        self.masses.set(number, Mass { f: DVec3::ZERO, ..mass });
        let masses: Vec<Mass> = self.masses.iter().collect();
        self.largest_step = largest_step(&masses, &self.springs, &self.parameters);
        Ok(())
    }

    /// Positions in m.
    pub fn positions(&self) -> Vec<DVec3> {
        self.masses.members().x.to_vec()
    }

    /// Sets where the masses are and how they move; what they weigh and whether they are held stays.
    pub(super) fn set_motion(&mut self, x: &[DVec3], v: &[DVec3]) {
        let mut members = self.masses.members_mut();
        members.x.copy_from_slice(x);
        members.v.copy_from_slice(v);
    }

    /// The springs, in the order in which they were added.
    pub fn springs(&self) -> &[Spring] {
        &self.springs
    }

    /// The springs in their layout.
    pub fn connectivity(&self) -> &C {
        &self.connectivity
    }

    /// Energy of motion in J.
    pub fn kinetic_energy(&self) -> f64 {
        self.masses.iter().map(|mass| 0.5 * mass.mass * mass.v.length_squared()).sum()
    }

    /// Energy of springs in J, `k (|d| - rest)^2 / 2` each.
    pub fn elastic_energy(&self) -> f64 {
        let x = self.positions();
        let energy = |spring: &Spring| {
            let [a, b] = spring.ends.map(|end| x[end as usize]);
            0.5 * spring.bond.stiffness * (a.distance(b) - spring.bond.rest).powi(2)
        };
        self.springs.iter().map(energy).sum()
    }

    /// Bytes of all fields.
    pub fn bytes(&self) -> usize {
        self.masses.bytes() + self.connectivity.bytes() + self.work.bytes()
    }

    /// Where the records of masses and of what joins them lie.
    pub fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        vec![("masses", self.masses.memory_map()), self.connectivity.memory_map()]
    }
}

/// Springs between the masses from `first` on and all others nearer than `radius` that are not joined yet, `bond` of the
/// distance each.
pub(super) fn springs_within(
    x: &[DVec3],
    old: &[Spring],
    first: usize,
    radius: f64,
    bond: impl Fn(f64) -> Bond,
) -> Vec<Spring> {
    let pair = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let joined: std::collections::HashSet<[u32; 2]> = old.iter().map(|spring| pair(spring.ends)).collect();
    let new = pairs_within(x, first, radius).into_iter().filter(|&ends| !joined.contains(&pair(ends)));
    new.map(|ends| Spring { ends, bond: bond(x[ends[0] as usize].distance(x[ends[1] as usize])) }).collect()
}
