//! Where and how a simulation runs: processor, instruction set, threads, schedule.

use allotrope::{Scatter, Schedule};
use allotrope_solvers::nearest;

use super::errors::{LabError, panic_text};

/// A way of accumulating, by name.
#[derive(Clone, Copy, Debug)]
pub struct NamedSchedule {
    /// The name by which it is asked for.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    scatter: Scatter,
}

/// The schedules that can be asked for; the first is the default.
pub const SCHEDULES: &[NamedSchedule] = &[
    NamedSchedule { name: "auto", about: "chosen from threads, extents and work", scatter: Scatter::Auto },
    NamedSchedule { name: "serial", about: "accumulates on one thread, with plain adds", scatter: Scatter::Serial },
    NamedSchedule {
        name: "private",
        about: "each job accumulates into blocks of its own, which are then combined",
        scatter: Scatter::Private,
    },
    NamedSchedule {
        name: "colored",
        about: "elements are sorted by the tile they update; tiles that cannot meet run at once",
        scatter: Scatter::Colored,
    },
    NamedSchedule { name: "atomic", about: "compare-and-swap on each component", scatter: Scatter::Atomic },
];

impl NamedSchedule {
    /// The schedule of that name; if there is none, why.
    pub fn find(name: &str) -> Result<Self, String> {
        let names = SCHEDULES.iter().map(|schedule| schedule.name);
        SCHEDULES.iter().find(|schedule| schedule.name == name).copied().ok_or_else(|| {
            match nearest(name, names.clone()) {
                Some(near) => format!("there is no schedule `{name}`; did you mean `{near}`?"),
                None => {
                    format!("there is no schedule `{name}`; known are `{}`", names.collect::<Vec<_>>().join("`, `"))
                }
            }
        })
    }

    /// With that many threads, or as many as the runtime takes by default.
    pub fn with_threads(self, threads: Option<usize>) -> Schedule {
        Schedule { threads: threads.unwrap_or(0), scatter: self.scatter, ..Schedule::default() }
    }
}

/// How many threads loops take, if so many are asked for.
pub fn threads(asked: Option<usize>) -> usize {
    Schedule { threads: asked.unwrap_or(0), ..Schedule::default() }.thread_count()
}

/// The instruction set in use, in small letters.
pub fn instruction_set() -> String {
    Schedule::default().instruction_set().to_string()
}

/// Checks what the environment asks of the runtime, which panics at the first loop where it cannot be.
///
/// # Errors
/// The runtime's own words.
pub fn check() -> Result<(), LabError> {
    let asked = std::panic::catch_unwind(|| (threads(None), instruction_set()));
    asked.map(|_| ()).map_err(|payload| LabError::usage(panic_text(&*payload)))
}

/// The processor's own name, where the system tells it.
pub fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = told
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|(_, model)| model.trim().to_string()));
    model.unwrap_or_else(|| format!("{} processor", std::env::consts::ARCH))
}
