//! One computation in several ways, for instance a kernel in several layouts: calls are interleaved, so that a change of
//! the machine's speed meets all of them alike.

use std::time::{Duration, Instant};

use super::chart::{Bar, BarChart};
use super::errors::LabError;
use super::machine;
use super::statistics::{median, quantile, spread};
use super::table::{Table, error_digits, four_digits, mebibytes};

/// A repetition makes as many calls as take so long: then neither the clock nor a single interrupt counts.
const REPETITION: Duration = Duration::from_millis(5);

/// How far results may differ, as a part of the largest value, if nothing else is told: sums in another order.
const TOLERANCE: f64 = 1e-5;

/// What is to be compared.
///
/// ```
/// use allotrope_lab::lab::compare::Comparison;
///
/// let values: Vec<f64> = (0..1000).map(f64::from).collect();
/// let rows: Vec<f64> = values.iter().flat_map(|&value| [value, 0.0]).collect();
/// let mut comparison = Comparison::new("doubling", 1000);
/// comparison
///     .add_with("as it is", 8000, values, |x| x.iter_mut().for_each(|x| *x *= 2.0), Clone::clone)
///     .add_with(
///         "with gaps",
///         16000,
///         rows,
///         |x| x.iter_mut().step_by(2).for_each(|x| *x *= 2.0),
///         |x| x.iter().step_by(2).copied().collect(),
///     );
/// let results = comparison.run(5)?;
/// assert_eq!(results.timings[0].samples.len(), 5);
/// print!("{}", results.table());
/// # Ok::<(), allotrope_lab::lab::errors::LabError>(())
/// ```
pub struct Comparison<'a> {
    title: String,
    elements: usize,
    tolerance: f64,
    contenders: Vec<Contender<'a>>,
}

/// One of the ways.
struct Contender<'a> {
    name: String,
    bytes: usize,
    way: Box<dyn Way + 'a>,
}

/// What is called, and what it makes.
trait Way {
    fn call(&mut self);
    /// What the calls so far have made, if it is told.
    fn result(&self) -> Option<Vec<f64>>;
}

/// A way that keeps to itself what it makes.
struct Untold<C>(C);

impl<C: FnMut()> Way for Untold<C> {
    fn call(&mut self) {
        (self.0)();
    }
    fn result(&self) -> Option<Vec<f64>> {
        None
    }
}

/// A way whose results are compared with the others'.
struct Told<T, C, R> {
    state: T,
    call: C,
    result: R,
}

impl<T, C: FnMut(&mut T), R: Fn(&T) -> Vec<f64>> Way for Told<T, C, R> {
    fn call(&mut self) {
        (self.call)(&mut self.state);
    }
    fn result(&self) -> Option<Vec<f64>> {
        Some((self.result)(&self.state))
    }
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
        Self { title: title.into(), elements, tolerance: TOLERANCE, contenders: Vec::new() }
    }

    /// How far values of results may differ, as a part of the largest of them: 1e-5 unless told.
    pub fn within(&mut self, tolerance: f64) -> &mut Self {
        self.tolerance = tolerance;
        self
    }

    /// Adds one of the ways, with the bytes of all that it works on: `call` changes the state, and `result` tells what it has made after some calls,
    /// which must be the same in all ways, in the same order.
    pub fn add_with<T: 'a>(
        &mut self,
        name: impl Into<String>,
        bytes: usize,
        state: T,
        call: impl FnMut(&mut T) + 'a,
        result: impl Fn(&T) -> Vec<f64> + 'a,
    ) -> &mut Self {
        self.contenders.push(Contender { name: name.into(), bytes, way: Box::new(Told { state, call, result }) });
        self
    }

    /// Adds one of the ways whose results nobody compares. What a call computes has to be kept, for instance in a field: a compiler leaves out what
    /// nobody sees.
    pub fn add(&mut self, name: impl Into<String>, bytes: usize, call: impl FnMut() + 'a) -> &mut Self {
        self.contenders.push(Contender { name: name.into(), bytes, way: Box::new(Untold(call)) });
        self
    }

    /// Calls each twice, which touches its memory and tells how many calls make a repetition; compares what they have made; then measures so many
    /// repetitions of each, at least one.
    ///
    /// # Errors
    /// If results differ by more than the tolerance: names both ways, the value's place and the difference.
    pub fn run(&mut self, repetitions: usize) -> Result<Results, LabError> {
        let mut timings = Vec::new();
        let mut calls = Vec::new();
        for Contender { name, bytes, way } in &mut self.contenders {
            way.call();
            let start = Instant::now();
            way.call();
            let once = start.elapsed().max(Duration::from_nanos(1));
            calls.push((REPETITION.as_nanos().div_ceil(once.as_nanos()) as u32).max(1));
            timings.push(Timing { name: name.clone(), bytes: *bytes, samples: Vec::new() });
        }
        let agreement = self.verify()?;
        let count = self.contenders.len();
        for repetition in 0..repetitions.max(1) {
            // Each begins a round in turn, so that none always follows the same one.
            for n in (0..count).map(|n| (repetition + n) % count) {
                let way = &mut self.contenders[n].way;
                let start = Instant::now();
                for _ in 0..calls[n] {
                    way.call();
                }
                timings[n].samples.push(1e3 * start.elapsed().as_secs_f64() / f64::from(calls[n]));
            }
        }
        Ok(Results { title: self.title.clone(), elements: self.elements, agreement, timings })
    }

    /// The largest difference of a value from that of the first way that tells its results, as a part of the largest value; nothing where fewer than
    /// two tell theirs.
    fn verify(&self) -> Result<Option<f64>, LabError> {
        let mut told = self.contenders.iter().filter_map(|one| Some((&one.name, one.way.result()?)));
        let Some((first, wanted)) = told.next() else { return Ok(None) };
        let largest = wanted.iter().fold(f64::MIN_POSITIVE, |largest, value| largest.max(value.abs()));
        let mut agreement = None;
        for (name, values) in told {
            let fault =
                |why: String| Err(LabError::failure(format!("`{name}` does not make what `{first}` does: {why}")));
            if values.len() != wanted.len() {
                return fault(format!("{} values, not {}", values.len(), wanted.len()));
            }
            for (place, (&value, &other)) in values.iter().zip(&wanted).enumerate() {
                // What is no number in both is the same.
                let difference = if value.to_bits() == other.to_bits() { 0.0 } else { (value - other).abs() / largest };
                if difference.is_nan() || difference > self.tolerance {
                    return fault(format!("value {place} is {value:e}, not {other:e}"));
                }
                agreement = Some(difference.max(agreement.unwrap_or(0.0)));
            }
            agreement = agreement.or(Some(0.0));
        }
        Ok(agreement)
    }
}

/// What a comparison found.
#[derive(Clone, Debug)]
pub struct Results {
    /// What was compared.
    pub title: String,
    /// The elements that a call works on.
    pub elements: usize,
    /// By how much results differ, at most, as a part of the largest value; nothing where fewer than two ways tell theirs.
    pub agreement: Option<f64>,
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
        let agreement = match self.agreement {
            None => "results were not compared".to_string(),
            Some(part) => format!("results differ by at most {} of the largest", error_digits(part)),
        };
        format!(
            "{title}: {} elements\n{}, {repetitions} interleaved repetitions\n{agreement}\n\n{}",
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
        Results { title: "a kernel".into(), elements: 1000, agreement: Some(0.0), timings }
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
        let results = Comparison::new("", 1).add("a", 0, slow('a')).add("b", 0, slow('b')).run(3).unwrap();
        // Two calls of each to begin with, then three rounds.
        assert_eq!(order.borrow().iter().collect::<String>(), "aabbabbaab");
        assert!(results.timings.iter().all(|timing| timing.samples.len() == 3 && timing.median() >= 5.0));
    }

    #[test]
    fn results_are_compared_before_anything_is_timed() {
        let results = |add: f64| {
            let mut comparison = Comparison::new("sums", 3);
            comparison
                .add_with("aos", 0, vec![0.0; 3], |x| x.iter_mut().for_each(|x| *x += 2.0), Clone::clone)
                .add("untold", 0, || {})
                .add_with("soa", 0, vec![0.0, 0.0, add], |x| x.iter_mut().for_each(|x| *x += 2.0), Clone::clone);
            comparison.run(1)
        };
        assert_eq!(results(0.0).unwrap().agreement, Some(0.0));
        let near = results(4e-6).unwrap();
        assert!(
            (near.agreement.unwrap() - 1e-6).abs() < 1e-12 && near.table().contains("at most 1.0e-6 of"),
            "{near:?}"
        );
        let error = results(1.0).unwrap_err().to_string();
        assert_eq!(error, "`soa` does not make what `aos` does: value 2 is 5e0, not 4e0");
        assert!(results(f64::NAN).is_err());
        let mut loose = Comparison::new("lengths", 1);
        loose.within(1.0).add_with("one", 0, vec![1.0], |_| {}, Clone::clone);
        let error = loose.add_with("two", 0, vec![1.0, 1.0], |_| {}, Clone::clone).run(1).unwrap_err().to_string();
        assert_eq!(error, "`two` does not make what `one` does: 2 values, not 1");
        assert!(Comparison::new("", 1).add("", 0, || {}).run(1).unwrap().table().contains("results were not compared"));
    }

    #[test]
    fn short_calls_are_repeated() {
        let mut calls = 0;
        let start = Instant::now();
        let results = Comparison::new("", 1).add("count", 0, || calls += std::hint::black_box(1)).run(2).unwrap();
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
        assert_eq!(lines.next(), Some("results differ by at most 0 of the largest"));
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
