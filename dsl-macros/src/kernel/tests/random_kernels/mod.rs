//! Random kernels against an interpreter that records which iterations touch which cells, and how: *accepted implies no
//! conflict*. Each kernel goes the way of a user's: all of the macro's stages run, and what comes out is Rust.
//!
//! `ALLOTROPE_KERNELS` is the number of kernels, 500 if it is not set; `ALLOTROPE_SEED` chooses others. Where a test run shows the
//! output of tests (`--nocapture`), the share of kernels that have no conflict and are refused is printed, with the reasons.

mod generator;
mod interpreter;
mod language;

use std::collections::BTreeMap;
use std::env;

use proc_macro2::TokenStream;

use self::generator::Generator;
use super::codes;
use crate::kernel::expand;

/// A number from the environment.
fn number(name: &str, otherwise: u64) -> u64 {
    env::var(name).map_or(otherwise, |text| text.parse().expect("a number"))
}

/// Kernels by what became of them.
#[derive(Default)]
struct Counts {
    accepted: usize,
    racing: usize,
    /// Without a conflict and refused, by the first error's code.
    strict: BTreeMap<&'static str, Vec<String>>,
}

impl Counts {
    fn report(&self) {
        let strict: usize = self.strict.values().map(Vec::len).sum();
        let free = self.accepted + strict;
        println!("{} kernels: {free} without a conflict, {} with one", free + self.racing, self.racing);
        println!("{strict} without a conflict are refused, {:.1} %:", 100.0 * strict as f64 / free as f64);
        for (code, kernels) in &self.strict {
            let shortest = kernels.iter().min_by_key(|kernel| kernel.len()).map_or("", |kernel| body(kernel));
            println!("  {code}: {}, such as {shortest}", kernels.len());
        }
    }
}

/// A kernel's text without what is the same for all.
fn body(kernel: &str) -> &str {
    kernel.split_once(") {").map_or(kernel, |(_, body)| body.trim_end_matches('}'))
}

#[test]
fn accepted_kernels_have_no_conflicts() {
    let count = number("ALLOTROPE_KERNELS", 500);
    let mut generator = Generator::new(number("ALLOTROPE_SEED", 1));
    let mut counts = Counts::default();
    for _ in 0..count {
        let kernel = generator.kernel();
        let text = kernel.to_string();
        let tokens: TokenStream = text.parse().expect("tokens");
        let expansion = expand(TokenStream::new(), tokens);
        let refused = expansion.to_string().contains("compile_error");
        assert!(syn::parse2::<syn::File>(expansion).is_ok(), "the expansion is no Rust: {text}");
        let conflict = interpreter::conflicts(&kernel);
        assert!(refused || !conflict, "accepted, but iterations meet: {}", body(&text));
        match (conflict, refused) {
            (true, _) => counts.racing += 1,
            (false, false) => counts.accepted += 1,
            (false, true) => counts.strict.entry(codes(&text)[0]).or_default().push(text),
        }
    }
    counts.report();
    // The test says something only if it saw enough of both.
    let enough = count as usize / 8;
    assert!(
        counts.accepted > enough && counts.racing > enough,
        "{} accepted, {} racing",
        counts.accepted,
        counts.racing
    );
}
