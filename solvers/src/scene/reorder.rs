//! When particles are sorted by cell.

use std::fmt;
use std::str::FromStr;

/// When the particles are sorted by cell: `0` for never, a number of steps, or `auto`, as scenes and options write it.
///
/// ```
/// use allotrope_solvers::scene::Reorder;
///
/// for reorder in [Reorder::Never, Reorder::Every(32), Reorder::Decayed] {
///     assert_eq!(reorder.to_string().parse(), Ok(reorder));
/// }
/// assert!("often".parse::<Reorder>().is_err());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reorder {
    /// Never.
    #[default]
    Never,
    /// Every so many steps, at least one.
    Every(u64),
    /// When neighbours in memory have drifted apart for so long that a sort pays.
    Decayed,
}

impl Reorder {
    /// Every so many steps; never, if there are none.
    pub fn every(steps: u64) -> Self {
        if steps == 0 { Self::Never } else { Self::Every(steps) }
    }
}

impl fmt::Display for Reorder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Never => f.write_str("0"),
            Self::Every(steps) => steps.fmt(f),
            Self::Decayed => f.write_str("auto"),
        }
    }
}

impl FromStr for Reorder {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "auto" {
            return Ok(Self::Decayed);
        }
        let steps = text.parse().map_err(|_| "a number of steps, 0 for never, or `auto` is wanted".to_string())?;
        Ok(Self::every(steps))
    }
}
