//! What processor and system count while a program runs: cycles, instructions, misses. Where the system does not let a program count, that is told.
//!
//! Counters are of the thread that opens them and of all threads that begin later, so that they are opened before any loop runs in parallel.

#[cfg(target_os = "linux")]
mod linux;
#[cfg(not(target_os = "linux"))]
mod missing;

#[cfg(target_os = "linux")]
use linux::Source;
#[cfg(not(target_os = "linux"))]
use missing::Source;

use super::table::four_digits;

/// What is counted, in the order in which it is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// Cycles of the processor, in user's code as all others.
    Cycles,
    /// Instructions that were retired.
    Instructions,
    /// Reads that missed the first cache.
    FirstMisses,
    /// Accesses that missed the last cache.
    LastMisses,
    /// Branches that were foreseen wrongly.
    BranchMisses,
    /// Pages that were touched the first time.
    PageFaults,
}

impl Event {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Cycles, Self::Instructions, Self::FirstMisses, Self::LastMisses, Self::BranchMisses, Self::PageFaults];

    /// Its name in tables and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cycles => "cycles",
            Self::Instructions => "instructions",
            Self::FirstMisses => "L1 misses",
            Self::LastMisses => "last-level misses",
            Self::BranchMisses => "branch misses",
            Self::PageFaults => "page faults",
        }
    }
}

/// How often something happened, and for which part of the time it was counted: a processor counts few things at once, and takes turns where more are
/// asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Reading {
    count: u64,
    /// Nanoseconds in which it was to be counted, and was.
    wanted: u64,
    counted: u64,
}

impl Reading {
    /// What happened between an earlier reading and this one, in proportion where it was counted for a part of the time; nothing where it was not at all.
    fn since(self, earlier: Self) -> Option<f64> {
        let part = |late: u64, early: u64| late.saturating_sub(early) as f64;
        let (wanted, counted) = (part(self.wanted, earlier.wanted), part(self.counted, earlier.counted));
        let scale = if counted > 0.0 { wanted / counted } else { 1.0 };
        (counted > 0.0 || wanted == 0.0).then(|| part(self.count, earlier.count) * scale)
    }
}

/// Counters that run.
#[derive(Debug)]
pub struct Counters {
    open: Vec<(Event, Source)>,
    refused: Vec<(Event, String)>,
}

impl Counters {
    /// Opens all that the system lets a program count, for this thread and those that begin later.
    pub fn open() -> Self {
        let mut counters = Self { open: Vec::new(), refused: Vec::new() };
        for event in Event::ALL {
            match Source::open(event) {
                Ok(source) => counters.open.push((event, source)),
                Err(why) => counters.refused.push((event, why)),
            }
        }
        counters
    }

    /// What is not counted, and why, in a line; nothing if all is.
    ///
    /// ```
    /// use allotrope_lab::lab::hardware::Counters;
    ///
    /// if let Some(line) = Counters::open().refused() {
    ///     assert!(line.starts_with("not counted: "));
    /// }
    /// ```
    pub fn refused(&self) -> Option<String> {
        let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
        for (event, why) in &self.refused {
            match reasons.iter_mut().find(|(known, _)| known == why) {
                Some((_, events)) => events.push(event.name()),
                None => reasons.push((why, vec![event.name()])),
            }
        }
        let reasons: Vec<String> = reasons.iter().map(|(why, names)| format!("{} ({why})", names.join(", "))).collect();
        (!reasons.is_empty()).then(|| format!("not counted: {}", reasons.join("; ")))
    }

    fn read(&mut self) -> Vec<(Event, Reading)> {
        self.open.iter_mut().filter_map(|(event, source)| Some((*event, source.read()?))).collect()
    }

    /// Does something, and counts what happens meanwhile.
    pub fn count<T>(&mut self, run: impl FnOnce() -> T) -> (T, Counted) {
        let before = self.read();
        let done = run();
        let after = self.read();
        let since = |(event, late): &(Event, Reading)| {
            let (_, early) = before.iter().find(|(known, _)| known == event)?;
            Some((*event, late.since(*early)?))
        };
        (done, Counted(after.iter().filter_map(since).collect()))
    }
}

/// How often things happened.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counted(Vec<(Event, f64)>);

impl Counted {
    /// How often something did, if it was counted.
    pub fn of(&self, event: Event) -> Option<f64> {
        self.0.iter().find(|(known, _)| *known == event).map(|(_, count)| *count)
    }

    /// Adds what happened another time. What was counted in one of them alone is left out.
    pub fn add(&mut self, other: &Self) {
        self.0.retain_mut(|(event, count)| other.of(*event).map(|more| *count += more).is_some());
    }

    /// Each with its name, over so many steps.
    pub fn per(&self, steps: u64) -> Vec<(String, f64)> {
        self.0.iter().map(|(event, count)| (event.name().to_string(), count / steps.max(1) as f64)).collect()
    }
}

/// A number in thousands, millions or billions.
pub(super) fn short(count: f64) -> String {
    match count {
        count if count >= 1e9 => format!("{} G", four_digits(count / 1e9)),
        count if count >= 1e6 => format!("{} M", four_digits(count / 1e6)),
        0.0 => "0".into(),
        count if count >= 1e4 => format!("{} k", four_digits(count / 1e3)),
        count => four_digits(count),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_counted_for_a_part_of_the_time_is_scaled() {
        let reading = |count, wanted, counted| Reading { count, wanted, counted };
        assert_eq!(reading(150, 300, 300).since(reading(50, 100, 100)), Some(100.0));
        assert_eq!(reading(150, 300, 200).since(reading(50, 100, 100)), Some(200.0), "half of the time");
        assert_eq!(reading(50, 300, 100).since(reading(50, 100, 100)), None, "not at all");
        assert_eq!(reading(50, 100, 100).since(reading(50, 100, 100)), Some(0.0), "no time went by");
    }

    #[test]
    fn counts_add_up_over_steps() {
        let mut counted = Counted(vec![(Event::Cycles, 100.0), (Event::PageFaults, 3.0)]);
        counted.add(&Counted(vec![(Event::Cycles, 50.0)]));
        assert_eq!(counted.per(3), [("cycles".to_string(), 50.0)]);
        assert_eq!([0.0, 5.0, 12_345.0, 2.5e6, 3e10].map(short), ["0", "5.000", "12.35 k", "2.500 M", "30.00 G"]);
    }

    #[test]
    fn what_cannot_be_counted_is_told_once_a_reason() {
        let refused = vec![
            (Event::Cycles, "no such device".to_string()),
            (Event::PageFaults, "not permitted".into()),
            (Event::Instructions, "no such device".into()),
        ];
        let line = Counters { open: Vec::new(), refused }.refused().unwrap();
        assert_eq!(line, "not counted: cycles, instructions (no such device); page faults (not permitted)");
        assert_eq!(Counters { open: Vec::new(), refused: Vec::new() }.refused(), None);
    }

    #[test]
    fn pages_that_threads_touch_are_counted_where_the_system_lets_us() {
        let mut counters = Counters::open();
        let bytes = 4096 * 1000;
        let ((), counted) = counters.count(|| {
            let touch = || std::hint::black_box(vec![1u8; bytes]).len();
            assert_eq!(touch(), bytes);
            std::thread::scope(|scope| assert_eq!(scope.spawn(touch).join().unwrap(), bytes));
        });
        match counted.of(Event::PageFaults) {
            // Pages may be larger where the system decides so, and are then few.
            Some(faults) => assert!(faults >= 1.0, "{faults}"),
            None => assert!(counters.refused().is_some_and(|line| line.contains("page faults")), "{counters:?}"),
        }
    }
}
