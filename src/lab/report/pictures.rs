//! Pictures of a scene for a page.

use allotrope_solvers::{Scene, Simulation};

use super::base64::base64;
use crate::lab::errors::LabError;
use crate::lab::render::{Camera, Shading};

/// A picture in a page.
#[derive(Clone, Debug)]
pub(in crate::lab) struct Pictured {
    /// What it shows.
    pub(in crate::lab) caption: String,
    width: usize,
    height: usize,
    png: Vec<u8>,
}

/// How the scene is looked at in all of its pictures.
#[derive(Debug)]
pub(super) struct Photographer {
    camera: Camera,
    colours: &'static str,
}

impl Photographer {
    /// For a simulation that has just begun.
    pub(super) fn new(simulation: &dyn Simulation, scene: &Scene) -> Self {
        let shading = Shading::fitting(simulation);
        let colours = match shading {
            Shading::Velocity => "colours tell how fast it moves, from blue at rest to orange",
            Shading::Material => "each material has its colour",
            Shading::Pressure => "blue where it is pulled apart, grey at rest, red where it is pressed together",
        };
        Self { camera: Camera::new(simulation, scene, shading), colours }
    }

    /// The picture of a simulation's present state.
    pub(super) fn picture(&self, simulation: &dyn Simulation, when: &str) -> Result<Pictured, LabError> {
        let picture = self.camera.picture(simulation);
        let caption = format!("{when}; {}", self.colours);
        Ok(Pictured { caption, width: picture.width, height: picture.height, png: picture.png()? })
    }
}

impl Pictured {
    /// The picture as an element that holds all of it.
    pub(in crate::lab) fn element(&self) -> String {
        let Self { caption, width, height, png } = self;
        let caption = super::html::inline(caption);
        format!(
            "<figure><img width=\"{width}\" height=\"{height}\" alt=\"{caption}\" src=\"data:image/png;base64,{}\"><figcaption>{caption}</figcaption></figure>",
            base64(png)
        )
    }
}
