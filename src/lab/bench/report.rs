//! What a comparison found.

use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};

/// What `--json` writes.
#[derive(Debug, Deserialize, Serialize)]
pub struct Report {
    /// The solver.
    pub solver: String,
    /// The scene.
    pub scene: String,
    /// Number of particles.
    pub particles: usize,
    /// Nodes along each axis; empty, if there is no grid.
    pub grid: Vec<usize>,
    /// Threads of loops.
    pub threads: usize,
    /// Instruction set of loops.
    pub isa: String,
    /// A row for each layout and schedule.
    pub rows: Vec<Row>,
}

/// The result of one layout with one schedule.
#[derive(Debug, Deserialize, Serialize)]
pub struct Row {
    /// The layout.
    pub layout: String,
    /// The schedule.
    pub schedule: String,
    /// Median time a step.
    pub ms_per_step: f64,
    /// Interquartile range of the time a step over its median.
    pub spread: f64,
    /// Median time a step in each kernel.
    pub kernels: Kernels,
    /// Bytes of all fields.
    pub bytes: usize,
    /// Largest difference of a position from the first row's after the run, in metres along an axis.
    pub state_error: f64,
}

/// Times by the name of the kernel, in the order of a step.
#[derive(Clone, Debug, Deserialize)]
#[serde(from = "std::collections::BTreeMap<String, f64>")]
pub struct Kernels(pub Vec<(String, f64)>);

impl From<std::collections::BTreeMap<String, f64>> for Kernels {
    fn from(times: std::collections::BTreeMap<String, f64>) -> Self {
        Self(times.into_iter().collect())
    }
}

impl Serialize for Kernels {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, time) in &self.0 {
            map.serialize_entry(name, time)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_is_one_line_with_kernels_in_order() {
        let kernels = Kernels(vec![("scatter".into(), 0.12), ("grid".into(), 0.03), ("gather".into(), 0.15)]);
        assert_eq!(serde_json::to_string(&kernels).unwrap(), r#"{"scatter":0.12,"grid":0.03,"gather":0.15}"#);
    }
}
