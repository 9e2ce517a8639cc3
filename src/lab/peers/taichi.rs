//! Taichi, in a process of its own that is told in lines what to do: `benches/peers/taichi_workloads.py`.

use std::fmt;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use tempfile::NamedTempFile;

use crate::lab::errors::LabError;

const PROGRAM: &str = include_str!("../../../benches/peers/taichi_workloads.py");

/// What is told where it is missing.
pub(super) const HOW_TO_INSTALL: &str = "\
to compare with it: `python3 -m venv taichi && taichi/bin/pip install taichi==1.7.4 numpy` (Python 3.9 to 3.13), and
`allotrope compare taichi --python taichi/bin/python`; our times alone follow";

/// How a workload is written in Taichi.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Variant {
    /// As its users write it.
    Written,
    /// Tuned by hand.
    Tuned,
}

impl fmt::Display for Variant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Written => "written",
            Self::Tuned => "tuned",
        })
    }
}

/// The process, which ends with the value.
pub(super) struct Taichi {
    child: Child,
    orders: ChildStdin,
    answers: BufReader<ChildStdout>,
    version: String,
    /// What it says besides, which a pipe that nobody reads would hold up.
    says: NamedTempFile,
    /// Python reads it anew for each kernel.
    _program: NamedTempFile,
}

impl Taichi {
    /// Starts it on so many threads; if it cannot be, why.
    pub(super) fn start(python: &Path, threads: usize) -> Result<Self, String> {
        let shown = python.display();
        let probe = Command::new(python)
            .args(["-c", "import numpy, taichi; print('@', '.'.join(map(str, taichi.__version__)))"])
            .env("ENABLE_TAICHI_HEADER_PRINT", "0")
            .output()
            .map_err(|error| format!("`{shown}` cannot be run: {error}"))?;
        let told = String::from_utf8_lossy(&probe.stdout);
        let Some(version) = told.lines().find_map(|line| line.strip_prefix("@ ")).filter(|_| probe.status.success())
        else {
            let why = String::from_utf8_lossy(&probe.stderr);
            let why = why.lines().last().unwrap_or("it says nothing").trim();
            return Err(format!("`{shown}` has no Taichi: {why}"));
        };
        let file = || {
            let mut file = tempfile::Builder::new().prefix("taichi").suffix(".py").tempfile()?;
            file.write_all(PROGRAM.as_bytes())?;
            file.flush()?;
            let says = NamedTempFile::new()?;
            let into = says.reopen()?;
            Ok::<_, std::io::Error>((file, says, into))
        };
        let (program, says, into) = file().map_err(|error| format!("the Taichi program cannot be written: {error}"))?;
        let mut child = Command::new(python)
            .arg(program.path())
            .env("ENABLE_TAICHI_HEADER_PRINT", "0")
            .env("THREADS", threads.to_string())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(into)
            .spawn()
            .map_err(|error| format!("`{shown}` cannot be run: {error}"))?;
        let (Some(orders), Some(answers)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(format!("`{shown}` cannot be talked to"));
        };
        Ok(Self { child, orders, answers: BufReader::new(answers), version: version.into(), says, _program: program })
    }

    /// Its version.
    pub(super) fn version(&self) -> &str {
        &self.version
    }

    /// Makes the fields of a workload, in place of those of the last one; gives the result of one call of each variant
    /// there is, as written first.
    pub(super) fn build(&mut self, name: &str) -> Result<Vec<f64>, LabError> {
        self.ask(&format!("build {name}"))
    }

    /// Milliseconds of a call, the mean of so many.
    pub(super) fn time(&mut self, name: &str, variant: Variant, calls: usize) -> Result<f64, LabError> {
        let order = format!("time {name} {variant} {calls}");
        let answer = self.ask(&order)?;
        answer.first().copied().ok_or_else(|| LabError::failure(format!("Taichi gave no answer to `{order}`")))
    }

    fn ask(&mut self, order: &str) -> Result<Vec<f64>, LabError> {
        let sent = writeln!(self.orders, "{order}").and_then(|()| self.orders.flush());
        let mut line = String::new();
        // What Taichi itself says is no answer.
        while sent.is_ok() && !line.starts_with('@') {
            line.clear();
            if !matches!(self.answers.read_line(&mut line), Ok(read) if read > 0) {
                break;
            }
        }
        let numbers: Option<Vec<f64>> = line
            .strip_prefix('@')
            .and_then(|numbers| numbers.split_whitespace().map(|number| number.parse().ok()).collect());
        numbers.ok_or_else(|| LabError::failure(format!("Taichi ended at `{order}`: {}", self.last_words())))
    }

    /// The last line that it wrote to the standard error.
    fn last_words(&mut self) -> String {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let said = std::fs::read(self.says.path()).unwrap_or_default();
        let last = String::from_utf8_lossy(&said).lines().last().map(String::from);
        last.unwrap_or_else(|| "it says nothing".into())
    }
}

impl Drop for Taichi {
    fn drop(&mut self) {
        // One that has ended already is no fault.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
