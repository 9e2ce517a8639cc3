//! Checks of the built-in scenes against published numbers and closed forms: a file a scene.

mod dam_break;
mod disks;
mod free_fall;
mod sand_column;
mod spinning_disk;

use crate::{Finding, Scene, Watch};

pub(super) fn dam_break(scene: &Scene) -> Box<dyn Watch> {
    Box::new(dam_break::DamBreak::new(scene))
}

pub(super) fn disks(scene: &Scene) -> Box<dyn Watch> {
    Box::new(disks::Disks::new(scene))
}

pub(super) fn free_fall(scene: &Scene) -> Box<dyn Watch> {
    Box::new(free_fall::FreeFall::new(scene))
}

pub(super) fn sand_column(scene: &Scene) -> Box<dyn Watch> {
    Box::new(sand_column::SandColumn::new(scene))
}

pub(super) fn spinning_disk(scene: &Scene) -> Box<dyn Watch> {
    Box::new(spinning_disk::SpinningDisk::new(scene))
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
fn scheme(scene: &Scene) -> Option<&'static str> {
    use crate::scene::{Forces, Scheme, Spline};
    if scene.transfer.spline != Spline::Quadratic || scene.transfer.forces != Forces::LeastSquares {
        return None;
    }
    match scene.transfer.scheme {
        Scheme::Apic => Some("APIC"),
        Scheme::Pic => Some("PIC"),
        Scheme::Flip { blend: 1.0 } => Some("FLIP"),
        _ => None,
    }
}
