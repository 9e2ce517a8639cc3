//! Tests of the reference's pages of error codes, `dsl-runtime/errors/A0xxx.md`: each code has one, and its examples show that code.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{Attribute, Item, Meta};

use crate::diagnostics::Code;
use crate::{enumeration, kernel, layout, record};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../dsl-runtime/errors")
}

fn page(code: Code) -> String {
    let path = folder().join(format!("{code}.md"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{code} has no page {}: {error}", path.display()))
}

/// The blocks of a page that are opened with these words.
pub(crate) fn blocks(page: &str, opened: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut open: Option<(bool, String)> = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(words), None) => open = Some((words == opened, String::new())),
            (Some(_), Some(_)) => blocks.extend(open.take().and_then(|(wanted, text)| wanted.then_some(text))),
            (None, Some((_, text))) => *text += &format!("{line}\n"),
            (None, None) => {}
        }
    }
    blocks
}

/// Expands every macro of the language in an example.
#[derive(Default)]
struct Expansions(TokenStream);

impl Expansions {
    fn of(example: &str) -> String {
        let file = syn::parse_file(example).expect("the example parses");
        let mut this = Self::default();
        this.visit_file(&file);
        this.0.to_string()
    }
}

/// Whether an item derives a trait of the language.
pub(crate) fn derives(attributes: &[Attribute], name: &str) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("derive") && attribute.meta.to_token_stream().to_string().contains(name)
    })
}

impl<'ast> Visit<'ast> for Expansions {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Struct(item) => &item.attrs,
            Item::Enum(item) => &item.attrs,
            Item::Union(item) => &item.attrs,
            _ => return visit::visit_item(self, item),
        };
        if derives(attributes, "Record") {
            self.0.extend(record::expand(item.to_token_stream()));
        }
        if derives(attributes, "Element") {
            self.0.extend(enumeration::expand(item.to_token_stream()));
        }
        visit::visit_item(self, item);
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        if call.path.is_ident("layout") {
            self.0.extend(layout::expand(call.tokens.clone()));
        }
    }
}

/// What bears an attribute in an example, `kernel` or `func`, with its options: functions, methods and what else there is.
pub(crate) fn marked(example: &str, word: &'static str) -> Vec<(TokenStream, TokenStream)> {
    struct Found(Vec<(TokenStream, TokenStream)>, &'static str);
    impl Found {
        /// Takes the attribute off an item that bears it.
        fn take(&mut self, attributes: &mut Vec<Attribute>) -> Option<TokenStream> {
            let place = attributes.iter().position(|attribute| attribute.path().is_ident(self.1))?;
            Some(match attributes.remove(place).meta {
                Meta::List(list) => list.tokens,
                Meta::Path(_) | Meta::NameValue(_) => TokenStream::new(),
            })
        }
        fn item(&mut self, attributes: &[Attribute], item: impl FnOnce(Vec<Attribute>) -> TokenStream) {
            let mut attributes = attributes.to_vec();
            if let Some(options) = self.take(&mut attributes) {
                let item = item(attributes);
                self.0.push((options, item));
            }
        }
    }
    impl<'ast> Visit<'ast> for Found {
        fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
            self.item(&item.attrs, |attrs| syn::ItemFn { attrs, ..item.clone() }.into_token_stream());
            visit::visit_item_fn(self, item);
        }
        fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
            self.item(&item.attrs, |attrs| syn::ImplItemFn { attrs, ..item.clone() }.into_token_stream());
        }
        fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
            self.item(&item.attrs, |attrs| syn::TraitItemFn { attrs, ..item.clone() }.into_token_stream());
        }
        fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
            self.item(&item.attrs, |attrs| syn::ItemStruct { attrs, ..item.clone() }.into_token_stream());
        }
    }
    let mut found = Found(Vec::new(), word);
    found.visit_file(&syn::parse_file(example).expect("the example parses"));
    found.0
}

/// All that the macros make of an example.
fn expanded(example: &str) -> String {
    let mut text = Expansions::of(example);
    for (options, item) in marked(example, "kernel") {
        text.push_str(&kernel::expand(options, item).to_string());
    }
    for (options, item) in marked(example, "func") {
        text.push_str(&kernel::func::expand(options, item).to_string());
    }
    text
}

/// The codes that stand in errors of an expansion.
fn codes(expansion: &str) -> BTreeSet<&str> {
    Code::ALL.iter().map(|code| code.text()).filter(|code| expansion.contains(&format!("[{code}]"))).collect()
}

#[test]
fn every_code_has_a_page_and_every_page_a_code() {
    let files: BTreeSet<String> = fs::read_dir(folder())
        .expect("the pages' folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("a name in UTF-8"))
        .collect();
    let expected: BTreeSet<String> = Code::ALL.iter().map(|code| format!("{code}.md")).collect();
    assert_eq!(files, expected);
}

#[test]
fn every_page_is_in_the_library_s_documentation() {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../dsl-runtime/src/errors.rs");
    let text = fs::read_to_string(path).expect("the library's list of pages");
    let (_, list) = text.split_once("\npages! {").expect("a list");
    let listed: Vec<&str> = list.trim_end().trim_end_matches('}').split_whitespace().collect();
    assert_eq!(listed, Code::ALL.iter().map(|code| code.text()).collect::<Vec<_>>());
}

#[test]
fn pages_have_a_title_and_both_examples() {
    for &code in Code::ALL {
        let page = page(code);
        assert!(page.starts_with(&format!("# {code}: ")), "{code}");
        assert_eq!((blocks(&page, "compile_fail").len(), blocks(&page, "").len()), (1, 1), "{code}");
    }
}

#[test]
fn wrong_examples_have_the_code_and_right_ones_none() {
    let mut failures = Vec::new();
    for &code in Code::ALL {
        let page = page(code);
        let wrong = expanded(&blocks(&page, "compile_fail")[0]);
        if codes(&wrong) != BTreeSet::from([code.text()]) {
            failures.push(format!("{code}, wrong: {wrong}"));
        }
        let right = expanded(&blocks(&page, "")[0]);
        if right.contains("compile_error") {
            failures.push(format!("{code}, right: {right}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
