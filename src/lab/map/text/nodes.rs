//! The rules of nodes, each error with what to write instead.

use std::ops::Range;

use super::layout::{Chain, Node, NodeKind, Place, unknown};
use super::places::{groups, list, pad};
use super::scan::Text;
use super::syntax::{Argument, Value, Word};
use crate::lab::errors::LabError;

/// The letters of the axes.
pub(super) const AXES: [char; 4] = ['i', 'j', 'k', 'l'];

/// Every word that can stand in a chain.
pub(super) const WORDS: [&str; 11] =
    ["dense", "pointer", "bitmasked", "hash", "dynamic", "morton", "aos", "soa", "split", "place", "pad"];

/// Indices are `i32`, so this many cells along an axis are too many.
pub(super) const TOO_MANY: u128 = 1 << 31;

/// Adds a word to a chain.
pub(super) fn add(text: Text<'_>, word: &Word<'_>, chain: &mut Chain) -> Result<(), LabError> {
    let Word { name, at, arguments } = word;
    let kind = match *name {
        "dense" => Some(NodeKind::Dense),
        "morton" => Some(NodeKind::Morton),
        "pointer" => Some(NodeKind::Pointer),
        "bitmasked" => Some(NodeKind::Bitmasked),
        "hash" => Some(NodeKind::Hash),
        _ => None,
    };
    if !WORDS.contains(name) {
        return Err(text.error(at, unknown(name)));
    }
    if chain.place.is_some() {
        return Err(text.error(
            at,
            format!("`{name}` stands behind the place, which closes the layout; put it before, or leave it out"),
        ));
    }
    let is_node = kind.is_some() || *name == "dynamic";
    if is_node && (chain.pad.is_some() || chain.list.is_some()) {
        let before = if chain.pad.is_some() { "pad" } else { "dynamic" };
        return Err(text.error(
            at,
            format!("`{name}` stands behind `{before}`, which comes right before the place; change their order"),
        ));
    }
    if !is_node && chain.nodes.is_empty() && chain.list.is_none() {
        return Err(text.error(at, format!("there are no cells to place; begin with a node: `dense(ij).{name}`")));
    }
    let arguments = arguments.as_deref();
    if let Some(kind) = kind {
        let outermost = chain.nodes.is_empty();
        let node = node(text, word, kind, outermost)?;
        chain.nodes.push(node);
        return Ok(());
    }
    match *name {
        "dynamic" => chain.list = Some(list(text, word, chain)?),
        "pad" => chain.pad = Some(pad(text, word, chain)?),
        "place" => chain.place = Some(Place::Groups(groups(text, word)?)),
        _ => {
            if arguments.is_some() {
                return Err(text.error(
                    at,
                    format!(
                        "the place `{name}` takes no arguments; write `.{name}`, or `.place([v], [m])` to name members"
                    ),
                ));
            }
            chain.place = Some(match *name {
                "aos" => Place::Aos,
                "soa" => Place::Soa,
                _ => Place::Split,
            });
        }
    }
    Ok(())
}

/// The axes that the first argument of a node names.
pub(super) fn axes(text: Text<'_>, word: &Word<'_>, example: &str) -> Result<(Vec<usize>, Range<usize>), LabError> {
    let name = word.name;
    let Some(first) = word.arguments.as_ref().and_then(|arguments| arguments.first()) else {
        return Err(text.error(&word.at, format!("`{name}` does not say over which axes it goes; write `{example}`")));
    };
    let Value::Name(letters) = first.value else {
        return Err(text.error(&first.at, format!("the axes of `{name}` come first; write `{example}`")));
    };
    let mut axes = Vec::new();
    for letter in letters.chars() {
        let Some(axis) = AXES.iter().position(|&known| known == letter) else {
            return Err(text.error(
                &first.at,
                format!("there is no axis `{letter}`; axes are `i`, `j`, `k` and `l`, as in `{example}`"),
            ));
        };
        if axes.contains(&axis) {
            return Err(text.error(
                &first.at,
                format!(
                    "axis `{letter}` stands twice in one node; split it over two: `dense({letter}).dense({letter}, 8)`"
                ),
            ));
        }
        axes.push(axis);
    }
    Ok((axes, first.at.clone()))
}

fn node(text: Text<'_>, word: &Word<'_>, kind: NodeKind, outermost: bool) -> Result<Node, LabError> {
    let name = word.name;
    let example = if kind == NodeKind::Hash { "hash(ij)".into() } else { format!("{name}(ij, 8)") };
    let (axes, at) = axes(text, word, &example)?;
    let letters = &text.text[at];
    let arguments = word.arguments.as_deref().unwrap_or_default();
    if let Some(surplus) = arguments.get(if kind == NodeKind::Hash { 1 } else { 2 }) {
        let message = match kind {
            NodeKind::Hash => format!("`hash` takes no size; write `hash({letters}).dense({letters}, 8)`"),
            _ => format!("`{name}` takes axes and a size; sizes that differ are a tuple: `{name}(ij, (4, 2))`"),
        };
        return Err(text.error(&surplus.at, message));
    }
    if kind == NodeKind::Hash && !outermost {
        return Err(text.error(
            &word.at,
            format!(
                "`hash` stands below another node, and it is the outermost one; write `pointer({letters}, 8)` here"
            ),
        ));
    }
    let sizes = match arguments.get(1) {
        Some(argument) => Some(sizes(text, name, kind, &axes, letters, argument)?),
        None if kind == NodeKind::Morton || !outermost => {
            return Err(text.error(&word.at, format!("`{name}` needs a size here; write `{name}({letters}, 8)`")));
        }
        None => None,
    };
    Ok(Node { kind, axes, sizes })
}

fn sizes(
    text: Text<'_>,
    name: &str,
    kind: NodeKind,
    axes: &[usize],
    letters: &str,
    argument: &Argument<'_>,
) -> Result<Vec<usize>, LabError> {
    let each = match &argument.value {
        Value::Tuple(each) => each.as_slice(),
        _ => std::slice::from_ref(argument),
    };
    if each.len() != axes.len() && matches!(argument.value, Value::Tuple(_)) {
        let message = format!(
            "there are {} sizes for {} axes; write one for all, `{name}({letters}, 8)`, or one an axis",
            each.len(),
            axes.len()
        );
        return Err(text.error(&argument.at, message));
    }
    let mut sizes = Vec::new();
    for argument in each {
        sizes.push(match argument.value {
            Value::Number(0) => {
                return Err(text.error(&argument.at, "a block of size 0 has no cells; write a size from 1 on"));
            }
            Value::Number(TOO_MANY..) => {
                return Err(text.error(
                    &argument.at,
                    "the block is too large, since indices are `i32`; the outermost node needs no size",
                ));
            }
            Value::Number(size) if kind == NodeKind::Morton && !size.is_power_of_two() => {
                let above = size.next_power_of_two();
                let message =
                    format!("the sizes of `morton` are powers of two; write {} or {above}, or `dense`", above / 2);
                return Err(text.error(&argument.at, message));
            }
            Value::Number(size) => size as usize,
            Value::Name(more) if more.chars().all(|letter| AXES.contains(&letter)) => {
                return Err(text
                    .error(&argument.at, format!("the axes of a node are one word; write `{name}({letters}{more})`")));
            }
            _ => {
                return Err(
                    text.error(&argument.at, format!("the size of a block is a number; write `{name}({letters}, 8)`"))
                );
            }
        });
    }
    Ok(if sizes.len() == axes.len() { sizes } else { vec![sizes[0]; axes.len()] })
}
