//! The rules of layouts as wholes.

use super::layout::{Chain, Layout, NodeKind, Place};
use super::nodes::{AXES, TOO_MANY};
use super::scan::Text;
use crate::lab::errors::LabError;

/// The most nodes with a size.
const MOST_NODES: usize = 6;
/// The most cells of all nodes with a size.
const MOST_CELLS: u128 = 1 << 48;
/// The most branches.
const MOST_BRANCHES: usize = 4;

/// Reports what is wrong with a layout whose nodes are right.
pub(super) fn check(text: Text<'_>, layout: &Layout) -> Result<(), LabError> {
    let all: String = AXES[..layout.rank].iter().collect();
    for chain in &layout.branches {
        if chain.nodes.iter().filter(|node| node.sizes.is_some()).count() > MOST_NODES {
            return Err(text.error(
                &chain.at,
                format!("more than {MOST_NODES} nodes have a size; make one node of some that nest"),
            ));
        }
        let lists = chain.list.iter().map(|list| list.axis);
        let named: Vec<usize> = chain.nodes.iter().flat_map(|node| node.axes.iter().copied()).chain(lists).collect();
        if let Some(missing) = (0..layout.rank).find(|axis| !named.contains(axis)) {
            let message = format!(
                "axis `{}` is named nowhere here; axes begin with `i` and leave none out: name all of `{all}`",
                AXES[missing]
            );
            return Err(text.error(&chain.at, message));
        }
        if let Some(list) = chain.list.filter(|list| list.axis + 1 != layout.rank) {
            let (letter, last) = (AXES[list.axis], AXES[layout.rank - 1]);
            return Err(text.error(
                &chain.at,
                format!("axis `{letter}` of `dynamic` is not the last one; name the list's axis `{last}`"),
            ));
        }
        for (axis, letter) in AXES.iter().enumerate().take(layout.rank) {
            if span(chain, axis) >= TOO_MANY {
                return Err(text.error(&chain.at, format!("the blocks along axis `{letter}` are too large together, since indices are `i32`; write smaller ones")));
            }
        }
        let cells = (0..AXES.len()).map(|axis| span(chain, axis)).fold(1, u128::saturating_mul);
        if cells > MOST_CELLS {
            return Err(
                text.error(&chain.at, "the blocks have more cells than a machine can address; write smaller ones")
            );
        }
    }
    check_branches(text, layout)
}

/// Cells along an axis of all nodes with a size.
fn span(chain: &Chain, axis: usize) -> u128 {
    let sizes = chain
        .nodes
        .iter()
        .filter_map(|node| Some(node.sizes.as_ref()?[node.axes.iter().position(|&named| named == axis)?] as u128));
    sizes.fold(1, u128::saturating_mul)
}

fn check_branches(text: Text<'_>, layout: &Layout) -> Result<(), LabError> {
    if layout.branches.len() < 2 {
        return Ok(());
    }
    if let Some(chain) = layout.branches.get(MOST_BRANCHES) {
        return Err(text.error(
            &chain.at,
            format!("a layout has {MOST_BRANCHES} branches at most; put members that are used together in one"),
        ));
    }
    for chain in &layout.branches {
        if !matches!(chain.place, Some(Place::Groups(_))) {
            return Err(text
                .error(&chain.at, "this branch does not say which members it holds; end it with `.place([v], [m])`"));
        }
        if chain.list.is_some() || chain.nodes.iter().any(|node| node.kind == NodeKind::Hash) {
            return Err(text.error(
                &chain.at,
                "`hash` and `dynamic` stand in layouts of one branch; give these members a field of their own",
            ));
        }
    }
    Ok(())
}
