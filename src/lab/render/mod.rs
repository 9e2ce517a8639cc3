//! Pictures of particles, and of what stands between them.

mod canvas;
mod collider;
mod colour;
mod picture;
mod plane;
mod shading;
mod solid;
mod space;

use allotrope_solvers::scene::{CameraPlace, Collider};
use allotrope_solvers::{Scene, Simulation};

pub use picture::Picture;
pub use shading::{SHADINGS, Shading};

use super::errors::LabError;
use colour::{Colour, Scale};

/// Pixels along the longer side of a picture.
const SIDE: usize = 800;

/// How a simulation is looked at: the same for all pictures of a run, the scales of colours too.
#[derive(Clone, Debug)]
pub struct Camera {
    shading: Shading,
    place: CameraPlace,
    /// The speed in m/s at the upper end of the scale of speeds.
    top_speed: f64,
    /// The pressure in Pa at the upper end of the scale of pressures; the lower end is as far below zero.
    top_pressure: f64,
    materials: Vec<Colour>,
    colliders: Vec<Collider>,
}

impl Camera {
    /// A camera for a simulation that has just begun.
    ///
    /// The scale of speeds ends at the speed that the fastest particle would have after falling all the way. The scale
    /// of pressures ends at half the pressure that stops the densest material from that speed (Bernoulli), which is at
    /// least that at the bottom of a tank filled by half, at rest; below zero it ends alike. Both depend on the scene
    /// and its start alone, so that they are the same in each picture of a run.
    pub fn new(simulation: &dyn Simulation, scene: &Scene, shading: Shading) -> Self {
        let fastest = simulation.velocities().iter().map(length).fold(0.0, f64::max);
        let fall =
            simulation.extent().iter().zip(&scene.gravity).map(|(extent, gravity)| extent * gravity.abs()).sum::<f64>();
        let top_speed = (fastest * fastest + 2.0 * fall).sqrt();
        let top_speed = if top_speed > 0.0 { top_speed } else { 1.0 };
        let substances = scene.setup.substances();
        let densest = substances.iter().map(|substance| substance.density).fold(0.0, f64::max);
        Self {
            shading,
            place: scene.camera,
            top_speed,
            top_pressure: (0.25 * densest * top_speed * top_speed).max(f64::MIN_POSITIVE),
            materials: shading::material_colours(&substances),
            colliders: scene.setup.colliders().to_vec(),
        }
    }

    /// The picture of the simulation's present state.
    pub fn picture(&self, simulation: &dyn Simulation) -> Picture {
        let canvas =
            if simulation.dimensions() == 2 { plane::draw(self, simulation) } else { space::draw(self, simulation) };
        Picture::of(&canvas)
    }

    /// The picture of the simulation's present state, as the bytes of a PNG file.
    ///
    /// # Errors
    /// If the picture cannot be encoded.
    pub fn png(&self, simulation: &dyn Simulation) -> Result<Vec<u8>, LabError> {
        self.picture(simulation).png()
    }

    /// The colour of each particle.
    fn colours(&self, simulation: &dyn Simulation) -> Vec<Colour> {
        match self.shading {
            Shading::Velocity => {
                let scale = Scale::speeds();
                let tone = |v| ((length(v) / self.top_speed) as f32).clamp(0.0, 1.0);
                simulation.velocities().iter().map(|v| scale.at(tone(v))).collect()
            }
            Shading::Pressure => {
                let scale = Scale::pressures();
                let tone = |p: f64| (0.5 + 0.5 * p / self.top_pressure).clamp(0.0, 1.0) as f32;
                let mut pressures = simulation.pressures();
                // Who has none is at rest.
                pressures.resize(simulation.particles(), 0.0);
                pressures.into_iter().map(|p| scale.at(tone(p))).collect()
            }
            Shading::Material => {
                let colour = |m: u32| self.materials[(m as usize).min(self.materials.len() - 1)];
                simulation.material_of().into_iter().map(colour).collect()
            }
        }
    }
}

fn length(v: &[f64; 3]) -> f64 {
    v.iter().map(|component| component * component).sum::<f64>().sqrt()
}
