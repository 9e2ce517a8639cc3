//! The workloads as kernels, with the inputs that kernels and twins share.

pub(crate) mod bodies;
pub(crate) mod sparse;
pub(crate) mod stencils;
pub(crate) mod streams;
pub(crate) mod transfer;
