//! Physics solvers written in Allotrope.
//!
//! [`solvers`] is the one list of them: the laboratory, the benches and the equivalence tests take solvers, scenes and
//! layouts from it, so that what is added here is run, measured and tested everywhere.
//!
//! ```
//! let mpm = allotrope_solvers::solver("mpm").unwrap();
//! let scene = mpm.scene("mpm88").unwrap();
//! let mut fluid = (mpm.build)(&scene, "aosoa16+blocked4").unwrap();
//! fluid.step().unwrap();
//! assert_eq!(fluid.particles(), 8192);
//! ```

#![forbid(unsafe_code)]
#![allow(clippy::duplicate_mod, reason = "texts of kernels that are the same in the plane and in space")]

mod gate;
mod layout_pairs;
pub mod linear;
pub mod mass_spring;
pub mod mesh;
pub mod mpm;
mod nearest;
mod registry;
pub mod scene;
mod simulation;
pub mod sph;
mod state;

pub use gate::{Finding, Gate, Watch};
pub use nearest::nearest;
pub use registry::{Built, LayoutInfo, Read, SceneInfo, SolverInfo, solver, solvers};
pub use scene::{Scene, SceneError, Setup};
pub use simulation::{Simulation, StepError, Totals};
pub use state::{Array, Energy, State, Values};
