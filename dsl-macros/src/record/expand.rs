//! Model to tokens.

use proc_macro2::{Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::Type;
use syn::ext::IdentExt;

use super::model::Record;

/// `impl Record`, and beside it the struct that has one place a member.
pub(super) fn expand(record: &Record<'_>) -> TokenStream {
    let name = record.name;
    let parts = format_ident!("{}Members", name.unraw(), span = name.span());
    let (names, elements, visibilities): (Vec<_>, Vec<_>, Vec<_>) =
        record.members.iter().map(|member| (member.name, member.element, member.visibility)).collect();
    let numbers: Vec<_> = (0..names.len()).map(Literal::usize_unsuffixed).collect();
    let texts: Vec<_> = names.iter().map(|name| name.unraw().to_string()).collect();
    // One type parameter and one local a member: a local of the member's own name might be a constant of the user's.
    let places: Vec<_> = (0..names.len()).map(|n| format_ident!("A{n}")).collect();
    let locals: Vec<_> = (0..names.len()).map(|n| format_ident!("__{n}", span = Span::mixed_site())).collect();
    let all = format_ident!("__all", span = Span::mixed_site());
    let paths: Vec<_> = numbers
        .iter()
        .map(|n| quote!(::allotrope::__private::Under<P__, ::allotrope::__private::Tag<Self::Elements, #n>>))
        .collect();
    // A type that is neither an element nor a record fails its bound, at the member's type, and nothing else: within the implementation the
    // bounds are taken to hold.
    let bounds = elements.iter().map(|element| {
        let (first, last) = ends(element);
        let library = quote_spanned!(first=> ::allotrope);
        let record_trait = quote_spanned!(last=> Record);
        quote!(#element: #library::#record_trait)
    });

    let (parameters, arguments, clause) = record.generics.split_for_impl();
    // What a field holds is `'static`: so are its type parameters.
    let owned = record.generics.type_params().map(|parameter| {
        let name = &parameter.ident;
        quote!(#name: 'static)
    });
    let wheres = clause.iter().flat_map(|clause| &clause.predicates).map(ToTokens::to_token_stream).chain(owned);
    // Errors in what follows are the struct's: they stand at its name.
    quote_spanned! {name.span()=>
        const _: () = {
            #[doc(hidden)]
            #[allow(dead_code, unreachable_pub)]
            #[derive(Clone, Copy, Debug)]
            pub struct #parts<#(#places),*> {
                #(#visibilities #names: #places,)*
            }

            #[automatically_derived]
            #[allow(trivial_bounds, non_camel_case_types)]
            impl #parameters ::allotrope::Record for #name #arguments
            where
                #(#wheres,)*
                #(#bounds,)*
            {
                type Elements = (#(#elements,)*);
                const NAMES: &'static [&'static str] = &[#(#texts),*];
                type Tags = #parts<#(::allotrope::__private::Tag<Self::Elements, #numbers>),*>;
                const TAGS: Self::Tags = #parts { #(#names: ::allotrope::__private::Tag::NEW),* };
                type Members<'a, R__, P__, L__, X__> = #parts<#(::allotrope::__private::PartRef<'a, #elements, R__, #paths, L__, X__>),*>;
                type MembersMut<'a, R__, P__, L__, X__> = #parts<#(::allotrope::__private::PartMut<'a, #elements, R__, #paths, L__, X__>),*>;
                #[inline]
                fn members<'a, R__, P__, L__, X__>(
                    #all: ::allotrope::__private::MemberRefs<'a, Self, R__, P__, L__, X__>,
                ) -> Self::Members<'a, R__, P__, L__, X__> {
                    let (#(#locals,)*) = #all;
                    #parts { #(#names: #locals),* }
                }
                #[inline]
                fn members_mut<'a, R__, P__, L__, X__>(
                    #all: ::allotrope::__private::MemberMuts<'a, Self, R__, P__, L__, X__>,
                ) -> Self::MembersMut<'a, R__, P__, L__, X__> {
                    let (#(#locals,)*) = #all;
                    #parts { #(#names: #locals),* }
                }
                #[inline(always)]
                fn from_elements((#(#locals,)*): Self::Elements) -> Self {
                    Self { #(#names: #locals),* }
                }
                #[inline(always)]
                fn into_elements(self) -> Self::Elements {
                    (#(self.#names,)*)
                }
            }
        };
    }
}

/// The spans of a type's first and last tokens, which together are the span of it all.
fn ends(element: &Type) -> (Span, Span) {
    let mut tokens = element.to_token_stream().into_iter();
    let first = tokens.next().map_or_else(Span::call_site, |token| token.span());
    (first, tokens.last().map_or(first, |token| token.span()))
}
