//! Expansions as snapshots, and the errors of wrong kernels.

use proc_macro2::TokenStream;

use super::{check, lower, parse};
use crate::diagnostics::Diagnostics;

mod accepted;
mod arithmetic;
mod contract;
mod expansions;
mod functions;
mod heads;
mod lanes;
mod lints;
mod names;
mod races;
mod random_kernels;
mod signatures;
mod topology;
mod values;

/// The expansion of a kernel, formatted.
fn expansion(source: &str) -> String {
    let tokens = super::expand(TokenStream::new(), source.parse().expect("tokens"));
    prettyplease::unparse(&syn::parse2(tokens).expect("the expansion is Rust"))
}

/// What a kernel's errors are.
fn diagnose(source: &str) -> Diagnostics {
    let mut diagnostics = Diagnostics::default();
    if let Some(function) = parse::parse(source.parse().expect("tokens"), &mut diagnostics) {
        check::check(&lower::lower(function, TokenStream::new()), &mut diagnostics);
    }
    diagnostics
}

/// The codes of a kernel's errors, in the order of their reports.
fn codes(source: &str) -> Vec<&'static str> {
    diagnose(source).errors().iter().map(|error| error.code().text()).collect()
}

/// The kernel with a body.
fn kernel(body: &str) -> String {
    format!(
        "fn k(u: &mut Field<R, _, Ij>, v: &Field<R, _, Ij>, p: &mut Field<R, _>, q: &Field<R, _>, n: i32, x: f32, \
         mut s: f32, w: &mut f32) {{ {body} }}"
    )
}

/// Asserts that a body has these errors. Its fields are `u`, `v` (axes `i`, `j`), `p`, `q` (axis `i`), all but `v` and `q` to be
/// written; `n`, `x` are numbers, `s` a mutable one, `w` a `&mut f32`.
#[track_caller]
fn body(source: &str, expected: &[&str]) {
    let kernel = kernel(source);
    let found: Vec<String> = diagnose(&kernel).errors().iter().map(|error| error.text()).collect();
    assert_eq!(codes(&kernel), expected, "{source}\n{}", found.join("\n"));
}
