//! `layout!`: how a space of records lies in memory, as a type.

mod check;
mod expand;
mod lists;
mod model;
mod parse;
mod sparse;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;

use crate::diagnostics::{Code, Diagnostics};

/// The type that the layout in `tokens` is; a layout with errors is a plain one that carries them.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Diagnostics::default();
    let layout = match parse::parse(tokens) {
        Ok(syntax) => model::model(syntax),
        Err(error) => {
            errors
                .error(Code::NotALayout, &error.to_compile_error(), format!("this is no layout: {error}"))
                .help("a layout is a chain of nodes closed by a place: `dense(ij).dense(ij, 8).aos`");
            return expand::fallback(errors.into_compile_errors());
        }
    };
    check::check(&layout, &mut errors);
    if errors.is_empty() { expand::expand(&layout) } else { expand::fallback(errors.into_compile_errors()) }
}
