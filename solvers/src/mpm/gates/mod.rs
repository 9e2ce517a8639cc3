//! Checks of the built-in scenes against published numbers and closed forms: a file a scene.

mod dam_break;
mod disks;
mod free_fall;
mod sand_column;
mod spinning_disk;

use super::{Forces, MpmSetup, Scheme, Spline};
use crate::{Finding, Scene, SceneError, Watch};

/// What watches a scene, or that it is of another solver.
type Watched = Result<Box<dyn Watch>, SceneError>;

pub(super) fn dam_break(scene: &Scene) -> Watched {
    Ok(Box::new(dam_break::DamBreak::new(scene, scene.setup()?)))
}

pub(super) fn disks(scene: &Scene) -> Watched {
    Ok(Box::new(disks::Disks::new(scene, scene.setup()?)))
}

pub(super) fn free_fall(scene: &Scene) -> Watched {
    Ok(Box::new(free_fall::FreeFall::new(scene)))
}

pub(super) fn sand_column(scene: &Scene) -> Watched {
    Ok(Box::new(sand_column::SandColumn::new(scene, scene.setup()?)))
}

pub(super) fn spinning_disk(scene: &Scene) -> Watched {
    Ok(Box::new(spinning_disk::SpinningDisk::new(scene, scene.setup()?)))
}

/// A finding that passes within `tolerance` of what is expected.
fn within(what: String, measured: f64, expected: f64, tolerance: f64, source: &'static str) -> Finding {
    Finding { what, measured, expected, least: expected - tolerance, most: expected + tolerance, source }
}

/// The step of a scene at a time in s.
fn step_at(scene: &Scene, time: f64) -> u64 {
    (time / scene.dt).round() as u64
}

/// The scheme of a scene as tables of results name it; none for a blend or a polynomial, of which they say nothing.
fn scheme(setup: &MpmSetup) -> Option<&'static str> {
    if setup.transfer.spline != Spline::Quadratic || setup.transfer.forces != Forces::LeastSquares {
        return None;
    }
    match setup.transfer.scheme {
        Scheme::Apic => Some("APIC"),
        Scheme::Pic => Some("PIC"),
        Scheme::Flip { blend: 1.0 } => Some("FLIP"),
        _ => None,
    }
}
