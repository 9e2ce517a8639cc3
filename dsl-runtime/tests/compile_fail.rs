//! Programs that must not compile.
//!
//! `ui/<rule>/` holds those that the macros refuse: their messages are compared word by word. `ui_rustc/` holds those that the
//! types refuse: rustc words these, so that only their codes and lines are compared, with comments such as `//~ E0596`.

#[path = "ui_rustc/harness.rs"]
mod harness;

#[test]
fn the_macros_refuse() {
    trybuild::TestCases::new().compile_fail("tests/ui/*/*.rs");
}

#[test]
fn the_types_refuse() {
    harness::check("tests/ui_rustc/cases");
}
