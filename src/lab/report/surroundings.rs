//! Where a report was made.

use std::fs;

use super::date;
use crate::lab::machine;

/// Where and when, each fact with its name; what the system does not tell is left out.
#[derive(Clone, Debug)]
pub(in crate::lab) struct Surroundings {
    pub(in crate::lab) facts: Vec<(String, String)>,
    /// Programs that wanted to run before the measurement began, on average over a minute, where the system tells it.
    pub(in crate::lab) load: Option<f64>,
    /// Whether the processor is shared with other machines that cannot be seen.
    pub(in crate::lab) is_virtual: bool,
}

impl Surroundings {
    /// Those of this program, now.
    pub(super) fn here() -> Self {
        let told = |path: &str| fs::read_to_string(path).ok().map(|text| text.trim().to_string());
        let cpu = told("/proc/cpuinfo").unwrap_or_default();
        let is_virtual =
            cpu.lines().any(|line| line.starts_with("flags") && line.split(' ').any(|flag| flag == "hypervisor"));
        let load = told("/proc/loadavg").and_then(|text| text.split(' ').next()?.parse().ok());
        let mut facts = vec![("Date".to_string(), date::now()), ("Processor".into(), machine::processor())];
        let mut fact = |name: &str, value: Option<String>| facts.extend(value.map(|value| (name.to_string(), value)));
        fact("Logical processors", std::thread::available_parallelism().ok().map(|count| count.to_string()));
        fact("Caches of the first", caches());
        fact("Memory", told("/proc/meminfo").as_deref().and_then(memory));
        let kernel = told("/proc/sys/kernel/osrelease").map_or(String::new(), |release| format!(" {release}"));
        let virtually = if is_virtual { ", in a virtual machine" } else { "" };
        let (system, architecture) = (std::env::consts::OS, std::env::consts::ARCH);
        fact("System", Some(format!("{system}{kernel} on {architecture}{virtually}")));
        let checks =
            if cfg!(debug_assertions) { ", built with checks: times are not those of a release build" } else { "" };
        fact("Program", Some(format!("Allotrope {}{checks}", env!("CARGO_PKG_VERSION"))));
        fact("Compiler", Some(env!("ALLOTROPE_COMPILER").to_string()));
        Self { facts, load, is_virtual }
    }
}

/// Kinds and sizes of the first processor's caches: `L1 data 32K, L2 1024K`.
fn caches() -> Option<String> {
    let caches = (0..8).filter_map(|index| {
        let of =
            |what: &str| fs::read_to_string(format!("/sys/devices/system/cpu/cpu0/cache/index{index}/{what}")).ok();
        let (level, kind, size) = (of("level")?, of("type")?, of("size")?);
        let kind = match kind.trim() {
            "Unified" => String::new(),
            kind => format!(" {}", kind.to_lowercase()),
        };
        Some(format!("L{}{kind} {}", level.trim(), size.trim()))
    });
    let caches: Vec<String> = caches.collect();
    (!caches.is_empty()).then(|| caches.join(", "))
}

/// The memory of which `/proc/meminfo` tells.
fn memory(told: &str) -> Option<String> {
    let kibibytes: f64 =
        told.lines().find_map(|line| line.strip_prefix("MemTotal:"))?.split_whitespace().next()?.parse().ok()?;
    Some(format!("{:.1} GiB", kibibytes / f64::from(1 << 20)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn date_processor_and_program_are_told() {
        let here = Surroundings::here();
        let names: Vec<&str> = here.facts.iter().map(|(name, _)| &**name).collect();
        assert!(
            ["Date", "Processor", "System", "Program", "Compiler"].iter().all(|name| names.contains(name)),
            "{names:?}"
        );
        assert!(here.facts.iter().all(|(_, value)| !value.is_empty()));
        assert!(
            here.facts.iter().any(|(name, value)| name == "Compiler" && value.starts_with("rustc 1.")),
            "{:?}",
            here.facts
        );
    }

    #[test]
    fn memory_is_read() {
        assert_eq!(memory("MemTotal:       16777216 kB\nMemFree: 1 kB"), Some("16.0 GiB".into()));
        assert_eq!(memory("nothing"), None);
    }
}
