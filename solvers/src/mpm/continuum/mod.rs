//! Any materials, side by side: particles hold a deformation gradient and the stress that follows from it, and carry
//! velocity in one of three ways, each with records and kernels of its own.
//!
//! | module | what a particle carries | schemes |
//! | --- | --- | --- |
//! | `affine` | a velocity and its gradient | APIC |
//! | `plain` | a velocity | PIC, FLIP |
//! | `polynomial` | a polynomial velocity field | PolyPIC |
//!
//! The text of records and kernels is the same in [`plane`] and [`space`], which name the types that it is about. Only
//! the loops over the 9 or 27 nodes of a quadratic spline, which are unrolled, are written apart.

mod constants;
pub mod plane;
pub mod space;

pub use constants::Constants;
