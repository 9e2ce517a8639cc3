//! One computation in several ways, for instance a kernel in several layouts: calls are interleaved, so that a change of
//! the machine's speed meets all of them alike.

use std::time::{Duration, Instant};

use super::chart::{Bar, BarChart};
use super::errors::LabError;
use super::machine;
use super::statistics::{median, quantile, spread};
use super::table::{Table, four_digits, mebibytes};

/// A repetition makes as many calls as take so long: then neither the clock nor a single interrupt counts.
const REPETITION: Duration = Duration::from_millis(5);

/// What is to be compared.
///
/// ```
/// use allotrope_lab::lab::compare::Comparison;
///
/// let (mut few, mut many) = (vec![1.0f32; 1000], vec![1.0f32; 2000]);
/// let results = Comparison::new("doubling", 1000)
///     .add("as it is", 4000, || few.iter_mut().for_each(|x| *x *= 2.0))
///     .add("with gaps", 8000, || many.iter_mut().step_by(2).for_each(|x| *x *= 2.0))
///     .run(5);
/// assert_eq!(results.timings[0].samples.len(), 5);
/// print!("{}", results.table());
/// ```
pub struct Comparison<'a> {
    title: String,
    elements: usize,
    contenders: Vec<Contender<'a>>,
}

/// One of the ways.
struct Contender<'a> {
    name: String,
    bytes: usize,
    call: Box<dyn FnMut() + 'a>,
}

/// The times of one of the ways.
#[derive(Clone, Debug)]
pub struct Timing {
    /// Its name.
    pub name: String,
    /// Bytes of all that it works on.
    pub bytes: usize,
    /// Milliseconds a call in each repetition.
    pub samples: Vec<f64>,
}

impl Timing {
    /// The median time of a call in milliseconds.
    pub fn median(&self) -> f64 {
        median(&self.samples)
    }
}

impl<'a> Comparison<'a> {
    /// A comparison of nothing yet. Each call is to work on so many elements.
    pub fn new(title: impl Into<String>, elements: usize) -> Self {
        Self { title: title.into(), elements, contenders: Vec::new() }
    }

    /// Adds one of the ways, with the bytes of all that it works on. What a call computes has to be kept, for instance
    /// in a field: a compiler leaves out what nobody sees.
    pub fn add(&mut self, name: impl Into<String>, bytes: usize, call: impl FnMut() + 'a) -> &mut Self {
        self.contenders.push(Contender { name: name.into(), bytes, call: Box::new(call) });
        self
    }

    /// Calls each twice, which touches its memory and tells how many calls make a repetition; then measures so many
    /// repetitions of each, at least one.
    pub fn run(&mut self, repetitions: usize) -> Results {
        let mut timings = Vec::new();
        let mut calls = Vec::new();
        for Contender { name, bytes, call } in &mut self.contenders {
            call();
            let start = Instant::now();
            call();
            let once = start.elapsed().max(Duration::from_nanos(1));
            calls.push((REPETITION.as_nanos().div_ceil(once.as_nanos()) as u32).max(1));
            timings.push(Timing { name: name.clone(), bytes: *bytes, samples: Vec::new() });
        }
        let count = self.contenders.len();
        for repetition in 0..repetitions.max(1) {
            // Each begins a round in turn, so that none always follows the same one.
            for n in (0..count).map(|n| (repetition + n) % count) {
                let call = &mut self.contenders[n].call;
                let start = Instant::now();
                for _ in 0..calls[n] {
                    call();
                }
                timings[n].samples.push(1e3 * start.elapsed().as_secs_f64() / f64::from(calls[n]));
            }
        }
        Results { title: self.title.clone(), elements: self.elements, timings }
    }
}

/// What a comparison found.
#[derive(Clone, Debug)]
pub struct Results {
    /// What was compared.
    pub title: String,
    /// The elements that a call works on.
    pub elements: usize,
    /// In the order in which they were added.
    pub timings: Vec<Timing>,
}

impl Results {
    /// The fastest by its median, if there is any.
    pub fn best(&self) -> Option<&Timing> {
        self.timings.iter().min_by(|a, b| a.median().total_cmp(&b.median()))
    }

    /// How many times as long as the best a call takes.
    fn ratio(&self, timing: &Timing) -> f64 {
        timing.median() / self.best().map_or(f64::NAN, Timing::median)
    }

    /// Where it was measured: processor, threads, instruction set.
    fn machine() -> String {
        let threads = machine::threads(None);
        let plural = if threads == 1 { "thread" } else { "threads" };
        format!("{}, {threads} {plural}, {}", machine::processor(), machine::instruction_set())
    }

    fn repetitions(&self) -> usize {
        self.timings.first().map_or(0, |timing| timing.samples.len())
    }

    /// The machine, and a table of all times: the median of a call, the interquartile range over it, the time of an
    /// element, the memory, and how many times as long as the best.
    pub fn table(&self) -> String {
        let mut table = Table::new(["layout", "ms/call", "spread", "ns/element", "MiB", "ratio"], 1);
        for timing in &self.timings {
            table.row([
                timing.name.clone(),
                four_digits(timing.median()),
                format!("{:.1} %", 100.0 * spread(&timing.samples)),
                four_digits(1e6 * timing.median() / self.elements as f64),
                mebibytes(timing.bytes as u64),
                format!("{:.2}", self.ratio(timing)),
            ]);
        }
        let (title, repetitions) = (&self.title, self.repetitions());
        format!(
            "{title}: {} elements\n{}, {repetitions} interleaved repetitions\n\n{}",
            self.elements,
            Self::machine(),
            table.text()
        )
    }

    /// The medians as a bar chart, an SVG picture; whiskers reach from the lower to the upper quartile.
    ///
    /// # Errors
    /// If the picture cannot be drawn.
    pub fn chart(&self) -> Result<String, LabError> {
        let best = self.best().map(Timing::median);
        let bar = |timing: &Timing| Bar {
            name: timing.name.clone(),
            value: timing.median(),
            range: [0.25, 0.75].map(|fraction| quantile(&timing.samples, fraction)),
            label: format!("{} ms", four_digits(timing.median())),
            note: format!("{:.2} x", self.ratio(timing)),
            accented: best == Some(timing.median()),
        };
        let repetitions = self.repetitions();
        BarChart {
            title: self.title.clone(),
            subtitle: Self::machine(),
            axis: format!("milliseconds a call, median and quartiles of {repetitions} repetitions"),
            bars: self.timings.iter().map(bar).collect(),
        }
        .svg()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    fn results(samples: [&[f64]; 2]) -> Results {
        let timing =
            |name: &str, samples: &[f64]| Timing { name: name.into(), bytes: 3 << 19, samples: samples.into() };
        let timings = vec![timing("aos", samples[0]), timing("soa", samples[1])];
        Results { title: "a kernel".into(), elements: 1000, timings }
    }

    #[test]
    fn calls_are_interleaved_and_begin_in_turn() {
        let order = RefCell::new(Vec::new());
        let slow = |name| {
            let order = &order;
            move || {
                order.borrow_mut().push(name);
                std::thread::sleep(REPETITION);
            }
        };
        let results = Comparison::new("", 1).add("a", 0, slow('a')).add("b", 0, slow('b')).run(3);
        // Two calls of each to begin with, then three rounds.
        assert_eq!(order.borrow().iter().collect::<String>(), "aabbabbaab");
        assert!(results.timings.iter().all(|timing| timing.samples.len() == 3 && timing.median() >= 5.0));
    }

    #[test]
    fn short_calls_are_repeated() {
        let mut calls = 0;
        let start = Instant::now();
        let results = Comparison::new("", 1).add("count", 0, || calls += std::hint::black_box(1)).run(2);
        let spent = start.elapsed().as_secs_f64() * 1e3;
        // All that was not spent on the first two calls went into the repetitions.
        let measured: f64 = results.timings[0].samples.iter().sum::<f64>() * f64::from((calls - 2) / 2);
        assert!(calls > 1000 && measured <= spent, "{calls} calls, {measured} of {spent} ms");
    }

    #[test]
    fn the_table_tells_median_spread_and_ratio() {
        let table = results([&[3.0, 2.0, 4.0], &[1.5, 1.5, 1.5]]).table();
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some("a kernel: 1000 elements"));
        assert!(lines.next().is_some_and(|line| line.ends_with(", 3 interleaved repetitions")), "{table}");
        let rest: Vec<&str> = lines.skip(1).collect();
        let wanted = [
            "layout  ms/call  spread  ns/element   MiB  ratio",
            "aos       3.000  33.3 %        3000  1.50   2.00",
            "soa       1.500   0.0 %        1500  1.50   1.00",
        ];
        assert_eq!(rest, wanted);
    }

    #[test]
    fn the_best_is_that_of_the_smallest_median() {
        let results = results([&[1.0, 9.0, 9.0], &[5.0, 5.0, 5.0]]);
        assert_eq!(results.best().map(|timing| timing.name.as_str()), Some("soa"));
        assert!(results.chart().unwrap().contains("1.80 x"));
    }
}
