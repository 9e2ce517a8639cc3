//! From where a scene in space is looked at.

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
