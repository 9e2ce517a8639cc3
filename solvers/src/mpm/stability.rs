//! The time step that a scene bears.

use super::MpmSetup;
use crate::SceneError;
use crate::scene::{Particles, Scene};

impl MpmSetup {
    /// The largest stable time step, in s, where the fastest particle has the given speed: `dx / (c sqrt(d) + v)`, where
    /// `c = sqrt(E / density)` is the speed of sound in `d` dimensions.
    ///
    /// A lone particle changes its volume as an oscillator of the angular frequency `w = 2 c sqrt(d) / dx` (the pressure
    /// turns into velocity gradient by `4 c^2 / dx^2`, and that into volume `d`-fold), and symplectic Euler is stable for
    /// `w dt < 2`; and it must not leave the nodes around it within a step.
    pub fn largest_step(&self, speed: f64) -> f64 {
        self.dx() / (self.sound() * (self.dimensions as f64).sqrt() + speed)
    }

    /// The speed of the fastest wave in m/s.
    fn sound(&self) -> f64 {
        let speeds = self.materials.iter().map(|material| (material.model.wave_modulus() / material.density).sqrt());
        speeds.fold(0.0, f64::max)
    }
}

/// The speed of the fastest in m/s.
pub(super) fn fastest(v: &[[f64; 3]]) -> f64 {
    let speed = |v: &[f64; 3]| v.iter().map(|component| component * component).sum::<f64>().sqrt();
    v.iter().map(speed).fold(0.0, f64::max)
}

/// Refuses a scene whose time step is unstable from the start.
pub(super) fn check(scene: &Scene, setup: &MpmSetup, particles: &Particles) -> Result<(), SceneError> {
    let fastest = fastest(&particles.v);
    let bound = setup.largest_step(fastest);
    if scene.dt <= bound {
        return Ok(());
    }
    let message = format!(
        "is unstable: with sound at {:.4}, particles at up to {fastest:.4} and cells of {:.6} it must be at most \
         {bound:.3e}",
        setup.sound(),
        setup.dx()
    );
    Err(scene.fault(format!("dt = {:e}", scene.dt), message))
}
