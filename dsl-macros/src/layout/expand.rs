//! Model to tokens: the layout's type.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Ident, Path};

use super::model::{
    AXES, Axis, AxisList, Branch, Kind, LONGEST_NAME, Layout, Node, Pad, Place, PlaceKind, Placed, Size, Step,
};

/// The type of a layout that has passed every check.
pub(super) fn expand(layout: &Layout) -> TokenStream {
    // A check of all members stands at the first one that is placed.
    // What a check in a constant cannot say of a record that takes types, the library says when the field is compiled.
    let record = layout.record.as_ref().filter(|record| !takes_types(record));
    let mut check = record.map(|record| members_check(layout, record));
    let branches: Vec<TokenStream> =
        layout.branches.iter().map(|branch| expand_branch(layout, branch, &mut check)).collect();
    let both = |rest: TokenStream, first: &TokenStream| quote!(::allotrope::layout::Both<#first, #rest>);
    let (last, others) = branches.split_last().expect("a layout has a branch");
    others.iter().rev().fold(last.clone(), both)
}

fn expand_branch(layout: &Layout, branch: &Branch, check: &mut Option<TokenStream>) -> TokenStream {
    let (mut nodes, mut list) = (Vec::new(), None);
    let mut inner = TokenStream::new();
    let mut pad = None;
    for step in &branch.steps {
        match step {
            Step::Node(node) => nodes.push(node),
            Step::List(found) => list = Some(&**found),
            Step::Place(found) => inner = place(found, layout, check),
            Step::Pad(found) => pad = Some(found),
            Step::Unknown(_) => {}
        }
    }
    if let Some(Pad { bytes: Some(bytes), .. }) = pad {
        let bytes = size(Some(bytes));
        inner = quote!(::allotrope::layout::Padded<#bytes, #inner>);
    }
    // The outermost node takes as many cells as the shape needs; a size given there groups them.
    let mut root = nodes.first().map_or_else(|| quote!(0x0), |node| order(node.axes.as_ref()));
    if let Some(record) = &layout.record
        && !layout.names_members()
        && !takes_types(record)
    {
        // The name stands for nothing here, but must be a type's.
        root = quote!({ #[allow(dead_code)] fn is_type(_: #record) {} #root });
    }
    if list.is_some() || nodes.iter().any(|node| node.kind.is_sparse()) {
        return super::sparse::expand(&root, &nodes, list, inner);
    }
    let inner = chain(nodes.iter().copied(), inner);
    quote!(::allotrope::layout::Tree<#root, #inner>)
}

/// Nodes of constant size, those that have none left out, above what stands below.
pub(super) fn chain<'a>(nodes: impl DoubleEndedIterator<Item = &'a Node>, below: TokenStream) -> TokenStream {
    nodes.rev().filter(|node| node.sizes.is_some()).fold(below, |below, node| block(node, &below))
}

/// A node of constant size above what stands below.
pub(super) fn block(node: &Node, below: &TokenStream) -> TokenStream {
    let order = order(node.axes.as_ref());
    let [a, b, c, d] = sizes(node);
    let kind = if node.kind == Kind::Morton { quote!(Curve) } else { quote!(Dense) };
    quote!(::allotrope::layout::#kind<#order, #a, #b, #c, #d, #below>)
}

/// The type that stands for a layout with errors: it carries them and is a layout, so that they are the only errors.
pub(super) fn fallback(errors: TokenStream) -> TokenStream {
    quote!(::allotrope::layout::Tree<{ #errors 0x1 }, ::allotrope::layout::PlaceAos>)
}

/// Axes as a number: a hexadecimal digit each, `i` is 1.
pub(super) fn order(list: Option<&AxisList>) -> TokenStream {
    let axes = list.map_or(&[Axis(0)][..], |list| &list.axes);
    let digits: String = axes.iter().map(|axis| char::from(b'1' + axis.0 as u8)).collect();
    let literal: proc_macro2::Literal = format!("0x{digits}").parse().expect("digits are a number");
    quote!(#literal)
}

/// Sizes along `i j k l`, 1 where the node has no such axis.
fn sizes(node: &Node) -> [TokenStream; AXES.len()] {
    let axes = node.axes.as_ref().map_or(&[][..], |list| &list.axes);
    std::array::from_fn(|axis| {
        size(axes.iter().position(|&named| named == Axis(axis)).and_then(|at| node.sizes.as_ref()?.along(at)))
    })
}

pub(super) fn size(size: Option<&Size>) -> TokenStream {
    match size {
        Some(Size::Number(_, literal)) => quote!(#literal),
        Some(Size::Constant(expr)) => quote!({ #expr }),
        Some(Size::Wrong(..)) | None => quote!(1),
    }
}

/// Whether a record is written with types, `Point<X>`: they may be parameters of what the layout stands in, which no item in a constant may name.
fn takes_types(record: &Path) -> bool {
    record.segments.iter().any(|segment| !segment.arguments.is_none())
}

fn place(place: &Place, layout: &Layout, check: &mut Option<TokenStream>) -> TokenStream {
    match (&place.kind, &layout.record) {
        (PlaceKind::Groups(groups), Some(record)) => {
            let kind = if layout.branches.len() > 1 { quote!(PlaceSome) } else { quote!(PlaceGroups) };
            let groups = groups.iter().map(|group| {
                let members = group.members.iter().map(|member| placed(member, check.take()));
                quote!((#(#members,)*))
            });
            quote!(::allotrope::layout::#kind<#record, (#(#groups,)*)>)
        }
        (PlaceKind::Aos | PlaceKind::Groups(_), _) => quote!(::allotrope::layout::PlaceAos),
        (PlaceKind::Soa, _) => quote!(::allotrope::layout::PlaceSoa),
        (PlaceKind::Split, _) => quote!(::allotrope::layout::PlaceSplit),
    }
}

/// A member as a type: its name's bytes are two numbers. The first member of all carries the check of them all.
fn placed(member: &Placed, check: Option<TokenStream>) -> TokenStream {
    let mut bytes = [0; LONGEST_NAME];
    let name = member.text();
    bytes[..name.len()].copy_from_slice(name.as_bytes());
    let (high, low) = bytes.split_at(LONGEST_NAME / 2);
    let [high, low] = [high, low].map(|half| {
        let number = half.iter().fold(0u128, |number, &byte| number << 8 | u128::from(byte));
        let literal: proc_macro2::Literal = format!("{number:#x}").parse().expect("digits are a number");
        literal
    });
    let high = check.map_or_else(|| quote!(#high), |check| quote!({ #check #high }));
    if member.split {
        quote!(::allotrope::layout::Taken<#high, #low>)
    } else {
        quote!(::allotrope::layout::Named<#high, #low>)
    }
}

/// A function that would build the record from the names placed, so that a member unknown or left out is an error at the
/// user's tokens. It is never called.
fn members_check(layout: &Layout, record: &Path) -> TokenStream {
    let steps = layout.branches.iter().flat_map(|branch| &branch.steps);
    let groups = steps.filter_map(|step| match step {
        Step::Place(Place { kind: PlaceKind::Groups(groups), .. }) => Some(groups),
        _ => None,
    });
    let members: Vec<&Placed> = groups.flatten().flat_map(|group| &group.members).collect();
    // A record among the members is named once for each of its own.
    let first = |place: &usize| !members[..*place].iter().any(|known| known.name == members[*place].name);
    let names = (0..members.len()).filter(first).map(|place| &members[place].name);
    let paths = members.iter().filter(|member| !member.inner.is_empty()).map(|member| {
        let then = |path: TokenStream, inner: &Ident| quote!(.then(|tags| tags.#inner #path));
        let (name, path) = (&member.name, member.inner.iter().rev().fold(TokenStream::new(), then));
        quote!(let _ = <#record as ::allotrope::Record>::TAGS.#name #path;)
    });
    quote! {
        #[allow(dead_code)]
        fn every_member_is_placed() {
            fn any<T>() -> T {
                ::core::unreachable!()
            }
            let _ = #record { #(#names: any()),* };
            #(#paths)*
        }
    }
}
