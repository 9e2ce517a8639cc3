use insta::assert_snapshot;
use proc_macro2::TokenStream;
use quote::quote;

use super::{check, model, parse};
use crate::diagnostics::{Code, Diagnostics};

/// The expansion, formatted.
fn formatted(tokens: TokenStream) -> String {
    let layout = super::expand(tokens);
    let file = syn::parse2(quote!(type Layout = #layout;)).expect("the expansion is a type");
    prettyplease::unparse(&file)
}

/// The expansion without the path and the spaces.
fn short(tokens: TokenStream) -> String {
    super::expand(tokens).to_string().replace(' ', "").replace("::allotrope::layout::", "")
}

/// The codes that a layout is refused with.
fn codes(tokens: TokenStream) -> Vec<Code> {
    let layout = model::model(parse::parse(tokens).expect("the layout parses"));
    let mut errors = Diagnostics::default();
    check::check(&layout, &mut errors);
    errors.errors().iter().map(|error| error.code()).collect()
}

/// The text of the only error.
fn message(tokens: TokenStream) -> String {
    let layout = model::model(parse::parse(tokens).expect("the layout parses"));
    let mut errors = Diagnostics::default();
    check::check(&layout, &mut errors);
    assert_eq!(errors.errors().len(), 1);
    errors.errors()[0].text()
}

#[test]
fn chains_nest_from_the_root_down() {
    assert_eq!(short(quote!(dense(i).soa)), "Tree<0x1,PlaceSoa>");
    assert_eq!(short(quote!(dense(ji).split)), "Tree<0x21,PlaceSplit>");
    assert_eq!(short(quote!(dense(ij).dense(ij, 4).aos)), "Tree<0x12,Dense<0x12,4,4,1,1,PlaceAos>>");
    assert_eq!(short(quote!(dense(i).dense(j, 4).aos)), "Tree<0x1,Dense<0x2,1,4,1,1,PlaceAos>>");
    assert_eq!(
        short(quote!(dense(kji).dense(ij, 6).dense(kj, (3, 5)).aos)),
        "Tree<0x321,Dense<0x12,6,6,1,1,Dense<0x32,1,5,3,1,PlaceAos>>>"
    );
}

#[test]
fn a_size_of_the_outermost_node_stands_under_an_implicit_root() {
    assert_eq!(short(quote!(dense(ij, 8).aos)), short(quote!(dense(ij).dense(ij, 8).aos)));
    assert_eq!(short(quote!(dense(ij, (4, 2)).aos)), "Tree<0x12,Dense<0x12,4,2,1,1,PlaceAos>>");
    assert_eq!(short(quote!(dense(ji, (4, 2)).aos)), "Tree<0x21,Dense<0x21,2,4,1,1,PlaceAos>>");
}

#[test]
fn sizes_may_be_constants() {
    assert_eq!(short(quote!(dense(i, N).aos)), "Tree<0x1,Dense<0x1,{N},1,1,1,PlaceAos>>");
    assert_eq!(short(quote!(dense(ij, (2 * N, 4)).aos)), "Tree<0x12,Dense<0x12,{2*N},4,1,1,PlaceAos>>");
}

#[test]
fn groups_name_members_and_check_them() {
    assert_snapshot!(formatted(quote!(Node: dense(ij).place([v, m], [split(flags)]))), @r##"
    type Layout = ::allotrope::layout::Tree<
        0x12,
        ::allotrope::layout::PlaceGroups<
            Node,
            (
                (
                    ::allotrope::layout::Named<
                        {
                            #[allow(dead_code)]
                            fn every_member_is_placed() {
                                fn any<T>() -> T {
                                    ::core::unreachable!()
                                }
                                let _ = Node {
                                    v: any(),
                                    m: any(),
                                    flags: any(),
                                };
                            }
                            0x76000000000000000000000000000000
                        },
                        0x0,
                    >,
                    ::allotrope::layout::Named<0x6d000000000000000000000000000000, 0x0>,
                ),
                (::allotrope::layout::Taken<0x666c6167730000000000000000000000, 0x0>,),
            ),
        >,
    >;
    "##);
}

#[test]
fn a_record_without_groups_is_a_type_still() {
    let text = short(quote!(sim::Node: dense(i).aos));
    assert_eq!(text, "Tree<{#[allow(dead_code)]fnis_type(_:sim::Node){}0x1},PlaceAos>");
}

#[test]
fn a_record_with_parameters_is_named_where_they_are_known() {
    let text = short(quote!(Node<X>: dense(i).aos));
    assert_eq!(text, "Tree<0x1,PlaceAos>");
    let text = short(quote!(sim::Node<X, f32>: dense(i).place([v])));
    assert_eq!(text, "Tree<0x1,PlaceGroups<sim::Node<X,f32>,((Named<0x76000000000000000000000000000000,0x0>,),)>>");
}

#[test]
fn a_layout_with_errors_is_a_layout_that_carries_them() {
    assert_snapshot!(formatted(quote!(dens(ij).dense(jk))), @r##"
    type Layout = ::allotrope::layout::Tree<
        {
            ::core::compile_error! {
                "there is no node or place `dens` [A0401]\n= help: did you mean `dense`?"
            }
            ::core::compile_error! {
                "an inner `dense` needs a size, since only the outermost node takes it from the field's shape [A0407]\n= help: write `dense(jk, 8)`"
            }
            ::core::compile_error! {
                "the layout has no place, so it does not say how records lie in a block [A0409]\n= help: end it with `.aos`, `.soa`, `.split` or `.place([..])`"
            }
            0x1
        },
        ::allotrope::layout::PlaceAos,
    >;
    "##);
}

#[test]
fn what_is_no_chain_is_refused() {
    for tokens in [
        quote!(),
        quote!(dense(ij).),
        quote!(dense(ij).aos as u8),
        quote!(dense(ij).0),
        quote!(dense(ij).dense::<8>(ij).aos),
        quote!([v, m]),
        quote!(dense(ij) * dense(ij)),
        quote!(Node: ),
    ] {
        let text = super::expand(tokens.clone()).to_string();
        assert!(text.contains("[A0417]"), "{tokens}: {text}");
    }
}

#[test]
fn words() {
    assert_eq!(codes(quote!(dnse(ij).aos)), [Code::UnknownNode]);
    assert!(message(quote!(dnse(ij).aos)).contains("did you mean `dense`?"));
    assert!(message(quote!(dense(ij).sao)).contains("did you mean `soa`?"));
    assert!(message(quote!(AoSoA(16))).contains("write `AoSoA<N>` alone"));
    assert!(message(quote!(dense(ij).interleaved)).contains("the places are"));
}

#[test]
fn axes() {
    assert_eq!(codes(quote!(dense(xy).aos)), [Code::UnknownAxis]);
    assert!(message(quote!(dense(iy).aos)).contains("write `ij`"));
    assert!(message(quote!(dense(in_).aos)).contains("no axes `n`, `_`"));
    assert_eq!(codes(quote!(dense(iji).aos)), [Code::AxisTwice]);
    assert_eq!(codes(quote!(dense(j).aos)), [Code::MissingAxis]);
    assert_eq!(codes(quote!(dense(ik).dense(ik, 4).aos)), [Code::MissingAxis]);
    assert_eq!(codes(quote!(dense(j).dense(i, 4).aos)), []);
    assert_eq!(codes(quote!(dense.aos)), [Code::WrongArguments]);
    assert_eq!(codes(quote!(dense("ij").aos)), [Code::WrongArguments]);
}

#[test]
fn sizes() {
    assert_eq!(codes(quote!(dense(ij, 0).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(ij, -8).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(ij, 8.0).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(ij, 8u32).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(ij, 8usize).aos)), []);
    assert_eq!(codes(quote!(dense(i, 2_147_483_648).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(i, 99999999999999999999999999999999999999999999).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(dense(i, 65_536).dense(ij, 65_536).aos)), [Code::WrongSize]);
    assert!(message(quote!(dense(i, j).aos)).contains("`dense(ij)`"));
    assert_eq!(codes(quote!(dense(ij).dense(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(dense(ij, (4, 2, 1)).aos)), [Code::SizeCount]);
    assert_eq!(codes(quote!(dense(ij, 4, 2).aos)), [Code::WrongArguments]);
}

#[test]
fn places() {
    assert_eq!(codes(quote!(dense(ij))), [Code::NoPlace]);
    assert_eq!(codes(quote!(dense(ij).aos.dense(ij, 4))), [Code::AfterPlace]);
    assert_eq!(codes(quote!(dense(ij).aos.soa)), [Code::AfterPlace]);
    assert_eq!(codes(quote!(aos)), [Code::NoNode]);
    assert_eq!(codes(quote!(dense(ij).aos())), [Code::WrongArguments]);
    assert_eq!(codes(quote!(dense(ij).soa(v, m))), [Code::WrongArguments]);
}

#[test]
fn groups() {
    assert_eq!(codes(quote!(Node: dense(ij).place([v], [m, split(v)]))), [Code::PlacedTwice]);
    assert_eq!(codes(quote!(dense(ij).place([v], [m]))), [Code::NoRecord]);
    assert_eq!(codes(quote!(Node: dense(ij).place)), [Code::WrongGroup]);
    assert_eq!(codes(quote!(Node: dense(ij).place([]))), [Code::WrongGroup]);
    assert_eq!(codes(quote!(Node: dense(ij).place(v, [m]))), [Code::WrongGroup]);
    assert_eq!(codes(quote!(Node: dense(ij).place([v.0], [splt(m)]))), [Code::WrongGroup; 2]);
    assert_eq!(codes(quote!(Cell: dense(ij).place([node.v, flag], [split(node.m)]))), []);
    assert_eq!(codes(quote!(Cell: dense(ij).place([node.v, node.v]))), [Code::PlacedTwice]);
    assert_eq!(codes(quote!(Cell: dense(ij).place([node], [node.v]))), [Code::PlacedTwice]);
    assert_eq!(codes(quote!(Node: dense(ij).place([thirty_two_bytes_xxxxxxxxxxxxxxx]))), []);
    assert_eq!(codes(quote!(Node: dense(ij).place([thirty_three_bytes_xxxxxxxxxxxxxx]))), [Code::LongName]);
}

#[test]
fn all_errors_come_at_once() {
    assert_eq!(
        codes(quote!(dense(xi).dense(ij, 0).dens(ij, 4).place([v]).aos)),
        [Code::UnknownAxis, Code::WrongSize, Code::UnknownNode, Code::AfterPlace, Code::NoRecord]
    );
}

#[test]
fn nothing_makes_the_macro_panic() {
    let words = ["dense", "morton", "pointer", "dens", "aos", "place", "pad", "Aos"];
    let arguments =
        ["", "()", "(ij)", "(yx)", "(j, 0)", "(ij, (4))", "(iijjkkll, (1, 2), 3)", "([v], [v, 1], w)", "(\"i\")"];
    for (word, next) in words.iter().flat_map(|word| words.map(|next| (word, next))) {
        for (first, second) in arguments.iter().flat_map(|first| arguments.map(|second| (first, second))) {
            let text = format!("{word}{first}.{next}{second}");
            let tokens: TokenStream = text.parse().expect("tokens");
            assert!(!super::expand(tokens.clone()).is_empty(), "{text}");
            super::expand(quote!(a::Node: #tokens + #tokens));
        }
    }
}

#[test]
fn branches() {
    let two = short(quote!(Node: dense(ij).place([v]) + dense(ji).dense(i, 4).place([m])));
    assert!(two.starts_with("Both<Tree<0x12,PlaceSome<Node,"), "{two}");
    assert!(two.contains("Tree<0x21,Dense<0x1,4,1,1,1,PlaceSome<Node,"), "{two}");
    let three = short(quote!(R: dense(i).place([a]) + dense(i).place([b]) + dense(i).place([c])));
    assert_eq!(three.matches("Both<Tree<").count(), 2);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + dense(ij).aos)), [Code::WrongBranch]);
    assert_eq!(codes(quote!(dense(ij).aos + dense(ij, 8).soa)), [Code::WrongBranch; 2]);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + dense(i).place([m]))), [Code::WrongBranch]);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + dense(i).dense(j, 3).place([m]))), []);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + dense(ij).place([m], [v]))), [Code::PlacedTwice]);
    assert_eq!(codes(quote!(dense(ij).place([v]) + dense(ij).place([m]))), [Code::NoRecord]);
    let five = quote!(R: dense(i).place([a]) + dense(i).place([b]) + dense(i).place([c]) + dense(i).place([d]) + dense(i).place([e]));
    assert_eq!(codes(five), [Code::WrongBranch]);
}

#[test]
fn blocks_in_z_order() {
    assert_eq!(short(quote!(morton(ij, 8).aos)), "Tree<0x12,Curve<0x12,8,8,1,1,PlaceAos>>");
    assert_eq!(
        short(quote!(dense(ij).morton(ji, (4, N)).dense(ij, 3).soa)),
        "Tree<0x12,Curve<0x21,{N},4,1,1,Dense<0x12,3,3,1,1,PlaceSoa>>>"
    );
    assert_eq!(codes(quote!(morton(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(dense(ij).morton(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(morton(ij, (8, 12)).aos)), [Code::NotAPowerOfTwo]);
    assert_eq!(codes(quote!(morton(ij, 0).aos)), [Code::WrongSize]);
    assert_eq!(codes(quote!(morton(i, 1).aos)), []);
    assert!(message(quote!(morton(ij, 12).aos)).contains("the sizes near are 8 and 16"));
    assert!(message(quote!(Morton(8))).contains("write `Morton<N>` alone"));
}

#[test]
fn depth() {
    let sized = quote!(dense(i, 2).morton(i, 2).dense(i, 2).dense(i, 2).dense(i, 2));
    assert_eq!(codes(quote!(#sized.dense(i, 2).aos)), []);
    assert_eq!(codes(quote!(#sized.dense(i, 2).dense(i, 2).aos)), [Code::TooManyNodes]);
}

#[test]
fn padding() {
    assert_eq!(short(quote!(dense(ij).pad(64).aos)), "Tree<0x12,Padded<64,PlaceAos>>");
    assert_eq!(short(quote!(dense(i, 8).pad(LINE).soa)), "Tree<0x1,Dense<0x1,8,1,1,1,Padded<{LINE},PlaceSoa>>>");
    assert_eq!(codes(quote!(dense(ij).pad.aos)), [Code::WrongArguments]);
    assert_eq!(codes(quote!(dense(ij).pad(64, 32).aos)), [Code::WrongArguments]);
    for wrong in [quote!(0), quote!(48), quote!(8192), quote!(-8), quote!("64"), quote!(i)] {
        assert_eq!(codes(quote!(dense(ij).pad(#wrong).aos)), [Code::WrongPad], "{wrong}");
    }
    assert_eq!(codes(quote!(dense(ij).pad(64).dense(ij, 8).aos)), [Code::WrongPad]);
    assert_eq!(codes(quote!(dense(ij).pad(64).pad(64).aos)), [Code::WrongPad]);
    assert_eq!(codes(quote!(dense(ij).aos.pad(64))), [Code::AfterPlace]);
    assert_eq!(codes(quote!(dense(ij).pad(64))), [Code::NoPlace]);
    assert_eq!(codes(quote!(pad(64).aos)), [Code::NoNode]);
}

#[test]
fn sparse_chains_are_cut_where_cells_point() {
    let cases = [
        (
            quote!(pointer(ij, 16).dense(ij, 8).aos),
            "Grown<Grid<0x12>,Table<Dense<0x12,16,16,1,1,Entry>,Leaf>,Dense<0x12,8,8,1,1,PlaceAos>>",
        ),
        (quote!(pointer(ji).aos), "Grown<Grid<0x21>,Table<Entry,Leaf>,Dense<0x21,1,1,1,1,PlaceAos>>"),
        (
            quote!(dense(i).pointer(j, 4).pointer(ij, (2, 3)).morton(ij, 4).split),
            "Grown<Grid<0x1>,Table<Dense<0x2,1,4,1,1,Entry>,Table<Dense<0x12,2,3,1,1,Entry>,Leaf>>,Curve<0x12,4,4,1,1,PlaceSplit>>",
        ),
        (quote!(hash(ijk).bitmasked(ijk, 8).soa), "Grown<Hash<0x123>,Leaf,Masked<Dense<0x123,8,8,8,1,PlaceSoa>>>"),
        (quote!(hash(ij).pad(64).aos), "Grown<Hash<0x12>,Leaf,Dense<0x12,1,1,1,1,Padded<64,PlaceAos>>>"),
        (quote!(bitmasked(ij).aos), "Grown<Grid<0x12>,Leaf,Masked<Dense<0x12,1,64,1,1,PlaceAos>>>"),
        (
            quote!(bitmasked(ij, 4).bitmasked(ij, 2).dense(ij, 8).aos),
            "Grown<Grid<0x12>,Leaf,Dense<0x12,4,4,1,1,Masked<Dense<0x12,2,2,1,1,Dense<0x12,8,8,1,1,PlaceAos>>>>>",
        ),
        (
            quote!(bitmasked(ij, 4).pointer(ij, 2).aos),
            "Grown<Grid<0x12>,Table<Dense<0x12,4,4,1,1,Dense<0x12,2,2,1,1,Entry>>,Leaf>,Dense<0x12,1,1,1,1,PlaceAos>>",
        ),
        (
            quote!(dense(i).dynamic(j, 128).aos),
            "Listed<::allotrope::Ij,Grid<0x1>,List<Entry,0x2,128,0>,Dense<0x2,1,128,1,1,PlaceAos>>",
        ),
        (
            quote!(dynamic(i, 1000, chunk = 32).soa),
            "Listed<::allotrope::I,Grid<0x0>,List<Entry,0x1,1000,32>,Dense<0x1,32,1,1,1,PlaceSoa>>",
        ),
        (
            quote!(pointer(ij, 8).dense(ij, 4).dynamic(k, MOST).aos),
            "Listed<::allotrope::Ijk,Grid<0x12>,Table<Dense<0x12,8,8,1,1,Entry>,List<Dense<0x12,4,4,1,1,Entry>,0x3,{MOST},0>>,Dense<0x3,1,1,{MOST},1,PlaceAos>>",
        ),
        (
            quote!(hash(ij).dynamic(k, 64).aos),
            "Listed<::allotrope::Ijk,Hash<0x12>,List<Entry,0x3,64,0>,Dense<0x3,1,1,64,1,PlaceAos>>",
        ),
    ];
    for (layout, expected) in cases {
        assert_eq!(codes(layout.clone()), [], "{layout}");
        assert_eq!(short(layout), expected);
    }
}

#[test]
fn sparse_nodes_in_wrong_places() {
    assert_eq!(codes(quote!(dense(ij).hash(ij).aos)), [Code::WrongHash]);
    assert_eq!(codes(quote!(hash(ij, 8).aos)), [Code::WrongHash]);
    assert_eq!(codes(quote!(hash(ij, 8, 8).aos)), [Code::WrongHash]);
    assert_eq!(codes(quote!(hash.aos)), [Code::WrongArguments]);
    assert_eq!(codes(quote!(hash(ij).pointer(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(hash(ij).bitmasked(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(pointer(ij).dense(ij).aos)), [Code::NoSize]);
    assert_eq!(codes(quote!(dense(i).dynamic(j).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 0).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 2147483648).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64, chunk = 65).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64, chunk = 0).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64, chunk = 64).aos)), []);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64, 8).aos)), [Code::WrongArguments]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64, block = 8).aos)), [Code::WrongArguments]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, chunk = 8).aos)), [Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic().aos)), [Code::WrongArguments, Code::WrongMaximum]);
    assert_eq!(codes(quote!(dense(i).dynamic(jk, 64).aos)), [Code::WrongList]);
    assert_eq!(codes(quote!(dense(i).dynamic(i, 64).aos)), [Code::WrongList]);
    assert_eq!(codes(quote!(dense(i).dynamic(j, 64).dense(k, 8).aos)), [Code::WrongList]);
    assert_eq!(codes(quote!(dense(i).dynamic(k, 64).aos)), [Code::MissingAxis]);
    assert_eq!(codes(quote!(dense(j).dynamic(i, 64).aos)), [Code::WrongList]);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + hash(ij).place([m]))), [Code::WrongBranch]);
    assert_eq!(codes(quote!(Node: dense(ij).place([v]) + pointer(ij).dense(ij, 8).place([m]))), []);
}
