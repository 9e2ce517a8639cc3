//! What the fuzzer begins with: every kernel, record and layout of the tests and the pages of error codes.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{Attribute, Item};

use super::{Input, Macro};
use crate::pages::{blocks, derives, marked};

/// All seeds.
pub(super) fn all() -> Vec<Input> {
    let runtime = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../dsl-runtime");
    let mut files = Vec::new();
    for folder in ["tests", "errors"] {
        collect(&runtime.join(folder), &mut files);
    }
    files.sort();
    let mut seeds = Vec::new();
    for path in files {
        let text = fs::read_to_string(&path).expect("a file in UTF-8");
        if path.extension().is_some_and(|ending| ending == "md") {
            blocks(&text, "compile_fail").iter().chain(&blocks(&text, "")).for_each(|block| take(block, &mut seeds));
        } else {
            take(&text, &mut seeds);
        }
    }
    assert!(seeds.len() > 300, "{} seeds", seeds.len());
    seeds
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of programs") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "rs" || ending == "md") {
            files.push(path);
        }
    }
}

/// Takes what a program hands to the macros.
fn take(program: &str, seeds: &mut Vec<Input>) {
    let Ok(file) = syn::parse_file(program) else { return };
    let kernel = |(options, tokens)| Input { of: Macro::Kernel, options, tokens };
    let func = |(options, tokens)| Input { of: Macro::Func, options, tokens };
    seeds.extend(marked(program, "kernel").into_iter().map(kernel));
    seeds.extend(marked(program, "func").into_iter().map(func));
    Rest(seeds).visit_file(&file);
}

/// Records and layouts.
struct Rest<'a>(&'a mut Vec<Input>);

impl Rest<'_> {
    fn push(&mut self, of: Macro, tokens: TokenStream) {
        self.0.push(Input { of, options: TokenStream::new(), tokens });
    }
}

impl<'ast> Visit<'ast> for Rest<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes: &[Attribute] = match item {
            Item::Struct(item) => &item.attrs,
            Item::Enum(item) => &item.attrs,
            Item::Union(item) => &item.attrs,
            _ => &[],
        };
        if derives(attributes, "Record") {
            self.push(Macro::Record, item.to_token_stream());
        }
        if derives(attributes, "Element") {
            self.push(Macro::Element, item.to_token_stream());
        }
        visit::visit_item(self, item);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        if call.path.is_ident("layout") {
            self.push(Macro::Layout, call.tokens.clone());
        }
    }
}
