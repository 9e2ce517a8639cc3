//! Tokens to syntax: the function, and which of its parameters are fields.

use proc_macro2::{TokenStream, TokenTree};
use syn::{AttrStyle, FnArg, ItemFn, Pat, Type};

use super::model::{FieldParam, Spot, Storage, Width};
use super::slices;
use super::syntax::{axes_rank, bare_type, integer, last_segment, type_arguments};
use crate::diagnostics::{Code, Diagnostics};

/// Reads the function; what has no body or is no function is reported.
pub(super) fn parse(item: TokenStream, diagnostics: &mut Diagnostics) -> Option<ItemFn> {
    match syn::parse2::<ItemFn>(item.clone()) {
        Ok(mut function) => {
            // Those at the start of the body, `#![allow(..)]`, are the function's as well, and are written before it.
            function.attrs.iter_mut().for_each(|attribute| attribute.style = AttrStyle::Outer);
            Some(function)
        }
        Err(error) => {
            if let Ok(method) = syn::parse2::<syn::TraitItemFn>(item.clone()) {
                diagnostics
                    .error(Code::NotAFunction, &method.sig, "a kernel needs a body")
                    .note("a kernel's layouts are hidden type parameters, so that a trait cannot declare it")
                    .help("make it a free function or an inherent method, and call that from the trait's method");
            } else if syn::parse2::<syn::Item>(item.clone()).is_ok() {
                diagnostics
                    .error(Code::NotAFunction, &item, "`#[kernel]` goes on a function")
                    .help("write `#[kernel] fn name(field: &mut Field<f32, _>) { .. }`");
            } else {
                diagnostics.syntax(error);
            }
            None
        }
    }
}

/// What stands in `#[kernel(..)]`.
#[derive(Default)]
pub(super) struct Options {
    /// `unchecked`.
    pub(super) unchecked: bool,
    /// `contract`.
    pub(super) contract: bool,
    /// `lanes = 16`.
    pub(super) lanes: Option<Width>,
    /// Others, of which there are none.
    pub(super) unknown: Vec<TokenStream>,
}

/// Takes options apart, between whose words commas stand.
pub(super) fn options(tokens: TokenStream) -> Options {
    let mut options = Options::default();
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    for option in tokens.split(comma).filter(|option| !option.is_empty()) {
        let option: TokenStream = option.iter().cloned().collect();
        match option.to_string().as_str() {
            "unchecked" => options.unchecked = true,
            "contract" => options.contract = true,
            text if text.split('=').next().is_some_and(|word| word.trim() == "lanes") => {
                options.lanes = Some(width(&option));
            }
            _ => options.unknown.push(option),
        }
    }
    options
}

/// The number in `lanes = 16`.
fn width(option: &TokenStream) -> Width {
    let parsed = syn::parse2::<syn::MetaNameValue>(option.clone());
    let lanes = parsed.ok().and_then(|option| integer(&option.value)).and_then(|lanes| usize::try_from(lanes).ok());
    Width { lanes, spot: Spot::new(option) }
}

/// The parameters that are fields taken by reference, or used as such, as far as their types tell.
pub(super) fn fields(function: &ItemFn) -> Vec<FieldParam> {
    function.sig.inputs.iter().filter_map(|argument| field(argument, &function.block)).collect()
}

fn field(argument: &FnArg, body: &syn::Block) -> Option<FieldParam> {
    let FnArg::Typed(argument) = argument else { return None };
    let Pat::Ident(name) = &*argument.pat else { return None };
    let ty = bare_type(&argument.ty);
    let Type::Reference(reference) = ty else { return None };
    let storage = storage(&reference.elem, is_marked(argument), || slices::is_field(body, &name.ident))?;
    let rank = match (storage, last_segment(&reference.elem).map(type_arguments).as_deref()) {
        (Storage::Slice, _) | (Storage::Field | Storage::Member, Some([_] | [_, _])) => Some(1),
        (Storage::Field | Storage::Member, Some([_, _, axes, ..])) => axes_rank(axes),
        _ => None,
    };
    Some(FieldParam {
        name: name.ident.clone(),
        storage,
        mutable: reference.mutability.is_some(),
        rank,
        ty: ty.clone(),
    })
}

/// Whether a parameter bears `#[field]`.
pub(super) fn is_marked(parameter: &syn::PatType) -> bool {
    parameter.attrs.iter().any(|attribute| attribute.path().is_ident("field"))
}

/// What a type holds; `None` if it is no field. A slice is one where it is used as one.
pub(super) fn storage(ty: &Type, marked: bool, used: impl FnOnce() -> bool) -> Option<Storage> {
    if let Type::Slice(_) = bare_type(ty) {
        return (marked || used()).then_some(Storage::Slice);
    }
    let segment = last_segment(ty);
    match segment.map(|segment| segment.ident.to_string()).as_deref() {
        Some("Field") => Some(Storage::Field),
        // A type of that name without parameters is the user's own.
        Some("Member") if segment.is_some_and(|segment| !segment.arguments.is_none()) => Some(Storage::Member),
        _ => marked.then_some(Storage::Alias),
    }
}
