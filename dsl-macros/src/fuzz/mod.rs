//! The macros never panic, whatever they are handed: inputs made from those of the tests and pages by cutting, doubling, swapping and
//! mixing their tokens go through the entry points. What is expanded without an error must be Rust.
//!
//! `ALLOTROPE_FUZZ_SECONDS` lets the test run for so long by hand, from `ALLOTROPE_SEED`; a test run tries a fixed number. A found
//! input is printed, shortened; once mended it is kept in `corpus/`, and tried again by each test run.

mod mutate;
mod seeds;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{env, thread};

use proc_macro2::TokenStream;

use self::mutate::Mutator;
use crate::{enumeration, kernel, layout, record};

/// The inputs that a test run tries.
const TRIED: usize = 2000;

/// The entry points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Macro {
    /// The options, and the item.
    Kernel,
    Func,
    Record,
    Element,
    Layout,
}

impl Macro {
    const ALL: [Macro; 5] = [Macro::Kernel, Macro::Func, Macro::Record, Macro::Element, Macro::Layout];

    /// The ending of files of the corpus.
    fn ending(self) -> &'static str {
        match self {
            Macro::Kernel => "kernel",
            Macro::Func => "func",
            Macro::Record => "record",
            Macro::Element => "element",
            Macro::Layout => "layout",
        }
    }
}

/// What a macro is handed: options for kernels alone.
#[derive(Clone)]
struct Input {
    of: Macro,
    options: TokenStream,
    tokens: TokenStream,
}

impl Input {
    fn expand(&self) -> TokenStream {
        match self.of {
            Macro::Kernel => kernel::expand(self.options.clone(), self.tokens.clone()),
            Macro::Func => kernel::func::expand(self.options.clone(), self.tokens.clone()),
            Macro::Record => record::expand(self.tokens.clone()),
            Macro::Element => enumeration::expand(self.tokens.clone()),
            Macro::Layout => layout::expand(self.tokens.clone()),
        }
    }

    /// What is wrong with what comes out, if anything is.
    fn fault(&self) -> Option<&'static str> {
        let Ok(expansion) = catch_unwind(AssertUnwindSafe(|| self.expand())) else { return Some("the macro panics") };
        let parses = match self.of {
            Macro::Kernel | Macro::Func | Macro::Record | Macro::Element => {
                syn::parse2::<syn::File>(expansion.clone()).is_ok()
            }
            Macro::Layout => syn::parse2::<syn::Type>(expansion.clone()).is_ok(),
        };
        (!parses && !expansion.to_string().contains("compile_error")).then_some("the expansion is no Rust")
    }

    fn text(&self) -> String {
        format!("{}\n{}", self.options, self.tokens)
    }
}

/// Runs on a stack as large as the compiler's.
fn on_a_large_stack(work: impl FnOnce() + Send + 'static) {
    let thread = thread::Builder::new().stack_size(64 << 20).spawn(work).expect("a thread");
    if let Err(panic) = thread.join() {
        std::panic::resume_unwind(panic);
    }
}

/// Cuts an input down as long as it stays wrong.
fn shortened(mut input: Input) -> Input {
    let mut shorter = true;
    while shorter {
        shorter = false;
        for tokens in mutate::cuts(&input.tokens) {
            let cut = Input { tokens, ..input.clone() };
            if cut.fault().is_some() {
                (input, shorter) = (cut, true);
                break;
            }
        }
    }
    input
}

#[test]
fn no_input_makes_a_macro_panic() {
    on_a_large_stack(|| {
        let seconds = env::var("ALLOTROPE_FUZZ_SECONDS").ok().map(|text| text.parse().expect("a number of seconds"));
        let seed = env::var("ALLOTROPE_SEED").map_or(1, |text| text.parse().expect("a number"));
        let (started, seeds) = (Instant::now(), seeds::all());
        let mut mutator = Mutator::new(seed, &seeds);
        let mut tried = 0;
        let mut expanded = 0;
        while seconds.map_or(tried < TRIED, |seconds| started.elapsed() < Duration::from_secs(seconds)) {
            let input = mutator.next();
            tried += 1;
            if let Some(fault) = input.fault() {
                let input = shortened(input);
                panic!("{fault}, input {tried}, {:?}:\n{}", input.of, input.text());
            }
            expanded += usize::from(!input.expand().to_string().contains("compile_error"));
        }
        println!("{tried} inputs from {} seeds, {expanded} of them without an error", seeds.len());
        // The macros' last stage must have been reached.
        assert!(expanded > tried / 100, "{expanded} of {tried} inputs were expanded");
    });
}

#[test]
fn inputs_that_were_found_are_no_fault_any_more() {
    on_a_large_stack(|| {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("corpus");
        let mut tried = 0;
        for entry in fs::read_dir(folder).expect("the corpus") {
            let path = entry.expect("an entry").path();
            let text = fs::read_to_string(&path).expect("an input");
            let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_owned();
            let of = Macro::ALL.into_iter().find(|of| of.ending() == ending);
            let of = of.unwrap_or_else(|| panic!("{} is of no macro", path.display()));
            let (options, item) = text.split_once('\n').expect("a line of options, and an item");
            let parse = |text: &str| text.parse().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let input = Input { of, options: parse(options), tokens: parse(item) };
            assert_eq!(input.fault(), None, "{}", path.display());
            tried += 1;
        }
        assert!(tried > 0, "the corpus is empty");
    });
}
