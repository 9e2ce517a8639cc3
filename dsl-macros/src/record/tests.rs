use insta::assert_snapshot;
use proc_macro2::TokenStream;
use quote::quote;

use super::{check, expand, model, parse};
use crate::diagnostics::{Code, Diagnostics};

/// The expansion, formatted.
fn formatted(tokens: TokenStream) -> String {
    let file = syn::parse2(super::expand(tokens)).expect("the expansion is items");
    prettyplease::unparse(&file)
}

/// The codes that a struct is refused with.
fn codes(tokens: TokenStream) -> Vec<Code> {
    let item = parse::parse(tokens).expect("the item parses");
    let mut errors = Diagnostics::default();
    check::check(&item, &mut errors);
    errors.errors().iter().map(|error| error.code()).collect()
}

#[test]
fn a_record_has_a_place_for_each_member() {
    assert_snapshot!(formatted(quote!(pub struct Node { pub v: Vec2, m: f32 })), @r##"
    const _: () = {
        #[doc(hidden)]
        #[allow(dead_code, unreachable_pub)]
        #[derive(Clone, Copy, Debug)]
        pub struct NodeMembers<A0, A1> {
            pub v: A0,
            m: A1,
        }
        #[automatically_derived]
        #[allow(trivial_bounds, non_camel_case_types)]
        impl ::allotrope::Record for Node
        where
            Vec2: ::allotrope::Record,
            f32: ::allotrope::Record,
        {
            type Elements = (Vec2, f32);
            const NAMES: &'static [&'static str] = &["v", "m"];
            type Tags = NodeMembers<
                ::allotrope::__private::Tag<Self::Elements, 0>,
                ::allotrope::__private::Tag<Self::Elements, 1>,
            >;
            const TAGS: Self::Tags = NodeMembers {
                v: ::allotrope::__private::Tag::NEW,
                m: ::allotrope::__private::Tag::NEW,
            };
            type Members<'a, R__, P__, L__, X__> = NodeMembers<
                ::allotrope::__private::PartRef<
                    'a,
                    Vec2,
                    R__,
                    ::allotrope::__private::Under<
                        P__,
                        ::allotrope::__private::Tag<Self::Elements, 0>,
                    >,
                    L__,
                    X__,
                >,
                ::allotrope::__private::PartRef<
                    'a,
                    f32,
                    R__,
                    ::allotrope::__private::Under<
                        P__,
                        ::allotrope::__private::Tag<Self::Elements, 1>,
                    >,
                    L__,
                    X__,
                >,
            >;
            type MembersMut<'a, R__, P__, L__, X__> = NodeMembers<
                ::allotrope::__private::PartMut<
                    'a,
                    Vec2,
                    R__,
                    ::allotrope::__private::Under<
                        P__,
                        ::allotrope::__private::Tag<Self::Elements, 0>,
                    >,
                    L__,
                    X__,
                >,
                ::allotrope::__private::PartMut<
                    'a,
                    f32,
                    R__,
                    ::allotrope::__private::Under<
                        P__,
                        ::allotrope::__private::Tag<Self::Elements, 1>,
                    >,
                    L__,
                    X__,
                >,
            >;
            #[inline]
            fn members<'a, R__, P__, L__, X__>(
                __all: ::allotrope::__private::MemberRefs<'a, Self, R__, P__, L__, X__>,
            ) -> Self::Members<'a, R__, P__, L__, X__> {
                let (__0, __1) = __all;
                NodeMembers { v: __0, m: __1 }
            }
            #[inline]
            fn members_mut<'a, R__, P__, L__, X__>(
                __all: ::allotrope::__private::MemberMuts<'a, Self, R__, P__, L__, X__>,
            ) -> Self::MembersMut<'a, R__, P__, L__, X__> {
                let (__0, __1) = __all;
                NodeMembers { v: __0, m: __1 }
            }
            #[inline(always)]
            fn from_elements((__0, __1): Self::Elements) -> Self {
                Self { v: __0, m: __1 }
            }
            #[inline(always)]
            fn into_elements(self) -> Self::Elements {
                (self.v, self.m)
            }
        }
    };
    "##);
}

#[test]
fn one_member_makes_a_tuple_still() {
    let item = parse::parse(quote!(
        struct Mass {
            pub(crate) r#type: f32,
        }
    ))
    .expect("the item parses");
    let text = expand::expand(&model::model(&item)).to_string();
    assert!(text.contains("type Elements = (f32 ,)"), "{text}");
    assert!(text.contains(r#"& ["type"]"#), "{text}");
    assert!(text.contains("pub (crate) r#type : A0"), "{text}");
}

#[test]
fn what_is_no_struct_with_named_members_is_refused() {
    assert_eq!(
        codes(quote!(
            enum Phase {
                Water,
                Ice,
            }
        )),
        [Code::NotAStruct]
    );
    assert_eq!(codes(quote!(union Bits { a: f32, b: u32 })), [Code::NotAStruct]);
    assert_eq!(
        codes(quote!(
            struct Pair(f32, f32);
        )),
        [Code::UnnamedMembers]
    );
    assert_eq!(
        codes(quote!(
            struct Nothing;
        )),
        [Code::UnnamedMembers]
    );
    assert_eq!(
        codes(quote!(
            struct Nothing {}
        )),
        [Code::MemberCount]
    );
    assert_eq!(
        codes(quote!(
            struct Node {
                v: Vec2,
            }
        )),
        []
    );
}

#[test]
fn all_errors_come_at_once() {
    assert_eq!(
        codes(quote!(
            struct Pair<'a>(&'a f32, &'a f32);
        )),
        [Code::UnnamedMembers, Code::BorrowingRecord]
    );
}

#[test]
fn a_record_has_24_members_at_most() {
    let members = |count: usize| {
        let names = (0..count).map(|n| quote::format_ident!("m{n}"));
        quote!(struct Many { #(#names: f32),* })
    };
    assert_eq!(codes(members(check::MOST_MEMBERS)), []);
    assert_eq!(codes(members(check::MOST_MEMBERS + 1)), [Code::MemberCount]);
}
