//! The rules of nodes and places, each error with what to write instead.

use std::ops::Range;

use super::layout::{Chain, Layout, List, Node, NodeKind, Place, Placed, unknown};
use super::scan::Text;
use super::syntax::{Argument, Value, Word};
use crate::lab::errors::LabError;

/// The letters of the axes.
pub(super) const AXES: [char; 4] = ['i', 'j', 'k', 'l'];

/// Every word that can stand in a chain.
pub(super) const WORDS: [&str; 11] =
    ["dense", "pointer", "bitmasked", "hash", "dynamic", "morton", "aos", "soa", "split", "place", "pad"];

/// Indices are `i32`, so this many cells along an axis are too many.
const TOO_MANY: u128 = 1 << 31;
/// The most nodes with a size.
const MOST_NODES: usize = 6;
/// The most branches.
const MOST_BRANCHES: usize = 4;
/// The most bytes that starts are aligned to.
const WIDEST_PAD: u128 = 4096;

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
fn axes(text: Text<'_>, word: &Word<'_>, example: &str) -> Result<(Vec<usize>, Range<usize>), LabError> {
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

fn list(text: Text<'_>, word: &Word<'_>, chain: &Chain) -> Result<List, LabError> {
    let (axes, at) = axes(text, word, "dynamic(j, 64)")?;
    let [axis] = axes[..] else {
        return Err(text.error(&at, "a list grows along one axis; write `dynamic(j, 64)`"));
    };
    let letter = AXES[axis];
    if chain.nodes.iter().any(|node| node.axes.contains(&axis)) {
        return Err(text.error(
            &at,
            format!(
                "axis `{letter}` is the list's own, and another node names it, too; give the list an axis of its own"
            ),
        ));
    }
    let (mut most, mut chunk) = (None, None);
    let right = format!("write `dynamic({letter}, 1024)` or `dynamic({letter}, 1024, chunk = 32)`");
    for argument in word.arguments.iter().flatten().skip(1) {
        let (slot, value) = match &argument.value {
            Value::Named("chunk", value) => (&mut chunk, &**value),
            _ if most.is_none() && chunk.is_none() => (&mut most, argument),
            _ => {
                return Err(text.error(
                    &argument.at,
                    format!("`dynamic` takes an axis, a maximum and perhaps `chunk = ..`; {right}"),
                ));
            }
        };
        match value.value {
            Value::Number(number @ 1..TOO_MANY) => *slot = Some((number as usize, argument.at.clone())),
            _ => {
                return Err(text.error(&argument.at, format!("a list has from 1 to {} entries; {right}", TOO_MANY - 1)));
            }
        }
    }
    let Some((most, _)) = most else {
        return Err(
            text.error(&word.at, format!("`dynamic` does not say how many entries a list has at most; {right}"))
        );
    };
    match chunk {
        Some((chunk, at)) if chunk > most => Err(text.error(
            &at,
            format!("chunks of {chunk} entries are larger than the list, which has {most} at most; leave `chunk` out"),
        )),
        chunk => Ok(List { axis, most, chunk: chunk.map_or(most, |(chunk, _)| chunk) }),
    }
}

fn pad(text: Text<'_>, word: &Word<'_>, chain: &Chain) -> Result<usize, LabError> {
    let right = "write a power of two up to 4096, a cache line say: `.pad(64)`";
    if chain.pad.is_some() {
        return Err(text.error(&word.at, "`pad` stands twice; leave one out"));
    }
    match word.arguments.as_deref() {
        Some([Argument { value: Value::Number(bytes), .. }]) if bytes.is_power_of_two() && *bytes <= WIDEST_PAD => {
            Ok(*bytes as usize)
        }
        Some([first, ..]) => Err(text.error(&first.at, format!("starts cannot be aligned to this; {right}"))),
        _ => Err(text.error(&word.at, format!("`pad` does not say to how many bytes; {right}"))),
    }
}

fn groups(text: Text<'_>, word: &Word<'_>) -> Result<Vec<Vec<Placed>>, LabError> {
    let arguments = word.arguments.as_deref().unwrap_or_default();
    if arguments.is_empty() {
        return Err(text
            .error(&word.at, "`place` has no groups of members; write `.place([v, m])`, or `.aos` for all together"));
    }
    arguments.iter().map(|argument| group(text, argument)).collect()
}

fn group(text: Text<'_>, argument: &Argument<'_>) -> Result<Vec<Placed>, LabError> {
    let right = "a group is a list of members in brackets: `[v, split(c)]`";
    let Value::List(entries) = &argument.value else {
        return Err(text.error(&argument.at, format!("this is no group; {right}")));
    };
    if entries.is_empty() {
        return Err(text.error(&argument.at, "the group has no members; name one in it, or leave the group out"));
    }
    let placed = |entry: &Argument<'_>| match &entry.value {
        Value::Name(name) => Ok(Placed { name: (*name).into(), split: false, at: entry.at.clone() }),
        Value::Call("split", inner) => match inner.as_slice() {
            [Argument { value: Value::Name(name), at }] => {
                Ok(Placed { name: (*name).into(), split: true, at: at.clone() })
            }
            _ => Err(text.error(&entry.at, format!("`split` takes one member; {right}"))),
        },
        _ => Err(text.error(&entry.at, format!("this is no member; {right}"))),
    };
    entries.iter().map(placed).collect()
}

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
        for axis in 0..layout.rank {
            if span(chain, axis) >= TOO_MANY {
                return Err(text.error(&chain.at, format!("the blocks along axis `{}` are too large together, since indices are `i32`; write smaller ones", AXES[axis])));
            }
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
