//! Names that only the expansion can see.

use proc_macro2::{Group, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::spanned::Spanned;
use syn::{Ident, Lifetime};

use crate::kernel::model::{FieldParam, Spot};

/// The runtime's private interface.
pub(super) fn private() -> TokenStream {
    quote!(::allotrope::__private)
}

/// A local of the expansion.
pub(super) fn hidden(name: &str) -> Ident {
    Ident::new(&format!("__{name}"), Span::mixed_site())
}

/// A numbered local of the expansion.
pub(super) fn numbered(name: &str, number: usize) -> Ident {
    format_ident!("__{}{}", name, number, span = Span::mixed_site())
}

/// A label of the expansion.
pub(super) fn label(name: &str) -> Lifetime {
    Lifetime::new(&format!("'__{name}"), Span::mixed_site())
}

/// The handle of a field.
pub(super) fn handle(field: &FieldParam) -> Ident {
    hidden(&format!("field_{}", plain(&field.name)))
}

/// A job's memory of the blocks of a field, which a handle names.
pub(super) fn paths(handle: &Ident) -> Ident {
    format_ident!("{}_paths", handle, span = Span::mixed_site())
}

/// What a handle's field lies in, where a loop only reads it.
pub(super) fn still(handle: &Ident) -> Ident {
    format_ident!("{}_still", handle, span = Span::mixed_site())
}

/// The promise of an unchecked kernel's caller.
pub(super) fn unchecked() -> Ident {
    hidden("unchecked")
}

/// A name without `r#`.
pub(super) fn plain(name: &Ident) -> String {
    let text = name.to_string();
    text.strip_prefix("r#").map(str::to_owned).unwrap_or(text)
}

/// The local that holds what an index of a parameter names, where its type alone tells.
pub(super) fn path(field: &FieldParam) -> Ident {
    hidden(&format!("path_{}", plain(&field.name)))
}

/// The tag of a member, from the expression for the field's tags; `whole` where only the type tells what an index names.
pub(super) fn tag(field: &FieldParam, tags: &TokenStream, whole: &TokenStream, path: &[Ident]) -> TokenStream {
    if let [member, inner @ ..] = path {
        let inner = then(inner);
        quote!(#tags.#member #inner)
    } else if field.storage.is_opaque() {
        whole.clone()
    } else {
        let private = private();
        quote!(#private::Whole)
    }
}

/// The way on from the tag of a member that is a record: `.then(|tags| tags.inner)`.
fn then(path: &[Ident]) -> Option<TokenStream> {
    let [member, inner @ ..] = path else { return None };
    let (tags, inner) = (hidden("tags"), then(inner));
    Some(quote!(.then(|#tags| #tags.#member #inner)))
}

/// Where the user's tokens begin and end.
pub(in crate::kernel) struct Ends {
    pub(super) first: Span,
    pub(super) last: Span,
}

impl Ends {
    /// One token.
    pub(super) fn at(span: Span) -> Self {
        Self { first: span, last: span }
    }

    pub(in crate::kernel) fn of(spot: &Spot) -> Self {
        let mut tokens = spot.tokens.clone().into_iter();
        let first = tokens.next();
        let last = tokens.last().or_else(|| first.clone());
        let span = |token: Option<TokenTree>| token.map_or_else(Span::call_site, |token| token.span());
        let close = match &last {
            Some(TokenTree::Group(group)) => group.span_close(),
            other => span(other.clone()),
        };
        Self { first: span(first), last: close }
    }

    /// A local of the expansion that stands at the user's tokens, so that errors about it point there.
    pub(super) fn local(&self, name: &Ident) -> Ident {
        Ident::new(&name.to_string(), name.span().located_at(self.first))
    }

    /// `.method(arguments)`, at the user's tokens, so that errors and panics name them.
    pub(in crate::kernel) fn call(
        &self,
        receiver: &impl ToTokens,
        method: &str,
        arguments: TokenStream,
    ) -> TokenStream {
        let method = Ident::new(method, self.first);
        // In parentheses at the user's tokens: a span that began at a hidden name would end up at the attribute.
        let receiver = self.group(quote!(#receiver), self.first);
        let arguments = self.group(arguments, self.last);
        quote!(#receiver.#method #arguments)
    }

    pub(super) fn group(&self, tokens: TokenStream, span: Span) -> Group {
        let mut group = Group::new(proc_macro2::Delimiter::Parenthesis, tokens);
        group.set_span(span);
        group
    }

    /// `(*(&value))`: a value that cannot be changed in place, at the user's tokens.
    pub(in crate::kernel) fn read(&self, value: TokenStream) -> TokenStream {
        let and = syn::Token![&](self.first);
        let star = syn::Token![*](self.first);
        let inner = self.group(quote!(#and #value), self.last);
        let outer = self.group(quote!(#star #inner), self.first);
        quote!(#outer)
    }
}

/// The span of some tokens for what replaces them.
pub(super) fn span(tokens: &impl ToTokens) -> Span {
    tokens.to_token_stream().span()
}
