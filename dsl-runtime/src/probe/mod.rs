//! What loops touch: counts of reads, writes and accumulations of each member, the cache lines that they lie in, and the misses of a modelled cache.
//!
//! Kernels are not changed for it. Where it is compiled in, with debug assertions or the feature `probe`, every access of a parallel loop asks whether its
//! thread records; elsewhere nothing of it is there. Under a recording loops run on the thread that records, so that the order of accesses, and with it every
//! number, is the same on every machine. What stands outside of parallel loops (`#[serial]` loops, single elements) is not counted.
//!
//! ```
//! use allotrope::prelude::*;
//! use allotrope::probe::{self, Access, Caches};
//!
//! #[kernel]
//! fn smooth(from: &Field<f32, _>, to: &mut Field<f32, _>) {
//!     for i in from.interior(1) {
//!         to[i] = (from[i - 1] + from[i + 1]) / 2.0;
//!     }
//! }
//!
//! if probe::AVAILABLE {
//!     let (from, mut to) = (Field::<f32, Aos>::new([1002]), Field::<f32, Aos>::new([1002]));
//!     let ((), recording) = probe::record(&Caches::default(), || smooth(&from, &mut to)).unwrap();
//!     let [row] = recording.loops.as_slice() else { panic!("one loop") };
//!     let of = |access| row.members.iter().filter(move |member| member.access == access);
//!     assert_eq!(of(Access::Read).map(|member| member.count).sum::<u64>(), 2 * 1000);
//!     assert_eq!(of(Access::Write).map(|member| member.count).sum::<u64>(), 1000);
//! }
//! ```

mod cache;
mod trace;

use core::cell::{Cell, RefCell};
use core::fmt;

pub use cache::{Cache, Caches};
pub(crate) use trace::{Region, Touch};

use trace::Trace;

/// Whether recordings are compiled in: they are with debug assertions, or with the feature `probe`.
pub const AVAILABLE: bool = cfg!(any(feature = "probe", debug_assertions));

/// Bytes of a cache line, for counts of lines.
pub const LINE: usize = 64;

/// What is done to a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Access {
    /// It is read.
    Read,
    /// It is written.
    Write,
    /// Something is accumulated into it: it is read and written.
    Accumulate,
}

impl fmt::Display for Access {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Read => "read",
            Self::Write => "write",
            Self::Accumulate => "accumulate",
        })
    }
}

/// How the index of an access follows from the loop's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Index {
    /// It is the loop's.
    Own,
    /// It lies at a constant offset from the loop's.
    Offset,
    /// It is computed.
    Computed,
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Own => "own",
            Self::Offset => "offset",
            Self::Computed => "computed",
        })
    }
}

/// What was recorded.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    /// The loops, in the order in which they were first launched.
    pub loops: Vec<LoopCounts>,
    /// Where in the memory of each field they were.
    pub heat: Vec<Heat>,
}

/// What a loop touched, summed over its launches.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopCounts {
    /// The kernel.
    pub kernel: &'static str,
    /// The loop's number among the parallel loops of its kernel, from 0.
    pub number: usize,
    /// How many times it was launched.
    pub launches: u64,
    /// Cache lines that two threads would both write if each ran half of the loop's blocks: what is called false sharing where they write different values.
    pub shared_lines: u64,
    /// Member by member, each kind of access apart.
    pub members: Vec<MemberCounts>,
}

/// What a loop did to a member by one kind of access, summed over its launches.
#[derive(Clone, Debug, PartialEq)]
pub struct MemberCounts {
    /// The field's parameter of the kernel.
    pub field: &'static str,
    /// The member's path in the record; empty for a bare element.
    pub member: &'static str,
    /// What was done.
    pub access: Access,
    /// By which index.
    pub index: Index,
    /// How many times.
    pub count: u64,
    /// Bytes of the values.
    pub bytes: u64,
    /// Distinct cache lines touched, counted in each launch.
    pub lines: u64,
    /// Distinct bytes touched, counted in each launch: `useful_bytes / lines` of [`LINE`] were of use.
    pub useful_bytes: u64,
    /// Misses of the modelled first-level and second-level cache. Both keep what earlier loops left in them.
    pub misses: [u64; 2],
}

impl MemberCounts {
    /// Bytes of use in a line, at most [`LINE`].
    pub fn useful_bytes_a_line(&self) -> f64 {
        if self.lines == 0 { 0.0 } else { self.useful_bytes as f64 / self.lines as f64 }
    }
}

/// How often each cache line of a field's memory was touched.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// The field's parameter of the kernel that touched it first. Fields that were first touched under one name follow one another.
    pub field: &'static str,
    /// Touches of each line of [`LINE`] bytes, in the order of memory; blocks of sparse fields in that in which they were first touched.
    pub touches: Vec<u32>,
}

/// Why nothing was recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecordError {
    /// Recordings are not compiled in.
    Unavailable,
    /// This thread records already.
    Busy,
    /// A cache of such a size cannot be modelled: what is wrong with it.
    Cache(String),
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unavailable => f.write_str(
                "accesses cannot be recorded: this was built without debug assertions and without the feature `probe`",
            ),
            Self::Busy => f.write_str("this thread records accesses already"),
            Self::Cache(why) => f.write_str(why),
        }
    }
}

impl core::error::Error for RecordError {}

thread_local! {
    static RECORDING: Cell<bool> = const { Cell::new(false) };
    static TRACE: RefCell<Option<Trace>> = const { RefCell::new(None) };
}

/// Whether this thread records.
#[inline(always)]
pub(crate) fn is_recording() -> bool {
    AVAILABLE && RECORDING.get()
}

/// Ends a recording, whatever happened.
struct Ending;

impl Drop for Ending {
    fn drop(&mut self) {
        RECORDING.set(false);
        TRACE.take();
    }
}

/// Does some work, and records what its parallel loops touch. They run on this thread.
///
/// # Errors
/// If recordings are not compiled in ([`AVAILABLE`]), if this thread records already, or if such caches cannot be modelled.
pub fn record<T>(caches: &Caches, work: impl FnOnce() -> T) -> Result<(T, Recording), RecordError> {
    if !AVAILABLE {
        return Err(RecordError::Unavailable);
    }
    if RECORDING.get() {
        return Err(RecordError::Busy);
    }
    let trace = Trace::new(caches).map_err(RecordError::Cache)?;
    TRACE.set(Some(trace));
    RECORDING.set(true);
    let ending = Ending;
    let result = work();
    let recording = TRACE.take().map(Trace::finish).unwrap_or_default();
    drop(ending);
    Ok((result, recording))
}

/// Does something with the trace of a thread that records.
fn with(work: impl FnOnce(&mut Trace)) {
    TRACE.with_borrow_mut(|trace| {
        if let Some(trace) = trace {
            work(trace);
        }
    });
}

/// Notes that a loop begins, which is the end of what is returned.
pub(crate) fn launch(kernel: &'static str, number: usize) -> impl Drop {
    struct Launch;
    impl Drop for Launch {
        fn drop(&mut self) {
            with(Trace::leave);
        }
    }
    with(|trace| trace.enter(kernel, number));
    Launch
}

/// Notes that the loop goes on with one of its blocks.
pub(crate) fn block(number: usize, of: usize) {
    with(|trace| trace.half = u8::from(2 * number >= of));
}

/// Notes an access.
pub(crate) fn touch(touch: &Touch) {
    with(|trace| trace.touch(touch));
}
