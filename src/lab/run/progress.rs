//! What a run tells while it goes on: text for people, or a line of JSON for each event.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::lab::errors::{self, LabError};
use crate::lab::output;

/// How a run tells of its progress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Progress {
    /// A bar where the standard error is a terminal, plain lines elsewhere
    #[default]
    Auto,
    /// A bar on the standard error
    Bar,
    /// A line for each frame
    Plain,
    /// A line of JSON for each event
    Json,
    /// The first line and the last
    None,
}

/// Something that happened in a run. What an event names as written is on the disk, whole.
#[derive(Debug, Serialize)]
#[serde(tag = "event", rename_all = "lowercase")]
pub(super) enum Event<'a> {
    Start {
        version: &'static str,
        solver: &'a str,
        scene: &'a str,
        layout: &'a str,
        particles: usize,
        grid: Vec<usize>,
        threads: usize,
        isa: String,
        deterministic: bool,
        seeds: Vec<u64>,
        /// Steps that are done already.
        step: u64,
        steps: u64,
        #[serde(skip)]
        text: String,
    },
    Frame {
        number: u64,
        step: u64,
        time: f64,
        file: &'a Path,
        exports: &'a [PathBuf],
        #[serde(skip)]
        steps: u64,
    },
    Checkpoint {
        step: u64,
        time: f64,
        file: &'a Path,
    },
    End {
        reason: Reason,
        step: u64,
        time: f64,
        seconds: f64,
        frames: u64,
        files: &'a [PathBuf],
        #[serde(skip)]
        text: String,
    },
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Reason {
    Finished,
    Interrupted,
    Failed,
}

/// Tells what happens in the way that was asked for.
pub(super) struct Reporter {
    progress: Progress,
    quiet: bool,
    bar: ProgressBar,
    shown: Instant,
}

impl Reporter {
    pub(super) fn new(progress: Progress, quiet: bool, steps: u64, done: u64) -> Self {
        let progress = match progress {
            Progress::Auto if std::io::stderr().is_terminal() => Progress::Bar,
            Progress::Auto => Progress::Plain,
            other => other,
        };
        let bar = if progress == Progress::Bar && !quiet { ProgressBar::new(steps) } else { ProgressBar::hidden() };
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len} steps, {per_sec}, {eta} left {msg}");
        let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.set_position(done);
        // The speed and the time that is left are those of this run, not of what was done before it.
        bar.reset_eta();
        Self { progress, quiet, bar, shown: Instant::now() }
    }

    /// Moves the bar, now and then.
    pub(super) fn step(&mut self, done: u64) {
        if self.shown.elapsed() > Duration::from_millis(100) {
            self.bar.set_position(done);
            self.shown = Instant::now();
        }
    }

    /// Takes the bar away.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }

    /// A remark that is no error.
    pub(super) fn note(&self, line: &str) {
        if !self.quiet {
            self.bar.suspend(|| errors::tell(&format!("note: {line}")));
        }
    }

    /// # Errors
    /// If the standard output cannot be written.
    pub(super) fn tell(&self, event: &Event<'_>) -> Result<(), LabError> {
        if matches!(event, Event::End { .. }) {
            self.clear();
        }
        if self.quiet {
            return Ok(());
        }
        if self.progress == Progress::Json {
            let line = serde_json::to_string(event).map_err(|error| LabError::failure(error.to_string()))?;
            return self.print(&format!("{line}\n"));
        }
        match event {
            Event::Start { text, .. } | Event::End { text, .. } => self.print(text),
            Event::Frame { step, steps, file, .. } if self.progress == Progress::Plain => {
                self.print(&format!("step {step} of {steps}: {}\n", file.display()))
            }
            Event::Checkpoint { step, file, .. } if self.progress == Progress::Plain => {
                self.print(&format!("checkpoint after step {step}: {}\n", file.display()))
            }
            _ => Ok(()),
        }
    }

    /// Prints a text, where the bar does not stand in its way.
    fn print(&self, text: &str) -> Result<(), LabError> {
        self.bar.suspend(|| output::print(text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn events_are_objects_with_their_names_first() {
        let file = Path::new("out/frame_0001.png");
        let event = Event::Frame { number: 1, step: 20, time: 0.25, file, exports: &[], steps: 40 };
        let line = r#"{"event":"frame","number":1,"step":20,"time":0.25,"file":"out/frame_0001.png","exports":[]}"#;
        assert_eq!(serde_json::to_string(&event).unwrap(), line);
        let event = Event::End {
            reason: Reason::Interrupted,
            step: 20,
            time: 0.25,
            seconds: 1.5,
            frames: 2,
            files: &[],
            text: String::new(),
        };
        let line =
            r#"{"event":"end","reason":"interrupted","step":20,"time":0.25,"seconds":1.5,"frames":2,"files":[]}"#;
        assert_eq!(serde_json::to_string(&event).unwrap(), line);
    }
}
