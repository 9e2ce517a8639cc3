//! Model to tokens.

mod boxes;
mod captures;
mod contract;
mod host;
mod key;
mod lanes;
mod launch;
pub(super) mod names;
mod reductions;
mod rewrite;
pub(super) mod signature;
mod topology;
mod unroll;
mod views;

use proc_macro2::TokenStream;
use quote::quote;
use syn::{FnArg, ItemFn, Pat, parse_quote};

use self::rewrite::{Rewrite, Scope};
use super::model::Kernel;

/// The function that a kernel without errors stands for. `first` are statements that come first.
pub(super) fn expand(kernel: &Kernel, first: TokenStream) -> TokenStream {
    let mut function = kernel.function.clone();
    let listed = |name: &str| kernel.listed.iter().any(|field| kernel.fields[*field].name == name);
    signature::open_layouts(&mut function.sig, listed);
    let unchecked = kernel.unchecked.then(|| {
        let (unchecked, private) = (names::unchecked(), names::private());
        // What the caller promises concerns indices alone: an unsafe operation of the body needs a block of its own.
        function.attrs.push(parse_quote!(#[forbid(unsafe_op_in_unsafe_fn)]));
        function.sig.unsafety = Some(Default::default());
        quote!(let #unchecked = unsafe { #private::Unchecked::promised() };)
    });
    let rewrite = Rewrite { kernel, scope: Scope::Host };
    let (slices, body) = (signature::assert_slices(kernel), rewrite.statements(&kernel.function.block));
    let ItemFn { attrs, vis, sig, .. } = function;
    // Expanded accesses stand at the user's tokens, so that lints could take their parentheses for the user's. A layout is one type to its user,
    // and may be many.
    quote!(#(#attrs)* #[allow(unused_parens, clippy::deref_addrof, clippy::type_complexity)] #vis #sig { #first #unchecked #slices #body })
}

/// The function of a kernel that is refused and has no errors on one thread; none of its warnings is of use.
pub(super) fn in_refused(kernel: &Kernel) -> TokenStream {
    let function = expand(kernel, TokenStream::new());
    quote!(#[allow(warnings)] #function)
}

/// A function of the same type that does nothing, for a kernel with errors: so that its callers have none.
pub(super) fn fallback(mut function: ItemFn, unchecked: bool) -> TokenStream {
    signature::open_layouts(&mut function.sig, |_| false);
    for input in &mut function.sig.inputs {
        if let FnArg::Typed(parameter) = input
            && let Pat::Ident(name) = &mut *parameter.pat
        {
            name.mutability = None;
        }
    }
    if unchecked {
        function.sig.unsafety = Some(Default::default());
    }
    function.attrs.retain(|attribute| attribute.path().is_ident("cfg"));
    function.attrs.push(parse_quote!(#[allow(unused, missing_docs, clippy::all)]));
    *function.block = parse_quote!({ loop {} });
    quote!(#function)
}
