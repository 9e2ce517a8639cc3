//! Checks of the built-in scenes against published numbers and closed forms: a file a scene.

mod dam_break;
mod elliptical_drop;
mod hydrostatic;

use super::WcsphSetup;
use crate::scene::{Body, Shape};
use crate::{Finding, Scene, SceneError, Watch};

type Watched = Result<Box<dyn Watch>, SceneError>;

pub(super) fn dam_break(scene: &Scene) -> Watched {
    Ok(Box::new(dam_break::DamBreak::new(scene, body(scene)?)))
}

pub(super) fn elliptical_drop(scene: &Scene) -> Watched {
    Ok(Box::new(elliptical_drop::EllipticalDrop::new(body(scene)?)))
}

pub(super) fn hydrostatic(scene: &Scene) -> Watched {
    Ok(Box::new(hydrostatic::Hydrostatic::new(scene, scene.setup()?, body(scene)?)))
}

/// The first body of a scene of this solver.
fn body(scene: &Scene) -> Result<&Body, SceneError> {
    let setup: &WcsphSetup = scene.setup()?;
    setup.bodies.first().ok_or_else(|| scene.fault("body", "is missing"))
}

/// The corners of a body that is a box; of another, those of the unit cube.
fn corners(body: &Body) -> ([f64; 3], [f64; 3]) {
    match body.shape {
        Shape::Box { from, to, .. } => (from, to),
        _ => ([0.0; 3], [1.0; 3]),
    }
}

/// A finding that passes within a share of what is expected.
fn within(what: String, measured: f64, expected: f64, share: f64, source: &'static str) -> Finding {
    let tolerance = share * expected.abs();
    Finding { what, measured, expected, least: expected - tolerance, most: expected + tolerance, source }
}

/// More steps than a run takes whose end is a time.
const MOST_STEPS: u64 = 10_000_000;
