//! How launches run: threads, scatter strategy, determinism, instruction set. Not part of the algorithm.

use core::cell::Cell;
use core::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

use crate::launch::cpu::Cpu;

/// How updates of shared elements are made, so that none is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Scatter {
    /// Chosen from threads, extents and work: `Serial` on one thread or for little work; `Colored` where it is known how far updates reach
    /// and copies would cost more, since the field has many cells an element, or lies in no cache while the loop's order has
    /// nothing to do with it; else `Private` where the copies fit in memory, else `Serial` below ten threads and `Atomic` from there on.
    #[default]
    Auto,
    /// One thread, plain updates.
    Serial,
    /// Every job accumulates into a copy of its own; the copies are then combined in a fixed order.
    Private,
    /// The field is cut into tiles, and the loop's elements are sorted by the tile that they update. Tiles that cannot meet run at the same
    /// time, with plain updates; what lies beyond a tile's reach is kept and updated in the end. A loop whose tiles cannot be told
    /// before it runs is `Private` instead.
    Colored,
    /// Compare-and-swap on each component: 8 to 10 times the cost of a plain update.
    Atomic,
}

impl fmt::Display for Scatter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Auto => "auto",
            Self::Serial => "serial",
            Self::Private => "private",
            Self::Colored => "colored",
            Self::Atomic => "atomic",
        })
    }
}

impl FromStr for Scatter {
    type Err = String;
    fn from_str(name: &str) -> Result<Self, String> {
        Ok(match name {
            "auto" => Self::Auto,
            "serial" => Self::Serial,
            "private" => Self::Private,
            "colored" => Self::Colored,
            "atomic" => Self::Atomic,
            _ => {
                return Err(format!(
                    "`{name}` is no schedule: it is `auto`, `serial`, `private`, `colored` or `atomic`"
                ));
            }
        })
    }
}

/// How the launches of a closure run.
///
/// ```
/// use allotrope::prelude::*;
///
/// #[kernel]
/// fn total(u: &Field<f32, _>) -> f32 {
///     let mut total = 0.0;
///     for i in u {
///         total += u[i];
///     }
///     total
/// }
/// let mut u = Field::<f32, Aos>::new([1000]);
/// u.fill(0.1);
/// let one = Schedule { threads: 1, ..Schedule::default() }.run(|| total(&u));
/// let two = Schedule { threads: 2, ..Schedule::default() }.run(|| total(&u));
/// assert_eq!(one.to_bits(), two.to_bits()); // reductions have a fixed order
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Schedule {
    /// How many threads; 0 for `ALLOTROPE_THREADS`, or else all that the machine has.
    pub threads: usize,
    /// How shared elements are updated.
    pub scatter: Scatter,
    /// The least elements that are worth a thread's while; 0 for a default.
    pub grain: usize,
    /// Whether results must be the same bits for any number of threads.
    pub deterministic: bool,
    /// The instruction set; `None` for `ALLOTROPE_CPU`, or else the best that the machine has.
    pub cpu: Option<Cpu>,
}

thread_local! {
    static CURRENT: Cell<Schedule> = const {
        Cell::new(Schedule { threads: 0, scatter: Scatter::Auto, grain: 0, deterministic: false, cpu: None })
    };
    /// Whether this thread is inside of a launch.
    static INSIDE: Cell<bool> = const { Cell::new(false) };
}

/// The most threads that a launch uses.
pub const MAX_THREADS: usize = 256;

impl Schedule {
    /// Calls `work` with this schedule for all launches that it makes on this thread, and restores the former one after.
    ///
    /// # Panics
    /// Where `cpu` asks for an instruction set that the processor lacks, or `threads` is above [`MAX_THREADS`].
    pub fn run<T>(&self, work: impl FnOnce() -> T) -> T {
        struct Restore(Schedule);
        impl Drop for Restore {
            fn drop(&mut self) {
                CURRENT.set(self.0);
            }
        }
        if let Some(cpu) = self.cpu {
            assert!(cpu.available(), "this processor lacks the instruction set `{cpu}`");
        }
        assert!(self.threads <= MAX_THREADS, "{} threads: at most {MAX_THREADS} are supported", self.threads);
        let _restore = Restore(CURRENT.replace(*self));
        work()
    }

    /// The schedule in force on this thread.
    pub fn current() -> Self {
        CURRENT.get()
    }

    /// How many threads its launches use: what it says, else `ALLOTROPE_THREADS`, else all.
    ///
    /// # Panics
    /// Where `ALLOTROPE_THREADS` is no number from 1 to [`MAX_THREADS`].
    pub fn thread_count(&self) -> usize {
        static DEFAULT: OnceLock<usize> = OnceLock::new();
        if self.threads > 0 {
            return self.threads;
        }
        *DEFAULT.get_or_init(|| match std::env::var("ALLOTROPE_THREADS") {
            Ok(text) => match text.parse() {
                Ok(threads @ 1..=MAX_THREADS) => threads,
                _ => panic!("ALLOTROPE_THREADS={text}: give a number of threads from 1 to {MAX_THREADS}"),
            },
            Err(_) => std::thread::available_parallelism().map_or(1, |n| n.get().min(MAX_THREADS)),
        })
    }

    /// The instruction set that its launches use: what it says, else `ALLOTROPE_CPU`, else the best there is.
    ///
    /// # Panics
    /// Where `ALLOTROPE_CPU` names no instruction set, or one that the processor lacks.
    pub fn instruction_set(&self) -> Cpu {
        self.cpu.unwrap_or_else(Cpu::chosen)
    }
}

/// Marks this thread as inside of a launch while it lives.
pub(crate) struct Inside(bool);

impl Inside {
    pub(crate) fn enter() -> Self {
        Self(INSIDE.replace(true))
    }
    pub(crate) fn now() -> bool {
        INSIDE.get()
    }
}
impl Drop for Inside {
    fn drop(&mut self) {
        INSIDE.set(self.0);
    }
}

/// Runs a job on a pool's thread under the schedule of the launch that made it.
pub(crate) fn inherit<T>(schedule: Schedule, job: impl FnOnce() -> T) -> T {
    struct Restore(Schedule);
    impl Drop for Restore {
        fn drop(&mut self) {
            CURRENT.set(self.0);
        }
    }
    let _restore = Restore(CURRENT.replace(schedule));
    job()
}
