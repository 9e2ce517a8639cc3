//! The material point method for a weakly compressible fluid, in a plane and in space.
//!
//! MLS-MPM (Hu et al. 2018) with quadratic B-splines and the affine transfer of APIC (Jiang et al. 2015): mass and
//! momentum are scattered from particles to a grid, which gravity and walls act on; then velocity and its gradient are
//! gathered back, and the particles move. Pressure is `E (1 - j)`, where `j`, a particle's volume over that at rest,
//! follows the divergence.
//!
//! The kernels are written once, against members; the layouts in which they are compiled stand in one list.
//! Sorting the particles by cell now and then (`reorder` of a scene) changes neither the algorithm nor the order in
//! which positions are told.

mod driver;
mod fluid;
mod fluid_2d;
mod fluid_3d;
pub mod kernels_2d;
pub mod kernels_3d;
mod layouts;
pub mod materials;
mod parameters;
mod records;
mod scenes;
mod stability;

use crate::SolverInfo;

pub use fluid::block_major;
pub use parameters::{Mpm, quadratic_weights};
pub use records::{Node2, Node3, Point2, Point3};
pub use stability::largest_step;

pub(crate) const SOLVER: SolverInfo = SolverInfo {
    name: "mpm",
    about: "the material point method for a weakly compressible fluid in 2D and 3D (MLS-MPM, APIC, quadratic splines)",
    scenes: scenes::SCENES,
    layouts: layouts::LAYOUTS,
    unfit: layouts::unfit,
    build: layouts::build,
};
