//! What a search found, as a line of TOML, which `run` and `bench` read.

use std::collections::BTreeMap;
use std::path::Path;

use allotrope_solvers::nearest;
use serde::{Deserialize, Serialize};

use crate::lab::errors::LabError;

/// The best of a search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Choice {
    /// The layout.
    pub layout: String,
    /// The way of accumulating.
    pub schedule: String,
    /// When particles are sorted, as `--reorder` takes it.
    pub reorder: String,
    /// The scene that was searched with.
    pub scene: String,
    /// Its particles.
    pub particles: usize,
    /// Threads.
    pub threads: usize,
    /// The instruction set.
    pub isa: String,
}

/// Choices by solver: each a line, so that lines of several files make one.
///
/// ```
/// use allotrope_lab::lab::search::{Choice, Tuned};
///
/// let choice = Choice {
///     layout: "aos+row".into(),
///     schedule: "auto".into(),
///     reorder: "64".into(),
///     scene: "mpm88".into(),
///     particles: 8192,
///     threads: 2,
///     isa: "avx2".into(),
/// };
/// let line = Tuned::of("mpm", choice).line();
/// assert_eq!(line.lines().count(), 1);
/// assert!(line.starts_with("mpm = { layout = \"aos+row\", schedule = \"auto\", reorder = \"64\""));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Tuned(BTreeMap<String, Choice>);

impl Tuned {
    /// The choice of one solver.
    pub fn of(solver: &str, choice: Choice) -> Self {
        Self([(solver.to_string(), choice)].into())
    }

    /// The choices, a line each.
    pub fn line(&self) -> String {
        let text = |text: &str| toml::Value::from(text).to_string();
        let line = |(solver, choice): (&String, &Choice)| {
            let Choice { layout, schedule, reorder, scene, particles, threads, isa } = choice;
            format!(
                "{solver} = {{ layout = {}, schedule = {}, reorder = {}, scene = {}, particles = {particles}, threads = {threads}, isa = {} }}\n",
                text(layout),
                text(schedule),
                text(reorder),
                text(scene),
                text(isa)
            )
        };
        self.0.iter().map(line).collect()
    }

    /// The choice for a solver in a file.
    ///
    /// # Errors
    /// If the file cannot be read, or tells nothing of the solver.
    pub fn load(path: &Path, solver: &str) -> Result<Choice, LabError> {
        let fault = |why: String| LabError::usage(format!("`{}` {why}", path.display()));
        let text = std::fs::read_to_string(path).map_err(|error| fault(format!("cannot be read: {error}")))?;
        let mut tuned: BTreeMap<String, Choice> =
            toml::from_str(&text).map_err(|error| fault(format!("is no result of `search`: {}", error.message())))?;
        if let Some(choice) = tuned.remove(solver) {
            return Ok(choice);
        }
        let names: Vec<_> = tuned.keys().map(String::as_str).collect();
        let meant = match nearest(solver, names.iter().copied()) {
            Some(near) => format!("; did you mean `{near}`?"),
            None if names.is_empty() => String::new(),
            None => format!("; it has `{}`", names.join("`, `")),
        };
        Err(fault(format!("tells nothing of `{solver}`{meant}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_again_and_faults_are_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tuned.toml");
        let choice = Choice {
            layout: "aos+row".into(),
            schedule: "auto".into(),
            reorder: "auto".into(),
            scene: "a \"quoted\" name.toml".into(),
            particles: 10,
            threads: 2,
            isa: "avx2".into(),
        };
        std::fs::write(&path, Tuned::of("mpm", choice.clone()).line()).unwrap();
        assert_eq!(Tuned::load(&path, "mpm").unwrap(), choice);
        let error = Tuned::load(&path, "wcsph").unwrap_err().to_string();
        assert!(error.ends_with("tells nothing of `wcsph`; it has `mpm`"), "{error}");
        std::fs::write(&path, "mpm = { layout = \"aos+row\", colour = 1 }").unwrap();
        let error = Tuned::load(&path, "mpm").unwrap_err().to_string();
        assert!(error.contains("is no result of `search`: unknown field `colour`"), "{error}");
        let error = Tuned::load(&folder.path().join("none"), "mpm").unwrap_err().to_string();
        assert!(error.contains("cannot be read"), "{error}");
    }
}
