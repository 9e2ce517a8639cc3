//! A fluid alone between walls without friction, which most runs are: its particles hold a volume ratio instead of a
//! deformation gradient, and its kernels do nothing that it does not need.

pub mod kernels_2d;
pub mod kernels_3d;
mod parameters;
mod plane;
mod records;
mod space;

pub use parameters::{Mpm, quadratic_weights};
pub(in crate::mpm) use plane::Fluid2;
pub use records::{Node2, Node3, Point2, Point3};
pub(in crate::mpm) use space::Fluid3;
