//! What the system tells a run: that it is to end, or that a file became too long.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use super::errors::{LabError, SIGNAL};

/// Whether the run was asked to end, by Ctrl-C or by the system.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    /// The number of the signal; zero for none.
    asked: Arc<AtomicUsize>,
}

impl Signals {
    /// Listens from now on. The first signal is noted, and a second one ends the program at once.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn listen() -> Result<Self, LabError> {
        let signals = Self::default();
        let again = Arc::new(AtomicBool::new(false));
        for signal in [SIGINT, SIGTERM] {
            // In this order: a signal ends the program if one was noted before.
            flag::register_conditional_shutdown(signal, i32::from(SIGNAL) | signal, Arc::clone(&again))
                .and_then(|_| flag::register(signal, Arc::clone(&again)))
                .and_then(|_| flag::register_usize(signal, Arc::clone(&signals.asked), signal as usize))
                .map_err(|error| LabError::machine(format!("signals cannot be listened to: {error}")))?;
        }
        Ok(signals)
    }

    /// The number of the signal that asked the run to end.
    pub fn asked(&self) -> Option<u8> {
        match self.asked.load(Ordering::Relaxed) {
            0 => None,
            signal => Some(signal as u8),
        }
    }
}

/// Makes a file that grows over the limit of its size an error of writing, as a full disk is; by default the system
/// would end the program without a word.
///
/// # Errors
/// If the system refuses.
#[cfg(unix)]
pub fn tell_limits() -> Result<(), LabError> {
    flag::register(signal_hook::consts::SIGXFSZ, Arc::default())
        .map(|_| ())
        .map_err(|error| LabError::machine(format!("signals cannot be listened to: {error}")))
}

/// Only Unix has such limits.
///
/// # Errors
/// None.
#[cfg(not(unix))]
pub fn tell_limits() -> Result<(), LabError> {
    Ok(())
}
