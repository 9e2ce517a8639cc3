//! Weakly compressible smoothed particle hydrodynamics, in a plane and in space (Monaghan 1994; Becker & Teschner 2007).
//!
//! Density follows the particles, pressure follows density by an equation of state so stiff that density hardly changes, and
//! particles are pushed from where pressure is high. Time runs in explicit steps, velocities first and positions with them
//! (symplectic Euler), which are as long as forces and sound allow ([`TimeStep`]).
//!
//! | part | choices | where |
//! | --- | --- | --- |
//! | density | summation, the continuity equation | [`Density`] |
//! | equation of state | Tait's, a gas' | [`State`] |
//! | viscosity | Monaghan 1989, Becker & Teschner 2007 | [`Fluid::viscosity`] |
//! | walls | volumes (Akinci et al. 2012), repulsion (Monaghan 2005) | [`Boundary`] |
//! | surface tension | Becker & Teschner 2007 | [`kernels::accelerate`] |
//! | neighbours | in four ways | [`neighbours`](super::neighbours) |
//!
//! The kernels are written once, against members and a way of finding neighbours; the layouts in which they are compiled
//! stand in one list.

mod clock;
mod driver;
mod fluid;
mod gates;
pub mod kernels;
mod layouts;
mod medium;
mod records;
mod scenes;
mod setup;
mod walls;

use crate::SolverInfo;

pub use clock::{Extremes, TimeStep};
pub use fluid::{Boundary, Fluid};
pub use medium::{Density, Fault, Medium, Part};
pub use records::{Particle, WallParticle};
pub use setup::{State, Water, WcsphSetup};
pub use walls::Walls;

pub(crate) const SOLVER: SolverInfo = SolverInfo {
    name: "wcsph",
    about: "weakly compressible smoothed particle hydrodynamics for fluids in 2D and 3D",
    dimensions: 2..=3,
    keys: setup::KEYS,
    read: setup::read,
    scenes: scenes::SCENES,
    layouts: layouts::LAYOUTS,
    unfit: layouts::unfit,
    build: layouts::build,
};
