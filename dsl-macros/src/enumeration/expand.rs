//! Model to tokens.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote_spanned;

use super::model::Enumeration;

/// `impl Enumeration`: two matches, without a cast and without `unsafe`.
pub(super) fn expand(enumeration: &Enumeration<'_>) -> TokenStream {
    let name = &enumeration.item.ident;
    let integer = Ident::new(enumeration.integer, name.span());
    let all = enumeration.variants.iter().map(|(variant, value)| {
        let value = Literal::i128_unsuffixed(*value);
        quote_spanned!(name.span()=> Self::#variant => #value)
    });
    // Every integer becomes a variant: one that no variant has, which no program can store, becomes the variant of 0.
    let others = enumeration.variants.iter().filter(|(_, value)| *value != 0).map(|(variant, value)| {
        let value = Literal::i128_unsuffixed(*value);
        quote_spanned!(name.span()=> #value => Self::#variant)
    });
    let zero = enumeration.variants.iter().filter(|(_, value)| *value == 0).map(|(variant, _)| variant).take(1);
    quote_spanned! {name.span()=>
        #[automatically_derived]
        impl ::allotrope::Enumeration for #name {
            type Code = #integer;
            #[inline(always)]
            fn from_code(code: #integer) -> Self {
                match code {
                    #(#others,)*
                    _ => #(Self::#zero)*,
                }
            }
            #[inline(always)]
            fn code(self) -> #integer {
                match self {
                    #(#all,)*
                }
            }
        }
        ::allotrope::__enumeration! { #name }
    }
}
