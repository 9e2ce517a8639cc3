//! What a comparison with another system found.

use serde::{Deserialize, Serialize};

use crate::lab::machine;
use crate::lab::table::{Table, four_digits, six_digits};

/// What `--json` writes.
#[derive(Debug, Deserialize, Serialize)]
pub struct Report {
    /// Threads of both sides.
    pub threads: usize,
    /// Instruction set of our loops.
    pub isa: String,
    /// Repetitions of each side.
    pub pairs: usize,
    /// A row for each workload.
    pub rows: Vec<Row>,
}

/// The times of one workload, medians in milliseconds a call. Ratios are medians of those of the pairs: how many times as
/// long the other takes. What was not measured is `null`.
#[derive(Debug, Deserialize, Serialize)]
pub struct Row {
    /// Its name.
    pub workload: String,
    /// Ours.
    pub ours_ms: f64,
    /// Taichi's, as its users write it.
    pub taichi_ms: Option<f64>,
    /// Taichi's, tuned by hand; `null` too where there is nothing to tune.
    pub tuned_ms: Option<f64>,
    /// Taichi's over ours.
    pub ratio: Option<f64>,
    /// Tuned Taichi's over ours.
    pub ratio_tuned: Option<f64>,
    /// Useful bytes that ours moves a second, in 10^9.
    pub useful_gb_per_s: Option<f64>,
    /// The same as a fraction of what a loop that only moves memory does.
    pub bandwidth_fraction: Option<f64>,
}

/// Workloads that would carry a mean of all.
const NOT_IN_MEAN: [&str; 2] = ["histogram", "launch"];

impl Row {
    /// A row of medians, each with its ratio to ours.
    pub(super) fn new(
        workload: &str,
        ours: f64,
        written: Option<(f64, f64)>,
        tuned: Option<(f64, f64)>,
        moved: Option<(f64, f64)>,
    ) -> Self {
        let split =
            |pair: Option<(f64, f64)>| (pair.map(|pair| six_digits(pair.0)), pair.map(|pair| six_digits(pair.1)));
        let ((taichi_ms, ratio), (tuned_ms, ratio_tuned)) = (split(written), split(tuned));
        let (useful_gb_per_s, bandwidth_fraction) = split(moved);
        Self {
            workload: workload.into(),
            ours_ms: six_digits(ours),
            taichi_ms,
            tuned_ms,
            ratio,
            ratio_tuned,
            useful_gb_per_s,
            bandwidth_fraction,
        }
    }
}

impl Report {
    /// The geometric mean of Taichi's times over ours, without the workloads that would carry it; nothing where none was
    /// measured.
    pub fn mean_ratio(&self) -> Option<f64> {
        let rows = self.rows.iter().filter(|row| !NOT_IN_MEAN.contains(&row.workload.as_str()));
        let logs: Vec<f64> = rows.filter_map(|row| row.ratio).map(f64::ln).collect();
        (!logs.is_empty()).then(|| (logs.iter().sum::<f64>() / logs.len() as f64).exp())
    }

    /// The machine, a table, and the mean, where `taichi` is the version that was compared with.
    pub(super) fn text(&self, taichi: Option<&str>) -> String {
        let headline = ["workload", "ours ms", "taichi ms", "tuned ms", "ratio", "tuned", "GB/s", "of memory's"];
        let mut table = Table::new(headline, 1);
        let times = |value: Option<f64>| value.map_or("-".into(), four_digits);
        let ratio = |value: Option<f64>| value.map_or("-".into(), |ratio| format!("{ratio:.2}"));
        for row in &self.rows {
            table.row([
                row.workload.clone(),
                four_digits(row.ours_ms),
                times(row.taichi_ms),
                times(row.tuned_ms),
                ratio(row.ratio),
                ratio(row.ratio_tuned),
                times(row.useful_gb_per_s),
                row.bandwidth_fraction.map_or("-".into(), |fraction| format!("{:.0} %", 100.0 * fraction)),
            ]);
        }
        let plural = if self.threads == 1 { "thread" } else { "threads" };
        let beside = taichi.map_or("no Taichi".into(), |version| format!("beside Taichi {version}"));
        let mut text = format!(
            "{}, {} {plural}, {}, {beside}; medians of {} pairs\n\n{}",
            machine::processor(),
            self.threads,
            self.isa,
            self.pairs,
            table.text()
        );
        if let Some(mean) = self.mean_ratio() {
            text.push_str(&format!(
                "\nTaichi takes {mean:.2} times as long on the geometric mean of those but {}\n",
                NOT_IN_MEAN.join(" and ")
            ));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(workload: &str, ratio: f64) -> Row {
        Row::new(workload, 2.0, Some((2.0 * ratio, ratio)), None, Some((10.0, 0.9)))
    }

    #[test]
    fn the_mean_is_geometric_and_leaves_out_what_would_carry_it() {
        let rows = vec![row("saxpy", 2.0), row("jacobi", 8.0), row("launch", 1e6)];
        let mut report = Report { threads: 2, isa: "avx2".into(), pairs: 7, rows };
        assert!((report.mean_ratio().unwrap() - 4.0).abs() < 1e-12);
        let text = report.text(Some("1.7.4"));
        assert!(text.contains("4.00 times as long on the geometric mean"), "{text}");
        report.rows = vec![Row::new("saxpy", 2.0, None, None, None)];
        assert_eq!(report.mean_ratio(), None);
        assert!(report.text(None).contains("no Taichi"));
    }

    #[test]
    fn what_was_not_measured_is_null() {
        let line = serde_json::to_string(&Row::new("sum", 1.5, None, None, None)).unwrap();
        assert!(line.starts_with(
            r#"{"workload":"sum","ours_ms":1.5,"taichi_ms":null,"tuned_ms":null,"ratio":null,"ratio_tuned":null"#
        ));
    }
}
