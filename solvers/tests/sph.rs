//! Smoothed particle hydrodynamics: kernels, neighbours, and the weakly compressible solver.

#[path = "sph/neighbours.rs"]
mod neighbours;
#[path = "sph/smoothing.rs"]
mod smoothing;
#[path = "sph/wcsph.rs"]
mod wcsph;
