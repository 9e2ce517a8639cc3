//! Tokens to syntax.

use proc_macro2::TokenStream;
use syn::DeriveInput;

/// Reads the item that the derive stands on.
pub(super) fn parse(tokens: TokenStream) -> syn::Result<DeriveInput> {
    syn::parse2(tokens)
}
