//! Any materials, side by side: particles hold a deformation gradient and the stress that follows from it, and carry
//! velocity in one of three ways, each with records and kernels of its own.
//!
//! | module | what a particle carries | schemes |
//! | --- | --- | --- |
//! | [`affine`] | a velocity and its gradient | APIC |
//! | [`quadratic`] | the same, over quadratic splines and with least squares: loops over nodes are unrolled | APIC |
//! | [`plain`] | a velocity | PIC, FLIP |
//! | [`polynomial`] | a polynomial velocity field | PolyPIC |
//!
//! Records and kernels serve the plane and space, as [`Dimensions`] tells. They are in single precision, as the
//! [materials](super::materials) are.

pub mod affine;
mod carrier;
mod constants;
mod dimensions;
mod medium;
pub mod plain;
pub mod polynomial;
pub mod quadratic;
mod records;
mod stencil;

pub(in crate::mpm) use carrier::{Affine, Plain, Polynomial};
pub use constants::Constants;
pub use dimensions::Dimensions;
pub(in crate::mpm) use medium::Continuum;
pub use records::{AffinePoint, ChangingNode, Node, PlainPoint, PolynomialPoint};
pub(in crate::mpm) use records::{HotAffine, HotPlain, HotPolynomial};
pub use stencil::{Stencil, Transfers};
