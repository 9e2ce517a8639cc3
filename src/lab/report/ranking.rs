//! Which layout is the fastest, and how sure that is.

use crate::lab::bench::Report;
use crate::lab::statistics::{median_interval, median_ratio_interval, quantile};

/// Repetitions without which nothing is said to differ.
pub(in crate::lab) const FEWEST: u64 = 6;

/// A layout with a schedule in its place.
#[derive(Clone, Debug)]
pub(in crate::lab) struct Ranked {
    /// The layout, with its schedule if there are several.
    pub(in crate::lab) name: String,
    pub(in crate::lab) layout: String,
    pub(in crate::lab) schedule: String,
    /// Milliseconds a step: the median of repetitions.
    pub(in crate::lab) ms: f64,
    /// Where that median lies with 95 % confidence.
    pub(in crate::lab) interval: [f64; 2],
    /// Interquartile range over the median.
    pub(in crate::lab) spread: f64,
    /// Over the time of the fastest.
    pub(in crate::lab) ratio: f64,
    /// Where that ratio lies with 95 % confidence.
    pub(in crate::lab) ratio_interval: [f64; 2],
    /// Whether these repetitions do not tell it from the fastest.
    pub(in crate::lab) is_level: bool,
    /// Repetitions that lie farther from the middle half than one and a half times its width (Tukey 1977, "Exploratory data analysis").
    pub(in crate::lab) outliers: usize,
    /// The slowest repetition over the median.
    pub(in crate::lab) slowest: f64,
    /// Milliseconds a step in each kernel.
    pub(in crate::lab) kernels: Vec<(String, f64)>,
    pub(in crate::lab) bytes: usize,
    pub(in crate::lab) state_error: f64,
}

/// All rows of a comparison, the fastest first. `samples` are the milliseconds a step in each repetition of each row; the repetitions of all
/// rows are interleaved, and so are pairs.
pub(super) fn rank(report: &Report, samples: &[Vec<f64>]) -> Vec<Ranked> {
    let mut order: Vec<usize> = (0..report.rows.len()).collect();
    order.sort_by(|&a, &b| report.rows[a].ms_per_step.total_cmp(&report.rows[b].ms_per_step));
    let Some(&best) = order.first() else { return Vec::new() };
    let has_schedules = report.rows.iter().any(|row| row.schedule != report.rows[0].schedule);
    let one = |&n: &usize| {
        let (row, own) = (&report.rows[n], &samples[n]);
        let ratio_interval = if n == best { [1.0; 2] } else { median_ratio_interval(own, &samples[best]) };
        let [low, high] = [quantile(own, 0.25), quantile(own, 0.75)];
        let reach = 1.5 * (high - low);
        let middle = quantile(own, 0.5);
        Ranked {
            name: if has_schedules { format!("{} ({})", row.layout, row.schedule) } else { row.layout.clone() },
            layout: row.layout.clone(),
            schedule: row.schedule.clone(),
            ms: row.ms_per_step,
            interval: median_interval(own),
            spread: row.spread,
            ratio: row.ms_per_step / report.rows[best].ms_per_step,
            ratio_interval,
            is_level: n == best || own.len() < FEWEST as usize || ratio_interval[0] <= 1.0,
            outliers: own.iter().filter(|&&time| time < low - reach || time > high + reach).count(),
            slowest: own.iter().copied().fold(0.0, f64::max) / middle,
            kernels: row.kernels.0.clone(),
            bytes: row.bytes,
            state_error: row.state_error,
        }
    };
    order.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::super::tests::{report, row};
    use super::*;

    #[test]
    fn the_fastest_is_first_and_what_is_level_is_told() {
        let wave = |middle: f64| -> Vec<f64> { (0..11).map(|n| middle + 0.01 * f64::from(n * 7 % 11 - 5)).collect() };
        let mut off = wave(2.0);
        off[3] = 9.0;
        let report = report(vec![row("slow", 2.0), row("fast", 1.0), row("same", 1.005)]);
        // The same times, but for their order.
        let ranking = rank(&report, &[off, wave(1.0), wave(1.0).into_iter().rev().collect()]);
        let names: Vec<_> = ranking.iter().map(|one| (one.name.as_str(), one.is_level)).collect();
        assert_eq!(names, [("fast", true), ("same", true), ("slow", false)]);
        let slow = &ranking[2];
        assert_eq!((slow.outliers, slow.ratio), (1, 2.0));
        assert!((4.4..4.6).contains(&slow.slowest), "{slow:?}");
        assert!(slow.ratio_interval[0] > 1.9 && slow.ratio_interval[1] < 2.1 && slow.interval[1] < 2.1, "{slow:?}");
    }

    #[test]
    fn few_repetitions_tell_nothing() {
        let report = report(vec![row("fast", 1.0), row("slow", 2.0)]);
        let ranking = rank(&report, &[vec![1.0; 3], vec![2.0; 3]]);
        assert!(ranking.iter().all(|one| one.is_level));
    }
}
