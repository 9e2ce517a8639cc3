//! The particles with which a scene starts.

use super::{Body, MOST_PARTICLES, SceneError};

/// The particles with which a scene starts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Particles {
    /// Positions in metres.
    pub x: Vec<[f64; 3]>,
    /// Velocities in metres a second.
    pub v: Vec<[f64; 3]>,
    /// Gradients of the velocity, `c[row][column]`, in 1/s.
    pub c: Vec<[[f64; 3]; 3]>,
    /// Of which of the scene's materials.
    pub material: Vec<u32>,
}

/// Fills bodies at a spacing in metres, one after the other. `check` refuses positions of a body whose first particle
/// has a number, with what is wrong with them.
pub(crate) fn fill(
    file: &str,
    bodies: &[Body],
    spacing: f64,
    dimensions: usize,
    check: impl Fn(&[[f64; 3]], usize) -> Result<(), String>,
) -> Result<Particles, SceneError> {
    let mut particles = Particles::default();
    for (n, body) in bodies.iter().enumerate() {
        let fault = |message: String| SceneError::at(file, format!("body[{n}]"), message);
        let first = particles.x.len();
        let positions = body.shape.fill(spacing, dimensions, MOST_PARTICLES - first).map_err(fault)?;
        if positions.is_empty() {
            return Err(fault("holds no particle; make it larger, or `spacing` smaller".into()));
        }
        check(&positions, first).map_err(fault)?;
        body.set_off(positions, &mut particles);
    }
    Ok(particles)
}
