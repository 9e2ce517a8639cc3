use insta::assert_snapshot;
use proc_macro2::TokenStream;
use quote::quote;

use super::model;
use crate::diagnostics::{Code, Diagnostics};

/// The integer that an enum is stored as, and the codes that it is refused with.
fn judged(tokens: TokenStream) -> (Option<&'static str>, Vec<Code>) {
    let item = syn::parse2(tokens).expect("the item parses");
    let mut errors = Diagnostics::default();
    let integer = model::model(&item, &mut errors).map(|enumeration| enumeration.integer);
    (integer, errors.errors().iter().map(|error| error.code()).collect())
}

#[test]
fn an_enum_is_two_matches() {
    let tokens = super::expand(quote!(
        enum Phase {
            Ice = -1,
            Water,
            Steam,
        }
    ));
    let file = syn::parse2(tokens).expect("the expansion is items");
    assert_snapshot!(prettyplease::unparse(&file), @r"
    #[automatically_derived]
    impl ::allotrope::Enumeration for Phase {
        type Code = i8;
        #[inline(always)]
        fn from_code(code: i8) -> Self {
            match code {
                -1 => Self::Ice,
                1 => Self::Steam,
                _ => Self::Water,
            }
        }
        #[inline(always)]
        fn code(self) -> i8 {
            match self {
                Self::Ice => -1,
                Self::Water => 0,
                Self::Steam => 1,
            }
        }
    }
    ::allotrope::__enumeration! {
        Phase
    }
    ");
}

#[test]
fn the_smallest_integer_is_chosen_where_none_is_named() {
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = 255,
            }
        ))
        .0,
        Some("u8")
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = 256,
            }
        ))
        .0,
        Some("u16")
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = -129,
            }
        ))
        .0,
        Some("i16")
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = 4_294_967_295,
            }
        ))
        .0,
        Some("u32")
    );
    assert_eq!(
        judged(quote!(
            #[repr(C, i32)]
            enum A {
                X,
                Y,
            }
        ))
        .0,
        Some("i32")
    );
}

#[test]
fn what_one_integer_cannot_hold_is_refused() {
    assert_eq!(
        judged(quote!(
            struct A {
                x: f32,
            }
        ))
        .1,
        [Code::NotFieldless]
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y(f32),
            }
        ))
        .1,
        [Code::NotFieldless]
    );
    assert_eq!(
        judged(quote!(
            enum A {}
        ))
        .1,
        [Code::NoZeroVariant]
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X = 1,
                Y,
            }
        ))
        .1,
        [Code::NoZeroVariant]
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = OTHER,
            }
        ))
        .1,
        [Code::Discriminant]
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X,
                Y = 4_294_967_296,
            }
        ))
        .1,
        [Code::Discriminant]
    );
    assert_eq!(
        judged(quote!(
            enum A {
                X = -1,
                Z,
                Y = 4_294_967_295,
            }
        ))
        .1,
        [Code::Discriminant]
    );
    assert_eq!(
        judged(quote!(
            #[repr(u64)]
            enum A {
                X,
            }
        ))
        .1,
        [Code::Discriminant]
    );
}
