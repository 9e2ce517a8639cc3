//! Accesses at the top level and in serial loops: any index, checked.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::names::{Ends, hidden, numbered, plain, private, span, tag};
use super::rewrite::Rewrite;
use super::views::change;
use crate::kernel::model::{Access, Action, Boundary, UncheckedAccess};

/// Reads, writes or changes one element.
pub(super) fn access(rewrite: &Rewrite<'_>, access: &Access) -> TokenStream {
    let private = private();
    let parameter = &rewrite.kernel.fields[access.field];
    let field = &parameter.name;
    let (tags, whole) = (quote!(#private::tags(&*#field)), quote!(#private::path(&*#field)));
    let tag = tag(parameter, &tags, &whole, &access.path);
    let ends = Ends::of(&access.target);
    if access.is_lent() {
        let (kernel, text) = (plain(&rewrite.kernel.function.sig.ident), plain(field));
        let site = quote!(&#private::Site { kernel: #kernel, field: #text });
        return function(&ends, "lend", quote!(&*#field, #tag, #site));
    }
    let index = rewrite.expr(&access.index);
    let (part, value) = match &access.action {
        Action::Read => {
            let arguments = quote!(&*#field, #tag, #index);
            let read = match &access.boundary {
                Boundary::Checked => function(&ends, "read", arguments),
                Boundary::Clamped => function(&ends, "clamped", arguments),
                Boundary::Wrapped => function(&ends, "wrapped", arguments),
                Boundary::Lent => unreachable!("a member that is handed on has no index"),
                Boundary::Or(value) => {
                    let value = rewrite.expr(value);
                    function(&ends, "or", quote!(#arguments, #value))
                }
            };
            return ends.read(read);
        }
        Action::Write { part, value } | Action::Update { part, value, .. } => (part, rewrite.expr(value)),
        Action::Exchange { method, arguments } => {
            let arguments: Vec<_> = arguments.iter().map(|argument| rewrite.expr(argument)).collect();
            return exchange(&Ends::of(&access.spot), field, (&tag, &index), method, &arguments);
        }
    };
    // What comes first may read the field, which the write borrows.
    let (new, path, at, target) = (hidden("value"), hidden("path"), hidden("at"), hidden("target"));
    if part.is_empty() && matches!(access.action, Action::Write { .. }) {
        let new = Ident::new("__value", new.span().located_at(span(&value)));
        let write = function(&ends, "write", quote!(&mut *#field, #path, #at, #new));
        return quote!({ let #new = #value; let (#path, #at) = (#tag, #index); #write });
    }
    let locate = function(&ends, "locate", quote!(&*#field, #index));
    let change = change(rewrite, &access.action, &target, &new, span(&access.spot.tokens));
    quote!({
        let #new = #value;
        let (#path, #at) = (#tag, #locate);
        let mut #target = #private::read_at(&*#field, #path, #at);
        #change
        #private::write_at(&mut *#field, #path, #at, #target);
    })
}

/// `f[index].fetch_add(value)` and its like.
fn exchange(
    ends: &Ends,
    field: &Ident,
    (tag, index): (&TokenStream, &TokenStream),
    method: &Ident,
    arguments: &[TokenStream],
) -> TokenStream {
    let private = private();
    let (path, at, target, old) = (hidden("path"), hidden("at"), hidden("target"), hidden("old"));
    let locate = function(ends, "locate", quote!(&*#field, #index));
    let names: Vec<_> = (0..arguments.len()).map(|number| numbered("argument", number)).collect();
    let exchange = function(ends, &method.to_string(), quote!(&mut #target, #(#names),*));
    quote!({
        let (#path, #at, #(#names,)*) = (#tag, #locate, #(#arguments,)*);
        let mut #target = #private::read_at(&*#field, #path, #at);
        let #old = #exchange;
        #private::write_at(&mut *#field, #path, #at, #target);
        #old
    })
}

/// `f.get_unchecked(index)` and `f.set_unchecked(index, value)`: the user's `unsafe` block is around them.
pub(super) fn unchecked_access(rewrite: &Rewrite<'_>, access: &UncheckedAccess) -> TokenStream {
    let private = private();
    let parameter = &rewrite.kernel.fields[access.field];
    let field = &parameter.name;
    let (tags, whole) = (quote!(#private::tags(&*#field)), quote!(#private::path(&*#field)));
    let (tag, index) = (tag(parameter, &tags, &whole, &access.path), rewrite.expr(&access.index));
    let ends = Ends::of(&access.spot);
    let Some(value) = &access.value else {
        return ends.read(function(&ends, "get_unchecked", quote!(&*#field, #tag, #index)));
    };
    // What comes first may read the field, which the write borrows.
    let (new, path, at, value) = (hidden("value"), hidden("path"), hidden("at"), rewrite.expr(value));
    let write = function(&ends, "set_unchecked", quote!(&mut *#field, #path, #at, #new));
    quote!({ let (#path, #at, #new) = (#tag, #index, #value); #write })
}

/// A call of a private function, at the user's tokens.
fn function(ends: &Ends, name: &str, arguments: TokenStream) -> TokenStream {
    let name = Ident::new(name, ends.first);
    let arguments = ends.group(arguments, ends.last);
    quote_spanned!(ends.first=> ::allotrope::__private::#name #arguments)
}
