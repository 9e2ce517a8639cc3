//! From where a scene in space is looked at.

use super::SceneError;
use super::keys::Keys;

/// From where a scene in space is looked at: an orbit about the middle of the domain, in which the whole of it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPlace {
    /// Degrees around the vertical axis, from the third axis towards the first.
    pub azimuth: f64,
    /// Degrees above the horizon.
    pub elevation: f64,
    /// How much nearer than where the whole domain is seen; one: the whole.
    pub zoom: f64,
}

impl Default for CameraPlace {
    fn default() -> Self {
        Self { azimuth: 23.0, elevation: 20.0, zoom: 1.0 }
    }
}

pub(super) const KEYS: &[&str] = &["azimuth", "elevation", "zoom"];

impl CameraPlace {
    /// Reads a table `[camera]`.
    pub(super) fn read(keys: &Keys<'_>) -> Result<Self, SceneError> {
        let default = Self::default();
        let elevation = keys.number("elevation")?.unwrap_or(default.elevation);
        if !(-89.0 < elevation && elevation < 89.0) {
            return Err(keys.fault("elevation", "is not between -89 and 89 degrees, where up and down are seen"));
        }
        Ok(Self {
            azimuth: keys.number("azimuth")?.unwrap_or(default.azimuth),
            elevation,
            zoom: if keys.has("zoom") { keys.positive("zoom", "1.0")? } else { default.zoom },
        })
    }
}
