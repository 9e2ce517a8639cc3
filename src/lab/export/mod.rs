//! Files for other programs: arrays for NumPy, particles and grids for viewers, moving pictures.
//!
//! Everything is made in memory or written to a writer that is given; to put files in their places is the caller's.

pub mod npz;
