//! The time step that the fluid bears.

use crate::SceneError;
use crate::scene::{Particles, Scene};

/// The largest stable time step of a scene whose fastest particle has the given speed: `dx / (c sqrt(d) + v)`, where
/// `c = sqrt(E / density)` is the speed of sound in `d` dimensions.
///
/// A lone particle changes its volume as an oscillator of the angular frequency `w = 2 c sqrt(d) / dx` (the pressure
/// turns into velocity gradient by `4 c^2 / dx^2`, and that into volume `d`-fold), and symplectic Euler is stable for
/// `w dt < 2`; and it must not leave the nodes around it within a step.
pub fn largest_step(scene: &Scene, speed: f64) -> f64 {
    scene.dx() / (sound(scene) * (scene.dimensions as f64).sqrt() + speed)
}

/// The speed of the fastest wave in m/s.
fn sound(scene: &Scene) -> f64 {
    scene.materials.iter().map(|material| (material.model.wave_modulus() / material.density).sqrt()).fold(0.0, f64::max)
}

/// Refuses a scene whose time step is unstable from the start.
pub(super) fn check(scene: &Scene, particles: &Particles) -> Result<(), SceneError> {
    let speed = |v: &[f64; 3]| v.iter().map(|component| component * component).sum::<f64>().sqrt();
    let fastest = particles.v.iter().map(speed).fold(0.0, f64::max);
    let bound = largest_step(scene, fastest);
    if scene.dt <= bound {
        return Ok(());
    }
    let sound = sound(scene);
    let message = format!(
        "is unstable: with sound at {sound:.4}, particles at up to {fastest:.4} and cells of {:.6} it must be at most \
         {bound:.3e}",
        scene.dx()
    );
    Err(scene.fault(format!("dt = {:e}", scene.dt), message))
}
