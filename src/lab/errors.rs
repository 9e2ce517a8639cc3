//! How the program fails: with one line, and a status.

use std::any::Any;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;

use allotrope_solvers::{SceneError, StepError};

/// Why a command ended early.
#[derive(Debug)]
pub struct LabError {
    message: String,
    status: u8,
}

impl LabError {
    /// What was asked for cannot be: status 2.
    pub fn usage(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: 2 }
    }

    /// A run or a check failed: status 1.
    pub fn failure(message: impl Into<String>) -> Self {
        Self { message: message.into(), status: 1 }
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
        Self::usage(error.to_string())
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
            eprintln!("error: {error}");
            ExitCode::from(error.status)
        }
        Err(payload) => {
            eprintln!("error: stopped by a panic: {}", one_line(panic_text(&*payload)));
            ExitCode::FAILURE
        }
    }
}

/// What a panic said.
pub(super) fn panic_text(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    text.or(payload.downcast_ref::<&str>().copied()).unwrap_or("without a message")
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
