//! What the user meant: the kernel with its fields, loops and accesses, spans kept.
//!
//! The body stays Rust's syntax tree; whatever belongs to the language in it is replaced by a placeholder that names a
//! [`Node`]. Back-ends read this model and nothing else.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Block, Expr, Ident, ItemFn, Label, Member, Type};

use super::text::text;

/// The name of the placeholder macro; no user can write it by chance.
const PLACEHOLDER: &str = "__allotrope_node";

/// A kernel.
pub(crate) struct Kernel {
    /// The function, its body with placeholders.
    pub(crate) function: ItemFn,
    /// What stands in `#[kernel(..)]` and is no option.
    pub(crate) unknown_options: Vec<TokenStream>,
    /// Whether a product that is added to something may be rounded with it.
    pub(crate) contract: bool,
    /// How many elements go through a body with inner loops together.
    pub(crate) lanes: Option<Width>,
    /// Whether callers promise that indices lie within their fields.
    pub(crate) unchecked: bool,
    /// The parameters that are fields.
    pub(crate) fields: Vec<FieldParam>,
    /// What the placeholders stand for.
    pub(crate) nodes: Vec<Node>,
    /// The parallel loops.
    pub(crate) loops: Vec<Loop>,
    /// Every name that the body binds, outside nested items.
    pub(crate) bound: Vec<Ident>,
    /// Those that some pattern binds as `mut`.
    pub(crate) mutable: BTreeSet<String>,
    /// What the rules must judge and the tree cannot show.
    pub(crate) findings: Vec<Finding>,
    /// Fields whose lists are used.
    pub(crate) listed: BTreeSet<usize>,
    /// Fields that are used as a whole at the top level: what happens to them there is not known.
    pub(crate) handed_on: BTreeSet<usize>,
    /// What may be a mistake, though it compiles.
    pub(crate) suspicions: Vec<Suspicion>,
}

/// What may be a mistake, though it compiles.
pub(crate) enum Suspicion {
    /// `left % right`, whose left side may be below zero.
    Remainder { left: Spot, whole: Spot },
    /// `unroll!` with so many bodies in all, and so many of what is unrolled around it.
    Unrolled { around: u64, bodies: u64, at: Spot },
    /// `random(seed, key)` in a parallel loop.
    Random { parallel: usize, arguments: Spot, call: Spot },
}

/// `lanes = 16`.
pub(crate) struct Width {
    /// The number, where it is one.
    pub(crate) lanes: Option<usize>,
    pub(crate) spot: Spot,
}

/// A parameter that is a field, or used as one.
pub(crate) struct FieldParam {
    pub(crate) name: Ident,
    pub(crate) storage: Storage,
    /// `&mut Field` or `&Field`.
    pub(crate) mutable: bool,
    /// The number of axes, where the type tells.
    pub(crate) rank: Option<usize>,
    /// The type as written.
    pub(crate) ty: Type,
}

/// What holds the elements of a parameter that is indexed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Storage {
    /// `Field<R, L, X>`.
    Field,
    /// `Member<T, L, X>`: one member of any record.
    Member,
    /// `[T]`.
    Slice,
    /// What bears `#[field]` under another name.
    Alias,
}

impl Storage {
    /// Whether its type alone says what an index names, so that the expansion must ask it.
    pub(crate) fn is_opaque(self) -> bool {
        matches!(self, Storage::Member | Storage::Alias)
    }

    /// Whether its elements have no members that could be named.
    pub(crate) fn is_single(self) -> bool {
        matches!(self, Storage::Member | Storage::Slice)
    }
}

/// The user's tokens for a message.
#[derive(Clone)]
pub(crate) struct Spot {
    pub(crate) tokens: TokenStream,
}

impl Spot {
    pub(crate) fn new(tokens: &impl ToTokens) -> Self {
        Self { tokens: tokens.to_token_stream() }
    }

    /// The source line it starts in.
    pub(crate) fn line(&self) -> usize {
        self.tokens.span().start().line
    }

    /// The tokens as one would write them.
    pub(crate) fn text(&self) -> String {
        text(&self.tokens)
    }
}

/// A part of the body that belongs to the language.
pub(crate) enum Node {
    Access(Box<Access>),
    /// A parallel loop, by its place in [`Kernel::loops`].
    Launch(usize),
    /// The head of a serial loop over a field or an `ndrange!`.
    Indices(Indices),
    Unroll(Unroll),
    Macro(MacroCall),
    /// `f.len()` and its like inside a parallel loop.
    FieldCall(FieldCall),
    /// `f.get_unchecked(index)` or `f.set_unchecked(index, value)`.
    Unchecked(Box<UncheckedAccess>),
    /// `f.append(index, record)` and its like: in a parallel loop, by its place in [`Loop::topology`], or outside.
    Topology(Box<Topology>),
    /// An accumulation into a variable of the top level.
    Reduce(Reduce),
    /// A `break` or `continue` of a parallel or unrolled loop.
    Jump(Jump),
}

/// One element read or written: `field.path[index]`.
pub(crate) struct Access {
    pub(crate) field: usize,
    /// The member, outermost record first; empty for the whole record.
    pub(crate) path: Vec<Ident>,
    /// The index as an expression with placeholders.
    pub(crate) index: Expr,
    /// Where the index lies as seen from the parallel loop around it.
    pub(crate) place: Place,
    /// What is done there.
    pub(crate) action: Action,
    /// The index as multiples of the loop's variables, where it is that and every iteration comes by.
    pub(crate) linear: Option<Vec<Linear>>,
    /// What a read means where the index lies outside of the field.
    pub(crate) boundary: Boundary,
    /// The parallel loop around it.
    pub(crate) parallel: Option<usize>,
    /// The whole expression: for a write with its right side.
    pub(crate) spot: Spot,
    /// `field.path[index]` alone.
    pub(crate) target: Spot,
}

/// One place of an index: `factor * variable + offset`, and a name that is added or subtracted.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Linear {
    /// The loop variable, and what it is multiplied by.
    pub(crate) variable: Option<(usize, i32)>,
    pub(crate) offset: i32,
    pub(crate) name: Option<Added>,
}

/// A name that is added in a place of an index.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Added {
    pub(crate) name: Ident,
    pub(crate) subtracted: bool,
    /// The half-open range of an unrolled loop's variable; none for a variable from outside of the parallel loop.
    pub(crate) range: Option<(i32, i32)>,
}

/// What a read at an index outside of the field means.
pub(crate) enum Boundary {
    /// A panic: `f[index]`.
    Checked,
    /// The nearest element: `f.clamped(index)`.
    Clamped,
    /// The element at the other side, as if the field were repeated: `f.wrapped(index)`.
    Wrapped,
    /// A value: `f.or(index, value)`.
    Or(Box<Expr>),
    /// The function that the member is handed to has the index, and the rule.
    Lent,
}

/// Where an index lies as seen from an iteration.
#[derive(Clone)]
pub(crate) enum Place {
    /// The iteration's own index.
    Own,
    /// The own index plus constants, one for each axis.
    Offset(Vec<i32>),
    /// Every loop variable stands alone in some place, in another order or beside others.
    Places(Vec<Slot>),
    /// Anything else.
    Computed,
}

/// What stands in one place of an index.
#[derive(Clone, Copy)]
pub(crate) enum Slot {
    /// The loop variable of that number, alone.
    Variable(usize),
    /// Anything else: the part of the index in that place.
    Free,
}

/// What an access does.
pub(crate) enum Action {
    Read,
    /// `= value`, to the part that the projections name.
    Write {
        part: Vec<Projection>,
        value: Expr,
    },
    /// `op= value`.
    Update {
        part: Vec<Projection>,
        op: Op,
        value: Expr,
    },
    /// `.fetch_add(value)` and its like: changes the element and returns what was there, in one step.
    Exchange {
        method: Ident,
        arguments: Vec<Expr>,
    },
}

/// A call that asks which elements of a field are active, or changes it.
#[derive(Clone)]
pub(crate) struct Topology {
    pub(crate) field: usize,
    /// The member of the branch that is meant; empty for the whole field.
    pub(crate) path: Vec<Ident>,
    pub(crate) call: Call,
    pub(crate) method: Ident,
    pub(crate) arguments: Vec<Expr>,
    /// Where the first argument lies as seen from the parallel loop around.
    pub(crate) place: Place,
    /// The whole call.
    pub(crate) spot: Spot,
}

/// What a call does to the activity of a field, or asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Call {
    /// `append` and `try_append`: puts a record behind the last of a list.
    Append,
    /// `remove`: takes an entry out of its list, when the loop ends.
    Remove,
    /// `activate`.
    Activate,
    /// `deactivate`: when the loop ends.
    Deactivate,
    /// `is_active`.
    IsActive,
    /// `len(index)` and `row_len(index)`: the number of a list's entries.
    RowLen,
    /// `for q in f.row(index)`.
    Row,
    /// `for q in f` in a parallel loop: all active elements.
    All,
}

impl Call {
    /// Whether it changes the field.
    pub(crate) fn changes(self) -> bool {
        matches!(self, Self::Append | Self::Remove | Self::Activate | Self::Deactivate)
    }

    /// Whether elements become active while the loop runs.
    pub(crate) fn activates(self) -> bool {
        matches!(self, Self::Append | Self::Activate)
    }

    /// Whether what happens waits for the end of the loop.
    pub(crate) fn is_deferred(self) -> bool {
        matches!(self, Self::Remove | Self::Deactivate)
    }

    /// Whether it is of the lists of a layout.
    pub(crate) fn is_of_lists(self) -> bool {
        matches!(self, Self::Append | Self::Remove | Self::RowLen | Self::Row)
    }
}

/// One step from an element to a part of it.
pub(crate) enum Projection {
    Member(Member),
    Index(Box<Expr>),
}

/// The operator of a compound assignment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Op {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Min,
    Max,
}

/// Operators that may be mixed in one accumulation, since their order does not matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    Sum,
    Product,
    Min,
    Max,
    And,
    Or,
    Xor,
}

impl Op {
    /// The group it accumulates in; division, remainder and shifts accumulate nothing.
    pub(crate) fn group(self) -> Option<Group> {
        Some(match self {
            Op::Add | Op::Sub => Group::Sum,
            Op::Mul => Group::Product,
            Op::Min => Group::Min,
            Op::Max => Group::Max,
            Op::And => Group::And,
            Op::Or => Group::Or,
            Op::Xor => Group::Xor,
            Op::Div | Op::Rem | Op::Shl | Op::Shr => return None,
        })
    }

    /// As users write it.
    pub(crate) fn text(self) -> &'static str {
        match self {
            Op::Add => "+=",
            Op::Sub => "-=",
            Op::Mul => "*=",
            Op::Div => "/=",
            Op::Rem => "%=",
            Op::And => "&=",
            Op::Or => "|=",
            Op::Xor => "^=",
            Op::Shl => "<<=",
            Op::Shr => ">>=",
            Op::Min => "min_assign",
            Op::Max => "max_assign",
        }
    }
}

/// A parallel loop.
pub(crate) struct Loop {
    pub(crate) head: Head,
    /// The loop variables; `None` for `_`.
    pub(crate) variables: Vec<Option<Ident>>,
    /// Whether they were written as a tuple.
    pub(crate) tuple: bool,
    /// The number of axes, where it is known.
    pub(crate) rank: Option<usize>,
    /// The schedule from `#[scatter(..)]`.
    pub(crate) scatter: Option<Ident>,
    /// Where an iteration accumulates, from `#[scatter(Colored, key = ..)]`.
    pub(crate) key: Option<Expr>,
    /// How far from there along every axis, from `#[scatter(Colored, reach = ..)]`.
    pub(crate) reach: Option<i32>,
    /// Whether iterations may meet in elements: `#[relaxed]`.
    pub(crate) relaxed: bool,
    /// Attributes that are Rust's.
    pub(crate) attributes: Vec<syn::Attribute>,
    pub(crate) body: Block,
    /// `for .. in ..`, for messages.
    pub(crate) spot: Spot,
    pub(crate) accesses: Vec<usize>,
    /// What it asks of fields' activity and does to it.
    pub(crate) topology: Vec<Topology>,
    pub(crate) reductions: Vec<Reduction>,
    /// Variables from outside that the body reads, each once, and where.
    pub(crate) captures: Vec<Capture>,
    /// Names bound in the body.
    pub(crate) bound: Vec<Ident>,
    /// Names that a macro which the kernel does not know, or a format string, mentions.
    pub(crate) hidden: BTreeSet<String>,
    /// Macros that the kernel does not know.
    pub(crate) macros: Vec<OpaqueMacro>,
    /// The heads of inner `for` loops.
    pub(crate) inner: Vec<InnerLoop>,
    /// Whether there is any inner loop.
    pub(crate) loops: bool,
    /// Whether anything jumps, so that iterations may pass by accesses.
    pub(crate) jumps: bool,
    /// Whether a `continue` of this loop occurs.
    pub(crate) continues: bool,
    /// Fields used only through `len`, `shape`, `origin` or an inner loop's head.
    pub(crate) shapes: BTreeSet<usize>,
    /// Fields accessed without a check, and whether they are written so.
    pub(crate) unchecked: BTreeMap<usize, bool>,
}

/// A loop inside a parallel loop.
pub(crate) struct InnerLoop {
    pub(crate) spot: Spot,
}

/// What a loop runs over.
pub(crate) enum Head {
    /// `for p in f`, or `for p in f.m` for the branch of a member.
    Field(Branch),
    /// `for p in f.interior(width)`.
    Interior { branch: Branch, width: Box<Expr> },
    /// Those elements of a head over a field that a sieve lets through.
    Sifted { base: Box<Head>, sieve: Sieve },
    /// `for q in f.row(index)`, in a serial loop.
    Row { field: usize, index: Box<Expr> },
    /// `for i in a..b`, or several ranges in `ndrange!`.
    Ranges(Vec<(Expr, Expr)>),
    /// None of these: a finding tells why.
    Invalid,
}

impl Head {
    /// The field that the loop runs over.
    pub(crate) fn field(&self) -> Option<usize> {
        match self {
            Head::Field(branch) | Head::Interior { branch, .. } => Some(branch.field),
            Head::Sifted { base, .. } => base.field(),
            Head::Row { .. } | Head::Ranges(_) | Head::Invalid => None,
        }
    }

    /// The member that names the branch that the loop runs over.
    pub(crate) fn branch(&self) -> Option<&[Ident]> {
        match self {
            Head::Field(branch) | Head::Interior { branch, .. } => Some(&branch.path),
            Head::Sifted { base, .. } => base.branch(),
            Head::Row { .. } | Head::Ranges(_) | Head::Invalid => None,
        }
    }

    /// Whether all of its elements are of one colour of a checkerboard.
    pub(crate) fn is_checkerboard(&self) -> bool {
        match self {
            Head::Sifted { base, sieve } => matches!(sieve, Sieve::Checkerboard(_)) || base.is_checkerboard(),
            Head::Field(_) | Head::Interior { .. } | Head::Row { .. } | Head::Ranges(_) | Head::Invalid => false,
        }
    }

    /// Whether it is over some of the elements of another head.
    pub(crate) fn is_sifted(&self) -> bool {
        matches!(self, Head::Sifted { .. })
    }

    /// The border that it leaves out.
    pub(crate) fn left_out(&self) -> Option<&Expr> {
        match self {
            Head::Interior { width, .. } => Some(width),
            Head::Sifted { base, .. } => base.left_out(),
            Head::Field(_) | Head::Row { .. } | Head::Ranges(_) | Head::Invalid => None,
        }
    }
}

/// A field, and a member of the branch of its layout whose elements are visited.
pub(crate) struct Branch {
    pub(crate) field: usize,
    pub(crate) path: Vec<Ident>,
}

/// Which elements of a head are visited.
pub(crate) enum Sieve {
    /// `f.border(width)`.
    Border(Box<Expr>),
    /// `.checkerboard(colour)`.
    Checkerboard(Box<Expr>),
    /// `.colored(modulus, colour)`.
    Colored(Box<Expr>, Box<Expr>),
}

/// A variable of the top level that a loop accumulates into.
pub(crate) struct Reduction {
    pub(crate) name: Ident,
    /// The part of a tuple that stands for itself, `t.0`: parts of a tuple may have different operators.
    pub(crate) place: Vec<Member>,
    /// Whether a component or an entry is accumulated into: then jobs keep a whole value, instead of lanes.
    pub(crate) by_parts: bool,
    pub(crate) group: Group,
    /// The first operator, for messages.
    pub(crate) first: (Op, Spot),
}

/// A variable from outside that a loop reads.
pub(crate) struct Capture {
    pub(crate) name: Ident,
    /// A parameter of type `&T`, or `&self`.
    pub(crate) reference: bool,
}

/// A macro call that is left as it is.
pub(crate) struct OpaqueMacro {
    pub(crate) name: String,
    pub(crate) spot: Spot,
    /// The names in its tokens.
    pub(crate) mentions: Vec<Ident>,
    /// `macro_rules!`.
    pub(crate) definition: bool,
}

/// The head of a serial loop.
pub(crate) struct Indices {
    pub(crate) head: Head,
    pub(crate) tuple: bool,
    pub(crate) parallel: Option<usize>,
}

/// A loop unrolled at compile time.
pub(crate) struct Unroll {
    pub(crate) label: Option<Label>,
    /// The variables; `None` for `_`.
    pub(crate) variables: Vec<Option<Ident>>,
    /// One half-open range for each variable.
    pub(crate) ranges: Vec<(i32, i32)>,
    /// The type over all of whose axes the one range runs: `unroll!(X, 0..3)`.
    pub(crate) axes: Option<syn::Path>,
    pub(crate) body: Block,
    pub(crate) breaks: bool,
    pub(crate) continues: bool,
    /// The accesses inside, inner loops included.
    pub(crate) accesses: Vec<usize>,
    /// Constant offsets that the body binds to a name: `let offset = ivec2(i, j)`.
    pub(crate) offsets: Vec<(Ident, Expr)>,
    /// Names bound in the body.
    pub(crate) bound: Vec<Ident>,
}

/// A call of a macro of the standard library whose arguments are expressions.
pub(crate) struct MacroCall {
    pub(crate) call: syn::Macro,
    pub(crate) arguments: MacroArguments,
}

/// The arguments of a known macro.
pub(crate) enum MacroArguments {
    /// `a, b, name = c`.
    List(Vec<Expr>),
    /// `vec![value; count]`.
    Repeat(Box<Expr>, Box<Expr>),
    /// `matches!(value, pattern if guard)`.
    Matches { value: Box<Expr>, pattern: Box<syn::Pat>, guard: Option<Box<Expr>> },
}

/// An access that is neither checked nor judged: its `unsafe` block answers for it.
pub(crate) struct UncheckedAccess {
    pub(crate) field: usize,
    pub(crate) path: Vec<Ident>,
    pub(crate) index: Expr,
    /// What is written.
    pub(crate) value: Option<Expr>,
    /// The whole call.
    pub(crate) spot: Spot,
}

/// A call of a field's method inside a parallel loop.
pub(crate) struct FieldCall {
    pub(crate) field: usize,
    pub(crate) method: Ident,
}

/// `variable op= value`, or to a part of the variable.
pub(crate) struct Reduce {
    pub(crate) variable: Ident,
    /// The reduction, by its place in [`Loop::reductions`].
    pub(crate) reduction: usize,
    pub(crate) part: Vec<Projection>,
    pub(crate) op: Op,
    pub(crate) value: Expr,
}

/// A `break` or `continue` whose loop the expansion rewrites.
pub(crate) enum Jump {
    /// `continue` of the parallel loop.
    Element,
    /// `continue` of the unrolled loop behind this node.
    Step(usize),
    /// `break` of the unrolled loop behind this node.
    Leave(usize),
}

/// What the rules must judge and the tree cannot show.
pub(crate) struct Finding {
    pub(crate) what: What,
    pub(crate) spot: Spot,
}

/// Kinds of findings.
pub(crate) enum What {
    /// The head of a parallel loop is not in the list; what it is built upon.
    Head { upon: Upon },
    /// `a..=b` in a head that needs a half-open range.
    InclusiveRange { start: String, end: String },
    /// `a..` or `..b`.
    OpenRange,
    /// `for q in f.row(index)` as an outermost loop.
    RowHead,
    /// A call of lists or of activity with more or fewer arguments than it takes.
    TopologyArguments { field: String, name: String, takes: &'static str, example: &'static str },
    /// `f.m.append(..)`: a list's entries are whole records.
    MemberAppend { field: usize, name: String },
    /// `for p in f.m`.
    MemberHead,
    /// `unroll!` as the head of an outermost loop.
    OutermostUnroll,
    /// A pattern of a parallel loop that is no name or tuple of names.
    Pattern,
    /// `#[relaxed]` on a loop that is not parallel.
    RelaxedPlace,
    /// `#[scatter(..)]` with something else inside.
    ScatterName { found: String },
    /// `#[scatter(name, ..)]` with something else than `key = ..` and `reach = ..` behind `Colored`.
    ScatterOption { schedule: String },
    /// `reach = ..` that is no literal.
    ScatterReach,
    /// `key = ..` that does more than to read.
    ScatterKey,
    /// `#[scatter(..)]` on a loop that is not parallel.
    ScatterPlace,
    /// `break`, `return`, `?` or `.await` out of a parallel loop.
    Escape { how: &'static str },
    /// A bound of `unroll!` that is no integer literal.
    UnrollBound,
    /// `unroll!` whose pattern does not fit its ranges.
    UnrollPattern { ranges: usize },
    /// `break` and its like out of `unroll!(X, 0..3)`.
    UnrollEscape { how: &'static str },
    /// Arguments that are no ranges.
    HeadArguments { name: String },
    /// `unroll!` or `ndrange!` elsewhere than in a head.
    HeadMacro { name: String },
    /// A bare member, such as `f.m` without an index.
    BareMember { field: usize, in_loop: bool },
    /// A bare field inside a parallel loop.
    BareField { field: usize },
    /// A field or member bound by `let`.
    Alias,
    /// A field or member borrowed for a function inside a parallel loop.
    Argument { function: String },
    /// A method of a field inside a parallel loop.
    FieldMethod { field: usize, name: String },
    /// `f.clamped`, `f.wrapped` or `f.or` with more or fewer arguments than it takes.
    BoundaryArguments { field: String, name: String },
    /// `fetch_add` and its like of a component, or with more or fewer arguments than it takes.
    Exchange { name: String, takes: usize, part: bool },
    /// The value of an assignment to an element.
    AssignmentValue { text: String, accumulates: bool },
    /// A destructuring assignment to elements.
    Destructuring,
    /// A variable from outside assigned in a parallel loop.
    OuterAssigned { name: String, how: Assigned },
    /// A reduction read in its loop.
    ReductionRead { name: String },
    /// A tuple accumulated into as a whole and by parts.
    ReductionParts { name: String, line: usize },
    /// A reduction with two groups.
    ReductionGroups { name: String, op: Op, first: Op, line: usize },
    /// A `move` closure that holds an access.
    MoveClosure,
}

/// What a head that is not in the list is built upon.
pub(crate) enum Upon {
    /// A range: `(0..n).rev()`.
    Range,
    /// A part of a field, with other arguments than it takes or in another order: `u.interior()`.
    Part,
    /// A field: `&u`, `u.iter()`.
    Field(String),
    /// A name that is no field's.
    Name,
    /// Something else.
    Other,
}

/// How a variable from outside is assigned.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Assigned {
    /// `x = ..`, or a part of it.
    Plain,
    /// `x /= ..` and its like.
    Operator(Op),
    /// Through a reference.
    Reference,
}

impl Kernel {
    /// All accesses.
    pub(crate) fn accesses(&self) -> impl Iterator<Item = &Access> {
        self.nodes.iter().filter_map(|node| match node {
            Node::Access(access) => Some(&**access),
            _ => None,
        })
    }

    /// The access behind a node.
    pub(crate) fn access(&self, node: usize) -> &Access {
        match &self.nodes[node] {
            Node::Access(access) => access,
            _ => unreachable!("node {node} is an access"),
        }
    }
}

/// The expression that stands for a node.
pub(crate) fn placeholder(node: usize, span: Span) -> Expr {
    let name = Ident::new(PLACEHOLDER, span);
    let number = Literal::usize_unsuffixed(node);
    syn::parse_quote!(#name!(#number))
}

/// The tokens with another name where a user wrote that of the placeholder, which would be taken for one.
pub(crate) fn without_placeholders(tokens: TokenStream) -> TokenStream {
    fn mentioned(tokens: TokenStream) -> bool {
        tokens.into_iter().any(|token| match token {
            TokenTree::Ident(name) => name == PLACEHOLDER,
            TokenTree::Group(group) => mentioned(group.stream()),
            TokenTree::Punct(_) | TokenTree::Literal(_) => false,
        })
    }
    fn renamed(token: TokenTree) -> TokenTree {
        match token {
            TokenTree::Ident(name) if name == PLACEHOLDER => Ident::new("__no_allotrope_node", name.span()).into(),
            TokenTree::Group(group) => {
                let mut inner =
                    proc_macro2::Group::new(group.delimiter(), group.stream().into_iter().map(renamed).collect());
                inner.set_span(group.span());
                inner.into()
            }
            other => other,
        }
    }
    if mentioned(tokens.clone()) { tokens.into_iter().map(renamed).collect() } else { tokens }
}

/// The node that an expression stands for.
pub(crate) fn node_of(expr: &Expr) -> Option<usize> {
    match expr {
        Expr::Macro(call) if call.mac.path.is_ident(PLACEHOLDER) => call.mac.tokens.to_string().parse().ok(),
        _ => None,
    }
}

impl ToTokens for Projection {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(match self {
            Projection::Member(member) => quote!(.#member),
            Projection::Index(index) => quote!([#index]),
        });
    }
}
