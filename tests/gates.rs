//! The checks of the built-in scenes, in every scheme of which there are numbers.

mod support;

use allotrope_solvers::scene::Folder;
use allotrope_solvers::{Finding, Scene};
use support::*;

fn findings(name: &str, overrides: &[&str], layout: &str) -> Vec<Finding> {
    let info = mpm().scenes.iter().find(|scene| scene.name == name).unwrap();
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    let scene = Scene::parse_with(info.text, name, Folder::BuiltIn, &overrides).unwrap();
    let mut watch = info.gate.unwrap()(&scene).unwrap();
    let mut simulation = build(&scene, layout);
    watch.look(&*simulation);
    while simulation.steps() < watch.steps() {
        simulation.step().unwrap();
        if simulation.steps() == watch.steps() || simulation.steps().is_multiple_of(watch.every()) {
            watch.look(&*simulation);
        }
    }
    watch.findings()
}

/// At least `count` findings, all of which pass; gives the last number.
fn passes(name: &str, overrides: &[&str], layout: &str, count: usize) -> f64 {
    let findings = findings(name, overrides, layout);
    assert!(findings.len() >= count, "{name} {overrides:?}: {} findings", findings.len());
    for finding in &findings {
        assert!(finding.passes(), "{name} {overrides:?}, {layout}: {finding:?}");
    }
    findings[findings.len() - 1].measured
}

const PIC: &str = "transfer.scheme=pic";
const FLIP: [&str; 2] = ["transfer.scheme=flip", "transfer.blend=1.0"];

#[test]
fn disks_collide_as_published_with_more_energy_the_better_the_transfer_and_the_finer_the_grid() {
    let [fine, coarse] = [&[][..], &["grid=30", "dt=4.3e-3"]].map(|cells: &[&str]| {
        let end = |transfer: &[&str], layout| passes("disks", &[cells, transfer].concat(), layout, 13);
        let [flip, apic, pic] = [end(&FLIP, "soa+soa"), end(&[], "aos+row"), end(&[PIC], "soa+soa")];
        assert!(flip > apic && apic > pic, "{flip}, {apic}, {pic}");
        apic
    });
    assert!(fine > coarse, "{fine}, {coarse}");
}

#[test]
fn a_disk_keeps_of_its_spin_what_is_published() {
    passes("spinning-disk", &[], "aos+sparse4", 7);
    passes("spinning-disk", &["transfer.scheme=polypic", "transfer.modes=4"], "soa+soa", 7);
    passes("spinning-disk", &[PIC], "soa+soa", 6);
    passes("spinning-disk", &FLIP, "aos+sparse4", 7);
}

#[test]
fn a_dam_breaks_as_measured() {
    passes("dam-break", &[], "aos+row", 8);
}

#[test]
fn sand_runs_out_as_measured() {
    passes("sand-column", &[], "soa+soa", 2);
}

#[test]
fn what_falls_freely_falls_as_a_stone() {
    for name in ["mpm88", "bunny", "snowball"] {
        passes(name, &[], "aos+hash4", 4);
    }
}
