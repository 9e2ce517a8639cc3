//! The matrix of an implicit step, without the matrix, and the step.

use std::marker::PhantomData;

use allotrope::prelude::*;

use super::connectivity::{Connectivity, Vectors};
use super::kernels::{self, Motion};
use super::parameters::{Method, Parameters};
use super::records::{Mass, Rates};
use crate::linear::{Operator, Report, SolveError, Vector, conjugate_gradients, jacobi};

/// The matrix `M - a df/dx - b df/dv` of masses and springs as they stand, with the rows of fixed masses those of `M`
/// alone. It is symmetric for any masses; divided by `M` it is the matrix `I - a M^-1 df/dx - ..` of the same system,
/// which is so for equal masses alone.
#[derive(Debug)]
pub struct StepMatrix<'a, M: Layout<I>, C> {
    masses: &'a Field<Mass, M>,
    connectivity: &'a C,
    rates: Rates,
    /// `a` times the strength of the attractor.
    pull: f64,
    marker: PhantomData<M>,
}

impl<'a, M: Layout<I>, C: Connectivity<M>> StepMatrix<'a, M, C> {
    /// The matrix of the step that these parameters make.
    pub fn new(masses: &'a Field<Mass, M>, connectivity: &'a C, parameters: &Parameters) -> Self {
        let rates = parameters.integrator.implicit(parameters.dt).matrix;
        let pull = rates.stiffness * parameters.attractor.strength;
        Self { masses, connectivity, rates, pull, marker: PhantomData }
    }
}

impl<M: Layout<I>, C: Connectivity<M>> Operator for StepMatrix<'_, M, C> {
    type Value = DVec3;
    type Axes = I;
    type Layout = Aos;

    fn apply(&self, x: &Vector<Self>, y: &mut Vector<Self>) -> f64 {
        kernels::clear(y);
        self.connectivity.add_resistance(self.masses, x, y, self.rates);
        kernels::add_inertia(self.masses, x, y, self.pull)
    }

    fn diagonal(&self, diagonal: &mut Vector<Self>) {
        kernels::clear(diagonal);
        self.connectivity.add_diagonal(self.masses, diagonal, self.rates);
        kernels::add_inertia_to_diagonal(self.masses, diagonal, self.pull);
    }
}

/// The vectors of a step, kept for the next one.
#[derive(Debug)]
pub(super) struct Work {
    /// The right-hand side.
    b: Vectors,
    /// The change of velocity.
    change: Vectors,
}

impl Work {
    pub(super) fn new(masses: usize) -> Result<Self, String> {
        let vectors = || Field::<DVec3, Aos>::try_new([masses]).map_err(|fault| fault.to_string());
        Ok(Self { b: vectors()?, change: vectors()? })
    }

    pub(super) fn bytes(&self) -> usize {
        self.b.bytes() + self.change.bytes()
    }
}

/// Solves for the change of velocity, with the forces that are there, which are then zero.
pub(super) fn solve<M: Layout<I>, C: Connectivity<M>>(
    masses: &mut Field<Mass, M>,
    connectivity: &C,
    parameters: &Parameters,
    motion: &Motion,
    work: &mut Work,
) -> Result<Report, SolveError> {
    let Work { b, change } = work;
    let right = parameters.integrator.implicit(parameters.dt).right;
    kernels::velocities(masses, b);
    kernels::clear(change);
    connectivity.add_resistance(masses, b, change, Rates { stiffness: right, damping: 0.0 });
    kernels::right_hand_side(masses, change, b, right, motion);
    kernels::clear(change);
    let matrix = StepMatrix::new(masses, connectivity, parameters);
    match parameters.method {
        Method::ConjugateGradients => conjugate_gradients(&matrix, b, change, &parameters.stop),
        Method::Jacobi(damping) => jacobi(&matrix, b, change, damping, &parameters.stop),
    }
}

/// The step that the last solution makes. Tells how many masses are not finite.
pub(super) fn advance<M: Layout<I>>(masses: &mut Field<Mass, M>, motion: &Motion, work: &Work) -> u32 {
    kernels::advance_by(masses, &work.change, motion)
}
