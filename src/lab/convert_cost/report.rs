//! What a change of layouts costs and brings, for programs and for people.

use serde::{Deserialize, Serialize};

use crate::lab::bench::contender::Contender;
use crate::lab::machine;
use crate::lab::scene::size;
use crate::lab::statistics::{median, median_interval, spread};
use crate::lab::table::{Table, error_digits, four_digits, mebibytes, six_digits};

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
    /// The schedule of both.
    pub schedule: String,
    /// The layout in which a run is.
    pub from: Layout,
    /// The layout in which it may go on.
    pub to: Layout,
    /// What that costs and brings.
    pub change: Change,
}

/// A layout by itself.
#[derive(Debug, Deserialize, Serialize)]
pub struct Layout {
    /// Its name.
    pub layout: String,
    /// Median time a step.
    pub ms_per_step: f64,
    /// Interquartile range of the time a step over its median.
    pub spread: f64,
    /// Bytes of all fields.
    pub bytes: usize,
}

/// What a change costs and brings.
#[derive(Debug, Deserialize, Serialize)]
pub struct Change {
    /// Median time in which the state is read out of the fields of the first layout.
    pub read_ms: f64,
    /// Median time in which it is written into those of the second.
    pub write_ms: f64,
    /// Median time of both together.
    pub ms: f64,
    /// The median of what a step is shorter in the second layout, over pairs of repetitions; below zero, if it is longer.
    pub gain_ms: f64,
    /// An interval in which that median lies with 95 % confidence, as far as so many repetitions allow.
    pub gain_interval_ms: [f64; 2],
    /// After how many steps the change pays; none, if the second layout is not the faster one by more than the noise.
    pub pays_after: Option<u64>,
    /// The same for both ends of the interval: at the earliest and at the latest.
    pub pays_between: Option<[u64; 2]>,
}

impl Layout {
    pub(super) fn new(contender: &Contender) -> Self {
        Self {
            layout: contender.layout.to_string(),
            ms_per_step: six_digits(median(&contender.samples) + contender.sorting()),
            spread: six_digits(spread(&contender.samples)),
            bytes: contender.simulation.bytes(),
        }
    }
}

impl Change {
    pub(super) fn new(from: &Contender, to: &Contender, spent: &[Vec<f64>; 2]) -> Self {
        let sorting = from.sorting() - to.sorting();
        let gains: Vec<f64> = from.samples.iter().zip(&to.samples).map(|(from, to)| from - to + sorting).collect();
        Self::of(&gains, spent)
    }

    /// What follows from the gains of all repetitions in milliseconds a step, and from the times of reading and writing.
    fn of(gains: &[f64], [read, write]: &[Vec<f64>; 2]) -> Self {
        let both: Vec<f64> = read.iter().zip(write).map(|(read, write)| read + write).collect();
        let (ms, gain, [low, high]) = (median(&both), median(gains), median_interval(gains));
        // At least one step, since a gain is one of steps.
        let after = |gain: f64| (ms / gain).ceil().max(1.0) as u64;
        Self {
            read_ms: six_digits(median(read)),
            write_ms: six_digits(median(write)),
            ms: six_digits(ms),
            gain_ms: six_digits(gain),
            gain_interval_ms: [low, high].map(six_digits),
            pays_after: (low > 0.0).then(|| after(gain)),
            pays_between: (low > 0.0).then(|| [high, low].map(after)),
        }
    }
}

/// What the text tells beside the report.
pub(super) struct About {
    pub(super) verified: u64,
    pub(super) agreement: f64,
    pub(super) repetitions: u64,
    pub(super) steps: u64,
    pub(super) time: f64,
}

/// Machine and scene, what was checked, both layouts, and what a change costs and brings.
pub(super) fn text(report: &Report, about: &About) -> String {
    let mut table = Table::new(["layout", "ms/step", "spread", "ns/particle", "MiB"], 1);
    for layout in [&report.from, &report.to] {
        table.row([
            layout.layout.clone(),
            four_digits(layout.ms_per_step),
            format!("{:.1} %", 100.0 * layout.spread),
            format!("{:.1}", layout.ms_per_step * 1e6 / report.particles as f64),
            mebibytes(layout.bytes as u64),
        ]);
    }
    format!(
        "{} {}: {}\n{}, {} threads, {}, schedule {}\n\
         the state goes over whole, and both go on alike: after {} steps positions differ by at most {}\n\
         {} steps each, in {} interleaved repetitions, to {:.4} s\n\n{}\n{}{}",
        report.solver,
        report.scene,
        size(report.particles, "", &report.grid),
        machine::processor(),
        report.threads,
        report.isa,
        report.schedule,
        about.verified,
        error_digits(about.agreement),
        about.steps,
        about.repetitions,
        about.time,
        table.text(),
        cost(report),
        verdict(report)
    )
}

fn cost(Report { from, to, change, .. }: &Report) -> String {
    format!(
        "{} to {}: {} ms ({} ms to read the state, {} ms to write it), as long as {:.1} steps\n",
        from.layout,
        to.layout,
        four_digits(change.ms),
        four_digits(change.read_ms),
        four_digits(change.write_ms),
        change.ms / from.ms_per_step
    )
}

/// Whether and when it pays.
fn verdict(Report { from, to, change, .. }: &Report) -> String {
    let [low, high] = change.gain_interval_ms;
    match (change.pays_after, change.pays_between) {
        (Some(steps), Some([early, late])) => format!(
            "a step is shorter by {} ms ({} to {}): it pays after {steps} steps ({early} to {late})\n",
            four_digits(change.gain_ms),
            four_digits(low),
            four_digits(high)
        ),
        _ if high < 0.0 => format!(
            "it never pays: a step in {} is longer by {} ms ({} to {})\n",
            to.layout,
            four_digits(-change.gain_ms),
            four_digits(-high),
            four_digits(-low)
        ),
        _ => format!(
            "whether it pays cannot be told: between {} and {} a step differs by less than the noise ({} to {} ms)\n",
            from.layout,
            to.layout,
            four_digits(low),
            four_digits(high)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(gains: &[f64]) -> Report {
        let layout = |name: &str| Layout { layout: name.into(), ms_per_step: 2.0, spread: 0.01, bytes: 1 << 20 };
        Report {
            solver: "net".into(),
            scene: "cloth".into(),
            particles: 1000,
            grid: Vec::new(),
            threads: 1,
            isa: "avx2".into(),
            schedule: "auto".into(),
            from: layout("rows"),
            to: layout("flat"),
            change: Change::of(gains, &[vec![1.0, 2.0, 9.0], vec![3.0, 4.0, 3.0]]),
        }
    }

    #[test]
    fn a_change_pays_once_its_cost_is_gained() {
        let report = report(&[0.25, 0.125, 0.5, 0.25, 0.25]);
        let Change { read_ms, write_ms, ms, gain_ms, .. } = report.change;
        // Of each repetition its own sum.
        assert_eq!((read_ms, write_ms, ms, gain_ms), (2.0, 3.0, 6.0, 0.25));
        assert_eq!((report.change.pays_after, report.change.pays_between), (Some(24), Some([12, 48])));
        let about = About { verified: 10, agreement: 1e-9, repetitions: 5, steps: 100, time: 0.5 };
        let text = text(&report, &about);
        assert!(text.starts_with("net cloth: 1000 particles\n"), "{text}");
        assert!(text.contains(
            "rows to flat: 6.000 ms (2.000 ms to read the state, 3.000 ms to write it), as long as 3.0 steps\n"
        ));
        assert!(
            text.ends_with("a step is shorter by 0.2500 ms (0.1250 to 0.5000): it pays after 24 steps (12 to 48)\n")
        );
    }

    #[test]
    fn a_change_for_the_worse_never_pays() {
        let report = report(&[-0.25, -0.125, -0.5]);
        assert_eq!((report.change.pays_after, report.change.pays_between), (None, None));
        assert_eq!(verdict(&report), "it never pays: a step in flat is longer by 0.2500 ms (0.1250 to 0.5000)\n");
    }

    #[test]
    fn what_lies_within_the_noise_is_not_told_apart() {
        let report = report(&[0.25, -0.125, 0.5]);
        assert_eq!(report.change.pays_after, None);
        let wanted = "whether it pays cannot be told: between rows and flat a step differs by less than the noise \
                      (-0.1250 to 0.5000 ms)\n";
        assert_eq!(verdict(&report), wanted);
    }

    #[test]
    fn the_report_is_one_line_of_its_numbers() {
        let line = serde_json::to_string(&report(&[-1.0]).change).unwrap();
        let wanted = r#"{"read_ms":2.0,"write_ms":3.0,"ms":6.0,"gain_ms":-1.0,"gain_interval_ms":[-1.0,-1.0],"pays_after":null,"pays_between":null}"#;
        assert_eq!(line, wanted);
    }
}
