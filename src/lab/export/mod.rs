//! Files for other programs: arrays for NumPy, particles and grids for viewers, moving pictures.
//!
//! Everything is made in memory or written to a writer that is given; to put files in their places is the caller's.
//! Only [`mp4`] writes a file of its own, since another program makes it.

pub mod gif;
pub mod mp4;
pub mod npz;
mod palette;
pub mod ply;
pub mod sheet;
mod text;
pub mod vtk;
