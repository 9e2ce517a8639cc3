//! What the user meant: nodes over axes, and a place, with their spans.

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::ext::IdentExt;
use syn::{Expr, ExprLit, Ident, Lit, LitInt, Path, Token};

use super::parse::{Syntax, Word, name};

/// A layout as written, which need not be a right one yet.
pub(super) struct Layout {
    /// The record whose members it names.
    pub(super) record: Option<Path>,
    /// Chains of nodes from the root down; more than one where `+` puts members under different nodes.
    pub(super) branches: Vec<Branch>,
}

impl Layout {
    /// Whether it places members by their names.
    pub(super) fn names_members(&self) -> bool {
        let mut steps = self.branches.iter().flat_map(|branch| &branch.steps);
        steps.any(|step| matches!(step, Step::Place(Place { kind: PlaceKind::Groups(_), .. })))
    }
}

/// One chain.
pub(super) struct Branch {
    /// The `+` before it.
    pub(super) plus: Option<Token![+]>,
    pub(super) steps: Vec<Step>,
}

/// One word of a chain.
pub(super) enum Step {
    Node(Node),
    Place(Place),
    Pad(Pad),
    List(Box<List>),
    /// A word that the language has not.
    Unknown(Ident),
}

impl Step {
    /// The axes that a node goes over, where they can be told.
    pub(super) fn axes(&self) -> Option<&AxisList> {
        match self {
            Self::Node(node) => node.axes.as_ref(),
            Self::List(list) => list.axes.as_ref(),
            Self::Place(_) | Self::Pad(_) | Self::Unknown(_) => None,
        }
    }

    /// The word itself.
    pub(super) fn name(&self) -> &Ident {
        match self {
            Self::Node(node) => &node.name,
            Self::Place(place) => &place.name,
            Self::Pad(pad) => &pad.name,
            Self::List(list) => &list.name,
            Self::Unknown(name) => name,
        }
    }
}

/// A node but `dynamic`.
pub(super) struct Node {
    pub(super) name: Ident,
    pub(super) kind: Kind,
    /// `None`: nothing that could be read as axes stands there.
    pub(super) axes: Option<AxisList>,
    pub(super) sizes: Option<Sizes>,
    /// The first argument too many.
    pub(super) surplus: Option<TokenStream>,
}

/// What a node does with its cells.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// They are all there.
    Dense,
    /// The same in Z-order.
    Morton,
    /// They are allocated when they are first written.
    Pointer,
    /// They are all there, with an activity bit each.
    Bitmasked,
    /// They are found by hashing.
    Hash,
}

impl Kind {
    /// Whether its cells point to what stands below.
    pub(super) fn points(self) -> bool {
        matches!(self, Self::Pointer | Self::Hash)
    }

    /// Whether its cells can be inactive.
    pub(super) fn is_sparse(self) -> bool {
        self.points() || self == Self::Bitmasked
    }
}

/// A `dynamic` node: lists of entries.
pub(super) struct List {
    pub(super) name: Ident,
    pub(super) axes: Option<AxisList>,
    /// The most entries of a list.
    pub(super) most: Option<Size>,
    /// Entries of a block, `chunk = 32`, and where that stands.
    pub(super) chunk: Option<(TokenStream, Size)>,
    /// The first argument that it does not take.
    pub(super) surplus: Option<TokenStream>,
}

/// Axes in the order in which they lie in memory, the last fastest.
pub(super) struct AxisList {
    pub(super) name: Ident,
    pub(super) axes: Vec<Axis>,
    /// The letters that are no axes.
    pub(super) unknown: Vec<char>,
}

/// An axis: 0 is `i`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Axis(pub(super) usize);

/// The letters of the axes.
pub(super) const AXES: [char; 4] = ['i', 'j', 'k', 'l'];

impl Axis {
    pub(super) fn letter(self) -> char {
        AXES[self.0]
    }
}

/// Sizes of a block.
pub(super) struct Sizes {
    pub(super) at: TokenStream,
    /// `(4, 2)`, one an axis, rather than one for all.
    pub(super) each: bool,
    pub(super) list: Vec<Size>,
}

impl Sizes {
    /// The size along the node's axis of that number.
    pub(super) fn along(&self, number: usize) -> Option<&Size> {
        self.list.get(if self.each { number } else { 0 })
    }
}

/// The size of a block along an axis.
pub(super) enum Size {
    Number(u128, LitInt),
    /// A constant's name or a constant expression.
    Constant(Expr),
    /// What cannot be a size, and the axes it seems to mean, as in `dense(i, j)`.
    Wrong(TokenStream, Option<Ident>),
}

/// `pad(64)`
pub(super) struct Pad {
    pub(super) name: Ident,
    /// The bytes, read as a size is.
    pub(super) bytes: Option<Size>,
    /// The first argument too many.
    pub(super) surplus: Option<TokenStream>,
}

/// How the innermost node's cells are placed.
pub(super) struct Place {
    pub(super) name: Ident,
    pub(super) kind: PlaceKind,
    /// Arguments were given to a place that takes none.
    pub(super) surplus: Option<TokenStream>,
}

/// The places.
pub(super) enum PlaceKind {
    Aos,
    Soa,
    Split,
    Groups(Vec<Group>),
}

/// `[v, split(c)]`
pub(super) struct Group {
    pub(super) at: TokenStream,
    pub(super) members: Vec<Placed>,
    /// Entries that are no names of members, or a group that is no list.
    pub(super) wrong: Vec<TokenStream>,
}

/// A member in a group.
pub(super) struct Placed {
    /// The member.
    pub(super) name: Ident,
    /// The members of the record that stands there, and so on: `node.v`.
    pub(super) inner: Vec<Ident>,
    /// Its components are taken apart: `split(c)`.
    pub(super) split: bool,
}

/// Every word that can stand in a chain.
pub(super) const WORDS: [&str; 11] =
    ["dense", "pointer", "bitmasked", "hash", "dynamic", "morton", "aos", "soa", "split", "place", "pad"];

/// Layouts that have names of their own, which stand in a type without `layout!`.
pub(super) const NAMED: [&str; 8] =
    ["Aos", "Soa", "Split", "AoSoA<N>", "Blocked<N>", "Morton<N>", "Sparse<N>", "SparseHash<N>"];

/// The most bytes that starts can be aligned to: a page.
pub(super) const WIDEST_PAD: u128 = 4096;

/// The most nodes of constant size that a layout may have.
pub(super) const MOST_NODES: usize = 6;

/// The most branches that a layout may have.
pub(super) const MOST_BRANCHES: usize = 4;

/// The most bytes that a placed member's name may have.
pub(super) const LONGEST_NAME: usize = 32;

/// Gives the words their meaning.
pub(super) fn model(syntax: Syntax) -> Layout {
    let branches = syntax
        .branches
        .into_iter()
        .map(|(plus, words)| Branch { plus, steps: words.into_iter().map(step).collect() })
        .collect();
    Layout { record: syntax.record, branches }
}

fn step(word: Word) -> Step {
    let kind = match word.name.to_string().as_str() {
        "dense" => return Step::Node(node(word, Kind::Dense)),
        "morton" => return Step::Node(node(word, Kind::Morton)),
        "pointer" => return Step::Node(node(word, Kind::Pointer)),
        "bitmasked" => return Step::Node(node(word, Kind::Bitmasked)),
        "hash" => return Step::Node(node(word, Kind::Hash)),
        "dynamic" => return Step::List(Box::new(list(word))),
        "pad" => return Step::Pad(pad(word)),
        "place" => {
            let groups = word.arguments.unwrap_or_default().into_iter().map(group).collect();
            return Step::Place(Place { name: word.name, kind: PlaceKind::Groups(groups), surplus: None });
        }
        "aos" => PlaceKind::Aos,
        "soa" => PlaceKind::Soa,
        "split" => PlaceKind::Split,
        _ => return Step::Unknown(word.name),
    };
    let surplus = word.arguments.map(|arguments| match &arguments[..] {
        [] => word.name.to_token_stream(),
        [first, ..] => first.to_token_stream(),
    });
    Step::Place(Place { name: word.name, kind, surplus })
}

fn node(word: Word, kind: Kind) -> Node {
    let mut arguments = word.arguments.unwrap_or_default().into_iter();
    let axes = arguments.next().and_then(|argument| name(&argument)).map(|name| axis_list(&name));
    let sizes = arguments.next().map(sizes);
    let surplus = arguments.next().map(Expr::into_token_stream);
    Node { name: word.name, kind, axes, sizes, surplus }
}

fn list(word: Word) -> List {
    let mut arguments = word.arguments.unwrap_or_default().into_iter();
    let axes = arguments.next().and_then(|argument| name(&argument)).map(|name| axis_list(&name));
    let mut list = List { name: word.name, axes, most: None, chunk: None, surplus: None };
    for argument in arguments {
        let at = argument.to_token_stream();
        match argument {
            Expr::Assign(named) if list.chunk.is_none() && name(&named.left).is_some_and(|name| name == "chunk") => {
                list.chunk = Some((at, size(*named.right)));
            }
            Expr::Assign(_) => list.surplus = list.surplus.or(Some(at)),
            argument if list.most.is_none() && list.chunk.is_none() => list.most = Some(size(argument)),
            _ => list.surplus = list.surplus.or(Some(at)),
        }
    }
    list
}

fn pad(word: Word) -> Pad {
    let mut arguments = word.arguments.unwrap_or_default().into_iter();
    let bytes = arguments.next().map(size);
    Pad { name: word.name, bytes, surplus: arguments.next().map(Expr::into_token_stream) }
}

fn axis_list(name: &Ident) -> AxisList {
    let mut list = AxisList { name: name.clone(), axes: Vec::new(), unknown: Vec::new() };
    for letter in name.to_string().chars() {
        match AXES.iter().position(|&axis| axis == letter) {
            Some(axis) => list.axes.push(Axis(axis)),
            None => list.unknown.push(letter),
        }
    }
    list
}

fn sizes(argument: Expr) -> Sizes {
    let at = argument.to_token_stream();
    match argument {
        Expr::Tuple(tuple) => Sizes { at, each: true, list: tuple.elems.into_iter().map(size).collect() },
        argument => Sizes { at, each: false, list: vec![size(argument)] },
    }
}

fn size(argument: Expr) -> Size {
    let at = argument.to_token_stream();
    match argument {
        Expr::Lit(ExprLit { lit: Lit::Int(literal), .. }) if matches!(literal.suffix(), "" | "usize") => {
            literal.base10_parse().map_or(Size::Wrong(at, None), |number| Size::Number(number, literal))
        }
        // `dense(i, j)`: constants are not named by axes' letters in small.
        Expr::Path(path) if path.path.get_ident().is_some_and(|name| axis_list(name).unknown.is_empty()) => {
            Size::Wrong(at, path.path.get_ident().cloned())
        }
        // `crate` and its like are paths that name no value.
        ref path @ Expr::Path(ref plain) if plain.path.get_ident().is_some() && name(path).is_none() => {
            Size::Wrong(at, None)
        }
        Expr::Path(_) | Expr::Binary(_) | Expr::Paren(_) | Expr::Block(_) | Expr::Call(_) | Expr::Cast(_) => {
            Size::Constant(argument)
        }
        _ => Size::Wrong(at, None),
    }
}

fn group(argument: Expr) -> Group {
    let mut group = Group { at: argument.to_token_stream(), members: Vec::new(), wrong: Vec::new() };
    let Expr::Array(list) = argument else {
        group.wrong.push(group.at.clone());
        return group;
    };
    for entry in list.elems {
        match placed(&entry) {
            Some(member) => group.members.push(member),
            None => group.wrong.push(entry.into_token_stream()),
        }
    }
    group
}

/// `v` or `split(v)`
fn placed(entry: &Expr) -> Option<Placed> {
    match entry {
        Expr::Call(call) if name(&call.func)? == "split" && call.args.len() == 1 => {
            Some(Placed { split: true, ..path(&call.args[0])? })
        }
        entry => path(entry),
    }
}

/// `node.v`
fn path(entry: &Expr) -> Option<Placed> {
    match entry {
        Expr::Field(field) => {
            let syn::Member::Named(member) = &field.member else { return None };
            let mut placed = path(&field.base)?;
            placed.inner.push(member.clone());
            Some(placed)
        }
        entry => Some(Placed { name: name(entry)?, inner: Vec::new(), split: false }),
    }
}

impl Placed {
    /// The member as it is written.
    pub(super) fn text(&self) -> String {
        let inner: String = self.inner.iter().map(|name| format!(".{}", name.unraw())).collect();
        format!("{}{inner}", self.name.unraw())
    }
}
