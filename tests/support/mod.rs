//! What tests of the fluid share.

#![allow(dead_code, reason = "each test uses a part of it")]

use std::io::Read;

use allotrope::prelude::*;
use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::scene::{Folder, Shape};
use allotrope_solvers::{Scene, Simulation, SolverInfo, solver};

/// An array of the reference data, as `f64`; its members `x0` and so on are NumPy's `.npy`, version 1, of little-endian
/// floats.
pub(crate) fn reference(name: &str) -> Vec<f64> {
    let file = std::fs::File::open(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/mpm88.npz")).unwrap();
    let mut archive = zip::ZipArchive::new(file).unwrap();
    let mut bytes = Vec::new();
    archive.by_name(&format!("{name}.npy")).unwrap().read_to_end(&mut bytes).unwrap();
    assert_eq!(bytes[..8], *b"\x93NUMPY\x01\x00");
    let (header, data) = bytes[10..].split_at(usize::from(u16::from_le_bytes([bytes[8], bytes[9]])));
    let header = std::str::from_utf8(header).unwrap();
    assert!(header.contains("'fortran_order': False"), "{header}");
    if header.contains("'<f4'") {
        data.as_chunks().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes))).collect()
    } else {
        assert!(header.contains("'<f8'"), "{header}");
        data.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
    }
}

/// Positions of the reference data.
pub(crate) fn reference_positions(name: &str) -> Vec<[f64; 3]> {
    reference(name).as_chunks().0.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}

pub(crate) fn mpm() -> &'static SolverInfo {
    solver("mpm").unwrap()
}

/// The scene `mpm88` with the start positions of the reference data.
pub(crate) fn mpm88() -> Scene {
    let mut scene = mpm().scene("mpm88").unwrap();
    own(&mut scene).bodies[0].shape = Shape::Points(reference_positions("x0"));
    scene
}

/// What a scene has beside what all scenes have.
pub(crate) fn own(scene: &mut Scene) -> &mut MpmSetup {
    scene.setup_mut().unwrap()
}

pub(crate) fn scene(text: &str) -> Scene {
    Scene::parse(text, "test", Folder::BuiltIn).unwrap()
}

pub(crate) fn build(scene: &Scene, layout: &str) -> Box<dyn Simulation> {
    (mpm().build)(scene, layout).unwrap()
}

pub(crate) fn layouts() -> impl Iterator<Item = &'static str> {
    mpm().layouts.iter().map(|layout| layout.name)
}

/// The instruction sets that this machine has and that loops are compiled for: builds with debug assertions have one version of them.
pub(crate) fn instruction_sets() -> Vec<Cpu> {
    let all = if cfg!(debug_assertions) { &[Cpu::Baseline][..] } else { &Cpu::ALL };
    all.iter().copied().filter(|cpu| cpu.available()).collect()
}

pub(crate) fn advance(simulation: &mut dyn Simulation, schedule: Schedule, steps: u64) {
    schedule.run(|| (0..steps).try_for_each(|_| simulation.step())).unwrap();
}

/// The largest difference along an axis.
pub(crate) fn difference(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let differences = a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (a - b).abs());
    differences
        .fold(0.0, |largest, difference| if difference > largest || difference.is_nan() { difference } else { largest })
}
