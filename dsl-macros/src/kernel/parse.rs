//! Tokens to syntax: the function, and which of its parameters are fields.

use proc_macro2::TokenStream;
use syn::{AttrStyle, FnArg, ItemFn, Pat, Type};

use super::model::FieldParam;
use super::syntax::{axes_rank, last_segment, type_arguments};
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

/// The parameters that are fields taken by reference, as far as their types tell.
pub(super) fn fields(function: &ItemFn) -> Vec<FieldParam> {
    function.sig.inputs.iter().filter_map(field).collect()
}

fn field(argument: &FnArg) -> Option<FieldParam> {
    let FnArg::Typed(argument) = argument else { return None };
    let Pat::Ident(name) = &*argument.pat else { return None };
    let Type::Reference(reference) = &*argument.ty else { return None };
    let segment = last_segment(&reference.elem).filter(|segment| segment.ident == "Field")?;
    let rank = match type_arguments(segment).as_slice() {
        [_] | [_, _] => Some(1),
        [_, _, axes, ..] => axes_rank(axes),
        [] => None,
    };
    Some(FieldParam {
        name: name.ident.clone(),
        mutable: reference.mutability.is_some(),
        rank,
        ty: (*argument.ty).clone(),
    })
}
