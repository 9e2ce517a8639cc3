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
    pub kernels: Named,
    /// Bytes of all fields.
    pub bytes: usize,
    /// Largest difference of a position from the first row's after the run, in metres along an axis.
    pub state_error: f64,
    /// What processor and system counted a step, on all threads; empty where they were not asked, or refused.
    #[serde(default, skip_serializing_if = "Named::is_empty")]
    pub counted: Named,
}

/// Numbers by name, in an order of their own: kernels in that of a step.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(from = "std::collections::BTreeMap<String, f64>")]
pub struct Named(pub Vec<(String, f64)>);

impl Named {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// That of a name.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, number)| *number)
    }
}

impl From<std::collections::BTreeMap<String, f64>> for Named {
    fn from(numbers: std::collections::BTreeMap<String, f64>) -> Self {
        Self(numbers.into_iter().collect())
    }
}

impl Serialize for Named {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, number) in &self.0 {
            map.serialize_entry(name, number)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_is_one_line_with_kernels_in_order() {
        let kernels = Named(vec![("scatter".into(), 0.12), ("grid".into(), 0.03), ("gather".into(), 0.15)]);
        assert_eq!(serde_json::to_string(&kernels).unwrap(), r#"{"scatter":0.12,"grid":0.03,"gather":0.15}"#);
    }
}
