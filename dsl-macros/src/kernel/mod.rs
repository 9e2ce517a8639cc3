//! `#[kernel]`: tokens are parsed, made into a model, checked, and expanded.

mod access;
mod arithmetic;
mod branches;
mod check;
mod expand;
pub(crate) mod func;
mod key;
mod lanes;
mod lower;
mod model;
mod offsets;
mod parse;
mod refused;
mod slices;
mod syntax;
#[cfg(test)]
mod tests;
mod text;

use proc_macro2::TokenStream;
use quote::quote;

use crate::diagnostics::Diagnostics;

/// The environment variable that names a kernel whose expansion is printed at compile time.
const SHOW: &str = "ALLOTROPE_EXPAND";

/// The errors of what is no function, beside what it is.
fn rejected(item: TokenStream, diagnostics: Diagnostics) -> TokenStream {
    let errors = diagnostics.into_compile_errors();
    if let Ok(mut method) = syn::parse2::<syn::TraitItemFn>(item.clone()) {
        expand::signature::open_layouts(&mut method.sig, |_| false);
        quote!(#errors #method)
    } else if syn::parse2::<syn::Item>(item.clone()).is_ok() {
        quote!(#errors #item)
    } else {
        errors
    }
}

/// Expands a kernel, or reports all its errors beside a function of the same type, so that nothing follows from them.
pub(crate) fn expand(options: TokenStream, item: TokenStream) -> TokenStream {
    let item = model::without_placeholders(item);
    let mut diagnostics = Diagnostics::default();
    let Some(function) = parse::parse(item.clone(), &mut diagnostics) else {
        return rejected(item, diagnostics);
    };
    let kernel = lower::lower(function.clone(), options);
    check::check(&kernel, &mut diagnostics);
    if !diagnostics.is_empty() {
        let function = refused::function(function, &kernel, &diagnostics);
        let errors = diagnostics.into_compile_errors();
        return quote!(#errors #function);
    }
    let expansion = expand::expand(&kernel, diagnostics.into_warnings());
    if std::env::var(SHOW).is_ok_and(|name| kernel.function.sig.ident == name) {
        eprintln!("{expansion}");
    }
    expansion
}
