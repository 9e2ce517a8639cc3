//! # Allotrope
//!
//! *One algorithm, many layouts.* A kernel is written once, against named members and indices; how they lie in memory
//! is a type, chosen elsewhere, and changed without touching the kernel.

// Expansions name this crate from outside; inside (tests, examples in docs) it is the same name.
extern crate self as allotrope;

mod axes;
mod capture;
mod element;
pub mod errors;
mod field;
mod index;
mod launch;
pub mod layout;
mod number;
mod record;
mod scatter;
mod schedule;
mod serial;
mod view;

pub mod prelude;
#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;

pub use allotrope_macros::{Record, kernel, layout};
pub use axes::{Axes, I, Ij, Ijk, Shape};
pub use element::{Element, Scalar};
pub use field::{Field, Member, MemberMut, OutOfRange, Permutation, Records, ShapeError};
pub use index::{Integer, IntoIndex};
pub use launch::cpu::Cpu;
pub use layout::Layout;
pub use record::{MAX_MEMBERS, Record};
pub use schedule::{MAX_THREADS, Scatter, Schedule};
