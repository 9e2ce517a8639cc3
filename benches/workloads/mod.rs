//! The workloads as kernels, with the inputs that kernels and twins share.

pub mod stencils;
pub mod streams;
pub mod transfer;
