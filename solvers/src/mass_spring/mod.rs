//! Masses joined by springs, in space and in a plane.
//!
//! A spring pulls its two masses together with `f = -k (|d| - l) d / |d|`, where `d` points from the other mass to the
//! one pulled, and its dashpot resists their relative speed along it. Drag, gravity, an attractor and the walls of a box
//! act on each mass by itself.
//!
//! | part | choices | where |
//! | --- | --- | --- |
//! | time | forward and symplectic Euler, the family of `beta` (half implicit and backward Euler), implicit midpoint | [`Integrator`] |
//! | systems of implicit steps | conjugate gradients, Jacobi's iteration, both without a matrix | [`StepMatrix`], [`linear`](crate::linear) |
//! | who is joined | a dense or sparse table of all pairs, a list a mass, one list of springs | [`connectivity`] |
//!
//! Everything is computed in double precision and with three components: what is in a plane stays in it, to the bit.
//! Explicit steps beyond their bound of stability are refused with the bound ([`largest_step`]).
//!
//! Sources: Baraff & Witkin 1998, "Large steps in cloth simulation" (implicit steps, the derivative of forces); Choi & Ko
//! 2002, "Stable but responsive cloth" (what keeps the matrix positive); Liu et al. 2013, "Fast simulation of mass-spring
//! systems".

pub mod connectivity;
mod driver;
mod gates;
mod implicit;
mod kernels;
mod layouts;
mod parameters;
mod records;
mod scenes;
mod setup;
mod stability;
mod system;
mod topology;

use crate::SolverInfo;

pub use connectivity::{Connectivity, List, Matrix, Rows};
pub use implicit::StepMatrix;
pub use parameters::{Attractor, Integrator, Method, Parameters};
pub use records::{Bond, Link, Mass, Rates, Spring};
pub use setup::SpringsSetup;
pub use stability::largest_step;
pub use system::{MassSpring, Refused};
pub use topology::EditError;

pub(crate) const SOLVER: SolverInfo = SolverInfo {
    name: "springs",
    about: "masses joined by springs, in explicit and implicit steps, in 2D and 3D",
    dimensions: 2..=3,
    keys: setup::KEYS,
    read: setup::read,
    scenes: scenes::SCENES,
    layouts: layouts::LAYOUTS,
    unfit: layouts::unfit,
    build: layouts::build,
};
