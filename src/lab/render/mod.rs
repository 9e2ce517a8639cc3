//! Pictures of particles.

mod canvas;
mod colour;
mod plane;
mod space;

use allotrope_solvers::{Scene, Simulation};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

use super::errors::LabError;
use canvas::Canvas;

/// Pixels along the longer side of a picture.
const SIDE: usize = 800;

/// How a simulation is looked at: the same for all pictures of a run, the scale of colours too.
#[derive(Clone, Debug)]
pub struct Camera {
    /// The speed in m/s at the upper end of the scale of colours.
    top_speed: f64,
}

impl Camera {
    /// A camera for a simulation that has just begun. Its scale of colours ends at the speed that the fastest particle
    /// would have after falling all the way.
    pub fn new(simulation: &dyn Simulation, scene: &Scene) -> Self {
        let fastest = simulation.velocities().iter().map(length).fold(0.0, f64::max);
        let fall =
            simulation.extent().iter().zip(&scene.gravity).map(|(extent, gravity)| extent * gravity.abs()).sum::<f64>();
        let top_speed = (fastest * fastest + 2.0 * fall).sqrt();
        Self { top_speed: if top_speed > 0.0 { top_speed } else { 1.0 } }
    }

    /// The picture of the simulation's present state, as the bytes of a PNG file.
    ///
    /// # Errors
    /// If the picture cannot be encoded.
    pub fn png(&self, simulation: &dyn Simulation) -> Result<Vec<u8>, LabError> {
        let canvas =
            if simulation.dimensions() == 2 { plane::draw(self, simulation) } else { space::draw(self, simulation) };
        encode(&canvas)
    }

    /// A particle's place on the scale of colours, from zero to one.
    fn tone(&self, velocity: &[f64; 3]) -> f32 {
        ((length(velocity) / self.top_speed) as f32).clamp(0.0, 1.0)
    }
}

fn encode(canvas: &Canvas) -> Result<Vec<u8>, LabError> {
    let mut bytes = Vec::new();
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, FilterType::Adaptive)
        .write_image(&canvas.bytes(), canvas.width as u32, canvas.height as u32, ExtendedColorType::Rgb8)
        .map_err(|error| LabError::failure(format!("a picture cannot be encoded: {error}")))?;
    Ok(bytes)
}

fn length(v: &[f64; 3]) -> f64 {
    v.iter().map(|component| component * component).sum::<f64>().sqrt()
}
