//! `#[derive(Record)]`: what one element of a field holds.

mod check;
mod expand;
mod model;
mod parse;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;

use crate::diagnostics::Diagnostics;

/// Implements `Record` for the struct in `tokens`, or says why that cannot be.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let item = match parse::parse(tokens) {
        Ok(item) => item,
        Err(error) => return error.into_compile_error(),
    };
    let mut errors = Diagnostics::default();
    check::check(&item, &mut errors);
    let record = model::model(&item);
    if errors.is_empty() { expand::expand(&record) } else { errors.into_compile_errors() }
}
