//! Materials of a scene.

use crate::mpm::materials::Model;

/// What bodies are of.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// By which bodies ask for it.
    pub name: String,
    /// At rest, in kg/m^3.
    pub density: f64,
    /// How it bears being deformed.
    pub model: Model,
}
