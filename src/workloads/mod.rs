//! The workloads that are measured beside hand-written twins and other systems, as kernels, with their inputs.

pub mod bodies;
pub mod sparse;
pub mod stencils;
pub mod streams;
pub mod transfer;
