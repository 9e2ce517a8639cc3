//! Masses joined by springs, in space and in a plane.
//!
//! # Equations
//!
//! A spring of stiffness `k`, length at rest `l` and dashpot `c` between two masses pulls the first with
//!
//! ```text
//! f = -(k (|d| - l) + c u.n) n,      n = d / |d|,
//! ```
//!
//! where `d` and `u` are position and velocity of the first less those of the second, and the second with `-f`
//! ([`Bond::force`]). Gravity `g` and an attractor at `a` accelerate each mass by `g - s (x - a)`; drag multiplies
//! velocities by `exp(-dt drag)` after each step; the walls of a box stop what goes through them.
//!
//! With the mass matrix `M` and the springs' derivatives `K = df/dx` and `C = df/dv`, a step of `dt` is
//!
//! | [`Integrator`] | step | order | energy of an oscillation, `z = w dt` |
//! | --- | --- | --- | --- |
//! | `ForwardEuler` | `x' = x + dt v`, `v' = v + dt M^-1 f` | 1 | grows by `1 + z^2` a step |
//! | `SymplecticEuler` | `v' = v + dt M^-1 f`, `x' = x + dt v'` | 1 | stays within `z` for `z < 2` |
//! | `Beta(b)` | `[M - b dt^2 K] v' = M v + dt f`, `x' = x + dt v'` | 1 | falls by `1 / (1 + b z^2)` a step |
//! | `ImplicitMidpoint` | `[M - dt^2/4 K] v' = M v + dt f + dt^2/4 K v`, `x' = x + dt/2 (v + v')` | 2 | stays |
//!
//! `Beta(1.0)` is backward Euler; `Beta(0.5)`, which some call the midpoint, takes the force half a step ahead, and is
//! none. Dashpots join the matrix as `- b dt C`, of the midpoint as `- dt/2 C`. Systems are solved for `v' - v`, in the
//! form with `M`, which is symmetric for any masses, by conjugate gradients or Jacobi's iteration, without the matrix
//! ([`StepMatrix`], [`linear`](crate::linear)). The derivative of a spring is
//!
//! ```text
//! K = -k ((1 - l / |d|) (I - n n^T) + n n^T),
//! ```
//!
//! the first term left out where the spring is compressed, so that the matrix is positive definite
//! ([`Bond::resistance`]). Explicit steps beyond their bound of stability are refused with the bound ([`largest_step`]).
//!
//! Sources: Baraff & Witkin 1998, "Large steps in cloth simulation" (equations 6 and 15, implicit steps; section 4, the
//! derivatives); Choi & Ko 2002, "Stable but responsive cloth" (compressed springs); Liu et al. 2013, "Fast simulation of
//! mass-spring systems"; Hairer, Lubich & Wanner 2006, "Geometric numerical integration" (symplectic Euler, midpoint).
//!
//! # Layouts
//!
//! Masses lie in any layout of one axis, springs in one of four connectivities ([`connectivity`]): a dense or a sparse
//! table of all pairs, a list a mass, one list of all springs. The sums over springs are the same.
//!
//! Everything is computed in double precision and with three components: what is in a plane stays in it, to the bit.

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
