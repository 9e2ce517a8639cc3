//! Layouts as texts: chains of nodes over axes, closed by a place, or a layout with a name of its own.

use std::ops::Range;

use super::check;
use super::nodes::{self, AXES};
use super::scan::{Text, nearest};
use super::syntax::{self, Syntax, Word};
use crate::lab::errors::LabError;

/// A layout whose nodes are right by themselves.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Chains of nodes from the root down.
    pub(super) branches: Vec<Chain>,
    /// How many axes it goes over, that of lists with them.
    pub(super) rank: usize,
}

/// One chain.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    pub(super) nodes: Vec<Node>,
    pub(super) list: Option<List>,
    /// What cells or runs begin at a multiple of.
    pub(super) pad: Option<usize>,
    pub(super) place: Option<Place>,
    /// Its first word.
    pub(super) at: Range<usize>,
}

/// A node but `dynamic`.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) kind: NodeKind,
    /// In the order of memory, the last fastest.
    pub(super) axes: Vec<usize>,
    /// One an axis, in the same order.
    pub(super) sizes: Option<Vec<usize>>,
}

/// What a node does with its cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NodeKind {
    Dense,
    Morton,
    Pointer,
    Bitmasked,
    Hash,
}

impl NodeKind {
    /// Whether its cells point to what stands below.
    pub(super) fn points(self) -> bool {
        matches!(self, Self::Pointer | Self::Hash)
    }
}

/// A `dynamic` node.
#[derive(Clone, Copy, Debug)]
pub(super) struct List {
    pub(super) axis: usize,
    pub(super) most: usize,
    /// Entries of a block.
    pub(super) chunk: usize,
}

/// How the innermost node's cells hold records.
#[derive(Clone, Debug)]
pub(super) enum Place {
    Aos,
    Soa,
    Split,
    Groups(Vec<Vec<Placed>>),
}

/// A member in a group, or a record with all of its members.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) name: String,
    pub(super) split: bool,
    pub(super) at: Range<usize>,
}

impl Chain {
    /// Whether blocks are made when they are needed, or have activity bits.
    pub(super) fn is_sparse(&self) -> bool {
        self.list.is_some() || self.nodes.iter().any(|node| !matches!(node.kind, NodeKind::Dense | NodeKind::Morton))
    }
}

/// The layouts that have a name, what they are over some axes, and whether they have a size.
const NAMED: [(&str, &str, bool); 8] = [
    ("Aos", "dense(ALL).aos", false),
    ("Soa", "dense(ALL).soa", false),
    ("Split", "dense(ALL).split", false),
    ("AoSoA", "dense(ALL).dense(LAST, N).soa", true),
    ("Blocked", "dense(ALL).dense(ALL, N).aos", true),
    ("Morton", "dense(ALL).morton(ALL, N).aos", true),
    ("Sparse", "pointer(ALL).dense(ALL, N).aos", true),
    ("SparseHash", "hash(ALL).dense(ALL, N).aos", true),
];

/// Reads a layout. One with a name goes over as many axes as are asked for, or one.
pub(super) fn parse(text: &str, rank: Option<usize>) -> Result<Layout, LabError> {
    let text = Text { what: "layout", text };
    match syntax::parse(text)? {
        Syntax::Chains(chains) => {
            let branches = chains.iter().map(|words| chain(text, words)).collect::<Result<Vec<_>, _>>()?;
            let layout = Layout { rank: rank_of(&branches), branches };
            check::check(text, &layout)?;
            Ok(layout)
        }
        Syntax::Named { name, at, size } => {
            let written = written(text, name, &at, size, rank.unwrap_or(1))?;
            parse(&written, None).map_err(|error| text.error(&at, error.to_string()))
        }
    }
}

/// What a named layout is, written out: nothing for one that is written out.
pub(super) fn meaning(text: &str, rank: usize) -> Option<String> {
    let text = Text { what: "layout", text };
    match syntax::parse(text) {
        Ok(Syntax::Named { name, at, size }) => written(text, name, &at, size, rank).ok(),
        _ => None,
    }
}

fn written(
    text: Text<'_>,
    name: &str,
    at: &Range<usize>,
    size: Option<(u128, Range<usize>)>,
    rank: usize,
) -> Result<String, LabError> {
    let Some((_, meaning, sized)) = NAMED.iter().find(|(known, ..)| *known == name) else {
        return Err(text.error(at, unknown(name)));
    };
    let letters: String = AXES[..rank].iter().collect();
    let written = meaning.replace("ALL", &letters).replace("LAST", &AXES[rank - 1].to_string());
    match (size, sized) {
        (None, false) => Ok(written),
        (Some((size, at)), true) => {
            let power = name != "Morton" || size.is_power_of_two();
            if size == 0 || size >= 1 << 31 || !power {
                let wanted = if name == "Morton" { "a power of two" } else { "a number of cells from 1 on" };
                return Err(
                    text.error(&at, format!("a block of `{name}` has no such size; write {wanted}: `{name}<8>`"))
                );
            }
            Ok(written.replace('N', &size.to_string()))
        }
        (None, true) => Err(text.error(at, format!("`{name}` needs the size of its blocks; write `{name}<8>`"))),
        (Some((_, at)), false) => Err(text.error(&at, format!("`{name}` has no size; write `{name}`"))),
    }
}

/// What is said of a word that the language has not.
pub(super) fn unknown(name: &str) -> String {
    let named = NAMED.iter().map(|(known, ..)| *known);
    if name.starts_with(char::is_uppercase) {
        if let Some(near) =
            named.clone().find(|known| known.eq_ignore_ascii_case(name)).or_else(|| nearest(name, named))
        {
            return format!("there is no layout `{name}`; did you mean `{near}`?");
        }
        let all: Vec<String> = NAMED
            .iter()
            .map(|(name, _, sized)| if *sized { format!("`{name}<8>`") } else { format!("`{name}`") })
            .collect();
        return format!("there is no layout `{name}`; those with a name are {}", all.join(", "));
    }
    match nearest(name, nodes::WORDS) {
        Some(near) => format!("there is no node or place `{name}`; did you mean `{near}`?"),
        None => format!(
            "there is no node or place `{name}`; the nodes are `dense`, `morton`, `pointer`, `bitmasked`, `hash` and `dynamic`, \
             the places `aos`, `soa`, `split` and `place`"
        ),
    }
}

fn chain(text: Text<'_>, words: &[Word<'_>]) -> Result<Chain, LabError> {
    let mut chain = Chain { at: words[0].at.clone(), ..Chain::default() };
    for word in words {
        nodes::add(text, word, &mut chain)?;
    }
    if chain.place.is_none() {
        let last = &words[words.len() - 1].at;
        return Err(text.error(last, "the layout has no place; end it with `.aos`, `.soa`, `.split` or `.place([..])`"));
    }
    Ok(chain)
}

/// The axes that are named, counted from `i` on.
fn rank_of(branches: &[Chain]) -> usize {
    let nodes = branches.iter().flat_map(|chain| &chain.nodes).flat_map(|node| &node.axes);
    let lists = branches.iter().filter_map(|chain| chain.list.as_ref()).map(|list| &list.axis);
    nodes.chain(lists).max().map_or(0, |axis| axis + 1)
}
