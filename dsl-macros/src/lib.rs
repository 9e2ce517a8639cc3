//! The procedural macros of Allotrope: `#[derive(Record)]`, `#[derive(Element)]`, `layout!`, `#[kernel]` and `#[func]`.
//!
//! Users take them from the crate `allotrope`, which documents the language. Each entry point here is one line around a
//! function over `proc_macro2` tokens, so that all logic is tested without a compiler: tokens are parsed, made into a model of what
//! the user meant, checked, and expanded.

#![forbid(unsafe_code)]

use proc_macro::TokenStream;

mod diagnostics;
mod enumeration;
#[cfg(test)]
mod fuzz;
mod kernel;
mod layout;
mod nearest;
#[cfg(test)]
mod pages;
mod record;

/// Makes a plain struct with named members a record: what one element of a field holds.
#[proc_macro_derive(Record)]
pub fn derive_record(input: TokenStream) -> TokenStream {
    record::expand(input.into()).into()
}

/// Makes an enum without fields an element, which members of records may have as their type: it is stored as its integer.
#[proc_macro_derive(Element)]
pub fn derive_element(input: TokenStream) -> TokenStream {
    enumeration::expand(input.into()).into()
}

/// The type of a layout, from a chain of nodes: `layout!(dense(ij).dense(ij, 8).aos)`.
#[proc_macro]
pub fn layout(input: TokenStream) -> TokenStream {
    layout::expand(input.into()).into()
}

/// A function that kernels call, which may read members that are handed to it.
#[proc_macro_attribute]
pub fn func(options: TokenStream, item: TokenStream) -> TokenStream {
    kernel::func::expand(options.into(), item.into()).into()
}

/// A function over fields, whose outermost loops run in parallel.
#[proc_macro_attribute]
pub fn kernel(options: TokenStream, item: TokenStream) -> TokenStream {
    kernel::expand(options.into(), item.into()).into()
}
