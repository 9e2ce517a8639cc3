//! Checks of the built-in scenes against closed forms: a file a scene.

mod chain;
mod cloth;
mod pendulum;
mod three_points;

use super::setup::SpringsSetup;
use crate::{Finding, Scene, SceneError, Watch};

/// What watches a scene, or that it is of another solver.
type Watched = Result<Box<dyn Watch>, SceneError>;

pub(super) fn chain(scene: &Scene) -> Watched {
    Ok(Box::new(chain::Chain::new(scene.setup()?)))
}

pub(super) fn cloth(scene: &Scene) -> Watched {
    Ok(Box::new(cloth::Cloth::new(scene.setup()?)))
}

pub(super) fn pendulum(scene: &Scene) -> Watched {
    Ok(Box::new(pendulum::Pendulum::new(scene.setup()?)))
}

pub(super) fn three_points(scene: &Scene) -> Watched {
    Ok(Box::new(three_points::ThreePoints::new(scene.setup()?)))
}

/// A finding that passes within `tolerance` of what is expected.
fn within(what: String, measured: f64, expected: f64, tolerance: f64, source: &'static str) -> Finding {
    Finding { what, measured, expected, least: expected - tolerance, most: expected + tolerance, source }
}
