//! Smoothed particle hydrodynamics: what its solvers share.
//!
//! | module | what it is |
//! | --- | --- |
//! | [`smoothing`] | smoothing kernels: the cubic spline and the Gaussian in one, two and three dimensions |
//! | [`neighbours`] | which particles are near each other, found in four ways |
//!
//! Three lengths are told apart. The *spacing* of particles at rest gives their volume; the *smoothing length* `h` scales
//! the kernel; the *support radius*, two or three smoothing lengths, is where the kernel ends, and so how far neighbours are.

pub mod neighbours;
pub mod smoothing;
pub mod wcsph;

pub use smoothing::{Smoothing, Spline};
