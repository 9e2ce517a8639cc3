//! Masses and springs as they are edited: checks, and who is near whom.

use std::collections::{HashMap, HashSet};
use std::fmt;

use allotrope::prelude::*;

use super::records::{Bond, Mass, Spring};

/// Why masses or springs are refused.
#[derive(Clone, Debug, PartialEq)]
pub enum EditError {
    /// A mass that is not above zero, or something of it that is not finite.
    Mass {
        /// Its place in the list.
        mass: usize,
        /// What is wrong.
        fault: String,
    },
    /// A spring that joins what it cannot join, or whose numbers make no sense.
    Spring {
        /// Its place in the list.
        spring: usize,
        /// What is wrong.
        fault: String,
    },
    /// The layout or the machine has no room for them.
    Room(String),
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mass { mass, fault } => write!(f, "mass {mass} {fault}"),
            Self::Spring { spring, fault } => write!(f, "spring {spring} {fault}"),
            Self::Room(fault) => f.write_str(fault),
        }
    }
}

impl std::error::Error for EditError {}

/// Checks masses that are to be added.
pub(super) fn check_masses(masses: &[Mass]) -> Result<(), EditError> {
    for (n, mass) in masses.iter().enumerate() {
        let fault = |fault: String| Err(EditError::Mass { mass: n, fault });
        if !(mass.mass > 0.0 && mass.mass.is_finite()) {
            return fault(format!("has a mass of {} kg, which is not above zero", mass.mass));
        }
        if !(mass.x + mass.v + mass.f).is_finite() {
            return fault(format!("is not finite: at {} with the velocity {}", mass.x, mass.v));
        }
    }
    Ok(())
}

/// Checks springs that are to be added to others between so many masses.
pub(super) fn check_springs(masses: usize, old: &[Spring], new: &[Spring]) -> Result<(), EditError> {
    let pair = |spring: &Spring| (spring.ends[0].min(spring.ends[1]), spring.ends[0].max(spring.ends[1]));
    let mut joined: HashSet<(u32, u32)> = old.iter().map(pair).collect();
    for (n, spring) in new.iter().enumerate() {
        let Spring { ends: [a, b], bond: Bond { stiffness, rest, dashpot } } = *spring;
        let fault = |fault: String| Err(EditError::Spring { spring: n, fault });
        if let Some(end) = [a, b].into_iter().find(|&end| end as usize >= masses) {
            return fault(format!("joins mass {end}, and there are {masses}"));
        }
        if a == b {
            return fault(format!("joins mass {a} with itself"));
        }
        if !joined.insert(pair(spring)) {
            return fault(format!("joins masses {a} and {b}, which are joined already"));
        }
        if !(stiffness > 0.0 && stiffness.is_finite()) {
            return fault(format!("has a stiffness of {stiffness} N/m, which is not above zero"));
        }
        for (name, value) in [("a length at rest", rest), ("a dashpot", dashpot)] {
            if !(value >= 0.0 && value.is_finite()) {
                return fault(format!("has {name} of {value}, which is not zero or above"));
            }
        }
    }
    Ok(())
}

/// All pairs of masses nearer than `radius` of which the second is one of those from `first` on, found in cells of that
/// width.
pub(super) fn pairs_within(x: &[DVec3], first: usize, radius: f64) -> Vec<[u32; 2]> {
    let cell = |x: DVec3| (x / radius).floor().to_array().map(|c| c as i64);
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut pairs = Vec::new();
    for (n, &at) in x.iter().enumerate() {
        if n >= first {
            let [i, j, k] = cell(at);
            let start = pairs.len();
            for (a, b, c) in (0..27).map(|n| (n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1)) {
                let near = cells.get(&[i + a, j + b, k + c]).into_iter().flatten();
                pairs.extend(near.filter(|&&m| x[m as usize].distance(at) < radius).map(|&m| [m, n as u32]));
            }
            pairs[start..].sort_unstable();
        }
        cells.entry(cell(at)).or_default().push(n as u32);
    }
    pairs
}
