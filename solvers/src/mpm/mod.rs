//! The material point method in a plane and in space: fluids, elastic solids, snow and sand, side by side.
//!
//! Mass and momentum are scattered from particles to a grid, which gravity, walls and colliders act on; then velocity and
//! its gradient are gathered back, and the particles move and are deformed. Time runs in explicit steps (symplectic
//! Euler).
//!
//! | part | choices | where |
//! | --- | --- | --- |
//! | material | weakly compressible fluid, neo-Hookean and fixed corotated solids, snow (Stomakhin et al. 2013), sand (Klar et al. 2016) | [`materials`] |
//! | what a particle carries | a velocity (PIC, FLIP), an affine field (APIC), a polynomial one (PolyPIC) | [`continuum`] |
//! | spline | linear, quadratic, cubic | [`continuum::Constants`] |
//! | forces | least squares (Hu et al. 2018), gradients of weights (Sulsky et al. 1994) | [`continuum::Constants`] |
//! | what stands in the way | walls and colliders, sticky, slippery or rough, at rest or moving | [`obstacles`] |
//!
//! A fluid alone in the usual transfer (APIC, quadratic splines, least squares) has records and kernels of its own,
//! [`fluid`], which hold and do less.
//!
//! The kernels are written once, against members; the layouts in which they are compiled stand in one list.
//! Sorting the particles by cell now and then (`reorder` of a scene) changes neither the algorithm nor the order in
//! which positions are told.
//!
//! Linear splines and PolyPIC with many modes keep what nodes of hardly any mass do, at the rim of a body; stiff solids
//! can break down there within some hundred steps, and then the run says so.

pub mod continuum;
pub(crate) mod convert;
mod driver;
pub mod fluid;
mod gates;
mod grid;
mod layouts;
pub mod materials;
mod medium;
pub mod obstacles;
pub mod order;
mod scenes;
mod setup;
mod stability;

use crate::SolverInfo;

pub use medium::block_major;
pub use setup::{Forces, Material, MpmSetup, Scheme, Spline, Transfer};

pub(crate) const SOLVER: SolverInfo = SolverInfo {
    name: "mpm",
    about: "the material point method for fluids, elastic solids, snow and sand in 2D and 3D",
    dimensions: 2..=3,
    keys: setup::KEYS,
    read: setup::read,
    scenes: scenes::SCENES,
    layouts: layouts::LAYOUTS,
    unfit: layouts::unfit,
    build: layouts::build,
};
