//! Counters of Linux, by `perf_event_open`.

use std::io::ErrorKind;

use perf_event::events::{Cache, CacheId, CacheOp, CacheResult, Hardware, Software};
use perf_event::{Builder, Counter};

use super::{Event, Reading};

/// A counter.
#[derive(Debug)]
pub(super) struct Source(Counter);

impl Source {
    /// Opens it for this thread and those that begin later.
    ///
    /// # Errors
    /// The system's reason.
    pub(super) fn open(event: Event) -> Result<Self, String> {
        let first_misses = Cache { which: CacheId::L1D, operation: CacheOp::READ, result: CacheResult::MISS };
        let mut builder = match event {
            Event::Cycles => Builder::new(Hardware::CPU_CYCLES),
            Event::Instructions => Builder::new(Hardware::INSTRUCTIONS),
            Event::FirstMisses => Builder::new(first_misses),
            Event::LastMisses => Builder::new(Hardware::CACHE_MISSES),
            Event::BranchMisses => Builder::new(Hardware::BRANCH_MISSES),
            Event::PageFaults => Builder::new(Software::PAGE_FAULTS),
        };
        let mut open = || {
            let mut counter = builder.inherit(true).build()?;
            counter.enable()?;
            Ok(Self(counter))
        };
        open().map_err(|error: std::io::Error| match error.kind() {
            ErrorKind::NotFound | ErrorKind::Unsupported => {
                "the processor shows no such counter, as in many virtual machines".into()
            }
            ErrorKind::PermissionDenied => "not permitted, see `/proc/sys/kernel/perf_event_paranoid`".into(),
            _ => error.to_string(),
        })
    }

    /// What has been counted so far, if it can be read.
    pub(super) fn read(&mut self) -> Option<Reading> {
        let read = self.0.read_count_and_time().ok()?;
        Some(Reading { count: read.count, wanted: read.time_enabled, counted: read.time_running })
    }
}
