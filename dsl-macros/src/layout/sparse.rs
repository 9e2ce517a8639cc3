//! Model to tokens: layouts with sparse nodes.
//!
//! The chain is cut behind each node whose cells point to what stands below. What lies between two cuts is one table of pointers; what
//! lies below the last is a block of records.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::expand::{block, chain, order, size};
use super::model::{AXES, Axis, AxisList, Kind, List, Node};

/// The cells along the last axis of an outermost `bitmasked` without a size: those whose activity bits are one word.
const BITS: usize = 64;

/// The type of a sparse branch above a place.
pub(super) fn expand(root: &TokenStream, nodes: &[&Node], list: Option<&List>, place: TokenStream) -> TokenStream {
    let hash = nodes.first().is_some_and(|node| node.kind == Kind::Hash);
    // The nodes between the cuts, each with the node that it ends with.
    let mut tables: Vec<Vec<&Node>> = Vec::new();
    let mut rest: Vec<&Node> = Vec::new();
    for node in nodes.iter().skip(usize::from(hash)) {
        rest.push(node);
        if node.kind == Kind::Pointer {
            tables.push(std::mem::take(&mut rest));
        }
    }
    let entry = || quote!(::allotrope::layout::Entry);
    let (brick, bottom) = match list {
        Some(list) => {
            let axis = order(list.axes.as_ref());
            let (most, chunk) = (size(list.most.as_ref()), list.chunk.as_ref().map(|(_, chunk)| size(Some(chunk))));
            let entries = along(list.axes.as_ref(), chunk.as_ref().unwrap_or(&most));
            let (cells, chunk) = (chain(rest.into_iter(), entry()), chunk.unwrap_or_else(|| quote!(0)));
            let brick = quote!(::allotrope::layout::Dense<#axis, #(#entries),*, #place>);
            (brick, quote!(::allotrope::layout::List<#cells, #axis, #most, #chunk>))
        }
        None => (brick(&rest, nodes, place), quote!(::allotrope::layout::Leaf)),
    };
    let levels = tables.into_iter().rev().fold(bottom, |below, table| {
        let cells = chain(table.into_iter(), entry());
        quote!(::allotrope::layout::Table<#cells, #below>)
    });
    let kind = if hash { quote!(Hash) } else { quote!(Grid) };
    let root = quote!(::allotrope::layout::#kind<#root>);
    match list {
        Some(list) => {
            let axes = nodes.iter().filter_map(|node| node.axes.as_ref()).chain(&list.axes);
            let highest = axes.flat_map(|list| &list.axes).max().map_or(0, |axis| axis.0);
            let letters: String = AXES[..=highest].iter().collect();
            let axes = format_ident!("{}{}", letters[..1].to_uppercase(), letters[1..]);
            quote!(::allotrope::layout::Listed<::allotrope::#axes, #root, #levels, #brick>)
        }
        None => quote!(::allotrope::layout::Grown<#root, #levels, #brick>),
    }
}

/// A block of records: the nodes below the last that points, the innermost `bitmasked` of them with its bits.
fn brick(rest: &[&Node], nodes: &[&Node], place: TokenStream) -> TokenStream {
    let masked = rest.iter().rposition(|node| node.kind == Kind::Bitmasked);
    let mut brick = place;
    for (number, node) in rest.iter().enumerate().rev() {
        let is_masked = Some(number) == masked;
        brick = match (&node.sizes, is_masked) {
            (Some(_), _) => block(node, &brick),
            (None, true) => {
                let (order, sizes) = (order(node.axes.as_ref()), along(node.axes.as_ref(), &size_of_row()));
                quote!(::allotrope::layout::Dense<#order, #(#sizes),*, #brick>)
            }
            (None, false) => continue,
        };
        if is_masked {
            brick = quote!(::allotrope::layout::Masked<#brick>);
        }
    }
    if !rest.iter().any(|node| node.sizes.is_some() || node.kind == Kind::Bitmasked) {
        // One record a pointer.
        let order = order(nodes.last().and_then(|node| node.axes.as_ref()));
        return quote!(::allotrope::layout::Dense<#order, 1, 1, 1, 1, #brick>);
    }
    brick
}

fn size_of_row() -> TokenStream {
    let literal = proc_macro2::Literal::usize_unsuffixed(BITS);
    quote!(#literal)
}

/// Sizes along `i j k l`: so many along the last axis of a list, 1 along the others.
fn along(axes: Option<&AxisList>, size: &TokenStream) -> [TokenStream; AXES.len()] {
    let last = axes.and_then(|list| list.axes.last()).copied();
    std::array::from_fn(|axis| if last == Some(Axis(axis)) { size.clone() } else { quote!(1) })
}
