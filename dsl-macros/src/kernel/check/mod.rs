//! The rules, each worded where it is judged. All errors of a kernel are reported at once.

mod findings;
mod indices;
mod lanes;
mod lints;
mod loops;
mod names;
mod races;
mod signature;
mod topology;
mod variables;

use super::model::Kernel;
use crate::diagnostics::Diagnostics;

/// Judges a kernel.
pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    signature::check(kernel, diagnostics);
    findings::check(kernel, diagnostics);
    names::check(kernel, diagnostics);
    indices::check(kernel, diagnostics);
    races::check(kernel, diagnostics);
    topology::check(kernel, diagnostics);
    lanes::check(kernel, diagnostics);
    lints::check(kernel, diagnostics);
}
