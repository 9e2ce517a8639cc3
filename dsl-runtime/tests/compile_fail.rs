//! Programs that must not compile, and suspicious ones that must.
//!
//! `ui/<rule>/` holds those that the macros refuse: their messages are compared word by word. `ui_rustc/` holds those that the
//! types refuse: rustc words these, so that only their codes and lines are compared, with comments such as `//~ E0596`.
//! `ui/pass/` holds those that look as if a rule could refuse them, and must not be: each asserts what its kernels compute.

use std::fs;

#[path = "ui_rustc/harness.rs"]
mod harness;

use harness::Until;

#[test]
fn the_macros_refuse() {
    let cases = trybuild::TestCases::new();
    for entry in fs::read_dir("tests/ui").expect("the folder of rules") {
        let rule = entry.expect("an entry").file_name();
        if rule != "pass" {
            cases.compile_fail(format!("tests/ui/{}/*.rs", rule.to_string_lossy()));
        }
    }
}

#[test]
fn suspicious_kernels_are_right() {
    harness::accept("tests/ui/pass", "2024", Until::Run);
}

#[test]
fn suspicious_kernels_are_right_in_the_edition_before() {
    harness::accept("tests/ui/pass", "2021", Until::Checked);
}

#[test]
fn the_types_refuse() {
    harness::refuse("tests/ui_rustc/cases");
}
