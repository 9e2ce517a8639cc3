//! The layout laboratory: runs one simulation in many data layouts, and shows what each costs.
//!
//! The program `allotrope` is this library with a `main`.

#![forbid(unsafe_code)]

pub mod lab;
pub mod workloads;

use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with the arguments of its command line, the first of which is its own name.
///
/// The status is 0 on success, 1 where a run or a check fails, 2 where what was asked for cannot be, and 3 where the
/// machine fails (a disk is full, memory is short), with one line on the standard error that says why. A run that is
/// ended by a signal gives 128 and its number, as shells do.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    lab::errors::report(|| lab::cli::parse(arguments)?.execute())
}
