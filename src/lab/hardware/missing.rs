//! Systems whose counters this program does not know.

use super::{Event, Reading};

/// A counter that there is not.
#[derive(Debug)]
pub(super) enum Source {}

impl Source {
    /// # Errors
    /// Always.
    pub(super) fn open(_: Event) -> Result<Self, String> {
        Err("counters are known of Linux alone".into())
    }

    pub(super) fn read(&mut self) -> Option<Reading> {
        match *self {}
    }
}
