//! How the program fails: with one line, and a status.

use std::any::Any;
use std::fmt;
use std::io::Write;
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;

use allotrope_solvers::{SceneError, StepError};

/// Why a command ended early.
#[derive(Clone, Debug)]
pub struct LabError {
    message: String,
    status: u8,
}

/// A run or a check failed.
pub const FAILED: u8 = 1;

/// What was asked for cannot be.
pub const USAGE: u8 = 2;

/// The machine failed: no room on a disk, a place that cannot be written, no memory.
pub const MACHINE: u8 = 3;

/// Statuses from this on tell the signal that ended a run, as shells do.
pub const SIGNAL: u8 = 128;

impl LabError {
    /// What was asked for cannot be: status 2.
    pub fn usage(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: USAGE }
    }

    /// A run or a check failed: status 1.
    pub fn failure(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: FAILED }
    }

    /// The machine failed, which is no fault of what was asked for: status 3.
    pub fn machine(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: MACHINE }
    }

    /// A run was ended by a signal of that number, and can be gone on with: status 128 and the number.
    pub fn interrupted(message: impl Into<String>, signal: u8) -> Self {
        Self { message: message.into(), status: SIGNAL | signal }
    }

    /// The same with something added to its message.
    pub(super) fn and(mut self, more: &str) -> Self {
        self.message.push_str(more);
        self
    }

    /// The exit status.
    pub fn status(&self) -> u8 {
        self.status
    }
}

impl fmt::Display for LabError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&one_line(&self.message))
    }
}

impl std::error::Error for LabError {}

impl From<SceneError> for LabError {
    fn from(error: SceneError) -> Self {
        let message = error.to_string();
        if error.is_memory() { Self::machine(message) } else { Self::usage(message) }
    }
}

impl From<StepError> for LabError {
    fn from(error: StepError) -> Self {
        Self::failure(error.to_string())
    }
}

/// Runs a command, prints its error and gives its status. A panic, which is a fault of the program or of a kernel, is
/// told in one line too.
pub fn report(command: impl FnOnce() -> Result<(), LabError>) -> ExitCode {
    panic::set_hook(Box::new(|_| ()));
    let outcome = panic::catch_unwind(AssertUnwindSafe(command));
    let _ = panic::take_hook();
    match outcome {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(error)) => {
            // To be interrupted is no error.
            let what = if error.status < SIGNAL { "error: " } else { "" };
            tell(&format!("{what}{error}"));
            ExitCode::from(error.status)
        }
        Err(payload) => {
            tell(&format!("error: stopped by a panic: {}", one_line(panic_text(&*payload))));
            ExitCode::from(FAILED)
        }
    }
}

/// Writes a line to the standard error. Where nobody can read it, there is nobody to tell that to either.
pub(super) fn tell(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// What a panic said.
pub(super) fn panic_text(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or(payload.downcast_ref::<&str>().copied()).unwrap_or("without a message")
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_one_line_with_a_status() {
        let error = LabError::machine("no room\n  left").and("; sorry");
        assert_eq!((error.to_string().as_str(), error.status()), ("no room left; sorry", 3));
        assert_eq!(LabError::interrupted("", 2).status(), 130);
        assert_eq!(LabError::interrupted("", 15).status(), 143);
    }
}
