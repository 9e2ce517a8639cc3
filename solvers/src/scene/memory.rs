//! How much memory there is.

/// A size for a message.
pub(crate) fn gibibytes(bytes: f64) -> String {
    format!("{:.2} GiB", bytes / 1024f64.powi(3))
}

/// Bytes of memory that can be had without taking them from other programs, where the system tells (Linux).
pub fn available_memory() -> Option<u64> {
    available_of(&std::fs::read_to_string("/proc/meminfo").ok()?)
}

/// The line `MemAvailable:   24068212 kB` of a text such as `/proc/meminfo`, in bytes.
fn available_of(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    line.split_whitespace().next()?.parse::<u64>().ok()?.checked_mul(1024)
}
