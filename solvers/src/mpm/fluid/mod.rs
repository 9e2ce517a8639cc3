//! A fluid alone between walls without friction, which most runs are: its particles hold a volume ratio instead of a
//! deformation gradient, and its kernels do nothing that it does not need.
//!
//! One text serves the plane and space, and single and double precision.

pub mod kernels;
mod medium;
mod parameters;
mod records;

pub(in crate::mpm) use medium::Fluid;
pub use parameters::{Mpm, quadratic_weights, weight};
pub use records::{Node, Point};
