//! `#[derive(Element)]`: an enum without fields as a member of records, stored as its integer.

mod expand;
mod model;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;

use crate::diagnostics::Diagnostics;

/// Implements `Enumeration` for the enum in `tokens`, or says why that cannot be.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let item = match syn::parse2(tokens) {
        Ok(item) => item,
        Err(error) => return error.into_compile_error(),
    };
    let mut errors = Diagnostics::default();
    let enumeration = model::model(&item, &mut errors);
    match enumeration {
        Some(enumeration) if errors.is_empty() => expand::expand(&enumeration),
        _ => errors.into_compile_errors(),
    }
}
