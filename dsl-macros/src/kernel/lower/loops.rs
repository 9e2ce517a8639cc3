//! `for` loops: parallel, serial, unrolled.

use std::collections::{BTreeMap, BTreeSet};
use std::mem;

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{Attribute, Block, Expr, ExprAssign, ExprForLoop, Ident, Label, Meta, Pat, Stmt, Token};

use super::heads::{self, Unrolled};
use super::jumps::Target;
use super::scope::Kind;
use super::{Lower, Mode};
use crate::kernel::model::{Action, Call, Head, Indices, InnerLoop, Loop, Node, Place, Spot, Topology, Unroll, What};
use crate::kernel::syntax::{bare, integer, name_of, names, parts, plain_names};

/// The language's attributes on a loop.
#[derive(Default)]
struct Attributes {
    serial: bool,
    /// Whether its turns are taken one after another, and its body is top level.
    ordered: bool,
    scatter: Option<Ident>,
    /// `key = ..` and `reach = ..` of `#[scatter(Colored, ..)]`.
    key: Option<Expr>,
    reach: Option<i32>,
    /// `#[relaxed]`: whether iterations may meet in elements.
    relaxed: Option<Attribute>,
    /// Those that are Rust's.
    others: Vec<Attribute>,
}

impl Lower {
    pub(super) fn visit_for(&mut self, expr: &mut Expr) {
        let Expr::ForLoop(repeat) = &mut *expr else { return };
        let attributes = self.attributes(mem::take(&mut repeat.attrs));
        let unroll = match bare(&repeat.expr) {
            Expr::Macro(call) if call.mac.path.is_ident("unroll") => Some(call.mac.tokens.clone()),
            _ => None,
        };
        let parallel = self.mode == Mode::Top && !attributes.serial && !attributes.ordered;
        if !parallel && let Some(scatter) = &attributes.scatter {
            self.find(What::ScatterPlace, scatter);
        }
        if !parallel && let Some(relaxed) = &attributes.relaxed {
            self.find(What::RelaxedPlace, relaxed);
        }
        if parallel {
            self.parallel_loop(expr, attributes);
        } else if let Some(tokens) = unroll {
            self.unroll(expr, tokens);
        } else {
            repeat.attrs = attributes.others;
            self.serial_loop(repeat, attributes.ordered && !attributes.serial);
        }
    }

    fn attributes(&mut self, attributes: Vec<Attribute>) -> Attributes {
        let mut found = Attributes::default();
        for attribute in attributes {
            let name = attribute.path().get_ident().map(ToString::to_string).unwrap_or_default();
            match name.as_str() {
                "serial" => found.serial = true,
                "ordered" => found.ordered = true,
                "relaxed" => found.relaxed = Some(attribute),
                "scatter" => self.scatter(&attribute, &mut found),
                _ => found.others.push(attribute),
            }
        }
        found
    }

    fn scatter(&mut self, attribute: &Attribute, attributes: &mut Attributes) {
        let Meta::List(list) = &attribute.meta else {
            return self.find(What::ScatterName { found: String::new() }, attribute);
        };
        let parse = |input: ParseStream<'_>| Ok((input.parse::<Ident>()?, input.parse::<TokenStream>()?));
        let Ok((name, rest)) = list.parse_args_with(parse) else {
            return self.find(What::ScatterName { found: list.tokens.to_string() }, &list.tokens);
        };
        let schedule = name.to_string();
        if !["Serial", "Atomic", "Private", "Colored", "Auto"].contains(&schedule.as_str()) {
            return self.find(What::ScatterName { found: schedule }, &name);
        }
        attributes.scatter = Some(name);
        if rest.is_empty() {
            return;
        }
        let options = |input: ParseStream<'_>| {
            input.parse::<Token![,]>()?;
            Punctuated::<ExprAssign, Token![,]>::parse_terminated(input)
        };
        let Ok(options) = options.parse2(rest.clone()) else {
            return self.find(What::ScatterOption { schedule }, &rest);
        };
        for option in options {
            match name_of(&option.left).map(ToString::to_string).as_deref() {
                Some("key") if schedule == "Colored" && attributes.key.is_none() => {
                    attributes.key = Some(*option.right)
                }
                Some("reach") if schedule == "Colored" && attributes.reach.is_none() => match integer(&option.right) {
                    Some(reach) if reach >= 0 => attributes.reach = Some(reach),
                    _ => self.find(What::ScatterReach, &option.right),
                },
                _ => self.find(What::ScatterOption { schedule: schedule.clone() }, &option),
            }
        }
    }

    fn parallel_loop(&mut self, expr: &mut Expr, attributes: Attributes) {
        let Expr::ForLoop(repeat) = &mut *expr else { return };
        let spot = head_spot(repeat);
        let mut head = self.parallel_head(&mut repeat.expr);
        let (variables, tuple) = match plain_names(&repeat.pat) {
            Some(found) => found,
            None => {
                self.find(What::Pattern, &repeat.pat);
                head = Head::Invalid;
                let mut variables = Vec::new();
                names(&repeat.pat, &mut |name, _| variables.push(Some(name.clone())));
                (variables, true)
            }
        };
        let rank = match &head {
            _ if tuple => Some(variables.len()),
            Head::Ranges(ranges) => Some(ranges.len()),
            other => other.field().and_then(|field| self.kernel.fields[field].rank),
        };
        let number = self.kernel.loops.len();
        let empty = Block { brace_token: repeat.body.brace_token, stmts: Vec::new() };
        let mut body = mem::replace(&mut repeat.body, empty.clone());
        self.kernel.loops.push(Loop {
            head,
            variables: variables.clone(),
            tuple,
            rank,
            scatter: attributes.scatter,
            key: None,
            reach: attributes.reach,
            relaxed: attributes.relaxed.is_some(),
            attributes: attributes.others,
            body: empty,
            spot,
            accesses: Vec::new(),
            topology: Vec::new(),
            reductions: Vec::new(),
            captures: Vec::new(),
            bound: Vec::new(),
            hidden: BTreeSet::new(),
            macros: Vec::new(),
            inner: Vec::new(),
            loops: false,
            jumps: false,
            continues: false,
            shapes: BTreeSet::new(),
            unchecked: BTreeMap::new(),
        });
        self.mode = Mode::Parallel(number);
        let depth = mem::replace(&mut self.loop_depth, self.scopes.depth());
        let branches = mem::take(&mut self.branches);
        self.targets.push(Target::Parallel { number, label: label_name(&repeat.label) });
        self.scopes.enter();
        for variable in variables.iter().flatten() {
            self.scopes.bind(variable, Kind::Value);
        }
        if let Some(mut key) = attributes.key {
            let (spot, known) = (Spot::new(&key), self.kernel.nodes.len());
            self.visit_expr_mut(&mut key);
            let reads = |node: &Node| match node {
                Node::Access(access) => matches!(access.action, Action::Read),
                Node::FieldCall(_) | Node::Macro(_) => true,
                _ => false,
            };
            if !self.kernel.nodes[known..].iter().all(reads) {
                self.find(What::ScatterKey, &spot.tokens);
            }
            self.kernel.loops[number].key = Some(key);
        }
        self.visit_block_mut(&mut body);
        self.scopes.leave();
        self.targets.pop();
        self.loop_depth = depth;
        self.branches = branches;
        self.mode = Mode::Top;
        self.kernel.loops[number].body = body;
        self.separate_reductions(number);
        let span = repeat.for_token.span;
        *expr = self.node(Node::Launch(number), span);
    }

    /// A reduction that is read as well: the accumulating uses hold, the reads are findings.
    fn separate_reductions(&mut self, number: usize) {
        let found = &mut self.kernel.loops[number];
        let reductions: Vec<Ident> = found.reductions.iter().map(|reduction| reduction.name.clone()).collect();
        let read: Vec<Ident> = found
            .captures
            .iter()
            .filter(|capture| reductions.contains(&capture.name))
            .map(|capture| capture.name.clone())
            .collect();
        found.captures.retain(|capture| !reductions.contains(&capture.name));
        for name in read {
            self.find(What::ReductionRead { name: name.to_string() }, &name);
        }
    }

    /// A loop that takes its turns one after another; the body of an ordered one is as much top level as what is around.
    fn serial_loop(&mut self, repeat: &mut ExprForLoop, ordered: bool) {
        let mode = self.mode;
        if mode == Mode::Top && !ordered {
            self.mode = Mode::Serial;
        }
        let tuple = matches!(&*repeat.pat, Pat::Tuple(_));
        let head = match bare(&repeat.expr) {
            Expr::Macro(call) if call.mac.path.is_ident("ndrange") => {
                let tokens = call.mac.tokens.clone();
                Some(self.ndrange(tokens))
            }
            _ => self.field_head(&mut repeat.expr, false),
        };
        let spot = head_spot(repeat);
        match head {
            Some(head) => {
                let parallel = self.parallel();
                if let (Some(number), Some(field)) = (parallel, head.field()) {
                    self.kernel.loops[number].shapes.insert(field);
                    let (path, place) = (head.branch().map(<[_]>::to_vec).unwrap_or_default(), Place::Computed);
                    let method = self.kernel.fields[field].name.clone();
                    let (call, arguments, spot) = (Call::All, Vec::new(), spot.clone());
                    self.note_topology(&Topology { field, path, call, method, arguments, place, spot });
                }
                let span = heads::span(&repeat.expr);
                *repeat.expr = self.node(Node::Indices(Indices { head, tuple, parallel }), span);
            }
            None => self.visit_expr_mut(&mut repeat.expr),
        }
        self.inner_loop(repeat.label.as_ref());
        if let Some(number) = self.parallel() {
            self.kernel.loops[number].inner.push(InnerLoop { spot });
        }
        self.scopes.enter();
        self.bind_pattern(&repeat.pat);
        self.branch(|this| this.visit_block_mut(&mut repeat.body));
        self.scopes.leave();
        self.targets.pop();
        self.mode = mode;
    }

    /// Notes a loop inside whatever is around.
    pub(super) fn inner_loop(&mut self, label: Option<&Label>) {
        if let Some(number) = self.parallel() {
            self.kernel.loops[number].loops = true;
        }
        self.targets.push(Target::Plain(label.map(|label| label.name.clone())));
    }

    fn unroll(&mut self, expr: &mut Expr, tokens: TokenStream) {
        let Expr::ForLoop(repeat) = &mut *expr else { return };
        let ranges = self.unroll_ranges(tokens);
        let Some(Unrolled { axes, ranges }) = ranges else { return };
        let variables = match plain_names(&repeat.pat) {
            Some((names, tuple)) if names.len() == ranges.len() && !(tuple && axes.is_some()) => names,
            _ => return self.find(What::UnrollPattern { ranges: ranges.len() }, &repeat.pat),
        };
        // As many as in space, if it is over all axes.
        let counted = if axes.is_some() { vec![ranges[0]; 3] } else { ranges.clone() };
        self.note_unrolled(&counted, repeat.expr.span());
        let span = repeat.for_token.span;
        let parallel = self.parallel();
        let body = mem::replace(&mut repeat.body, Block { brace_token: Default::default(), stmts: Vec::new() });
        let unroll_axes = axes.is_some();
        let unroll = Unroll {
            label: repeat.label.clone(),
            variables,
            ranges,
            axes,
            body,
            breaks: false,
            continues: false,
            accesses: Vec::new(),
            offsets: Vec::new(),
            bound: Vec::new(),
        };
        let label = label_name(&unroll.label);
        let mut body = unroll.body.clone();
        let offsets = offsets(&body);
        let pat = repeat.pat.clone();
        *expr = self.node(Node::Unroll(unroll), span);
        let node = self.kernel.nodes.len() - 1;
        let closed = unroll_axes;
        self.targets.push(Target::Unroll { node, label, closed });
        if let Some(number) = parallel {
            self.kernel.loops[number].loops = true;
        }
        self.scopes.enter();
        self.bind_pattern(&pat);
        let known = self.kernel.bound.len();
        self.visit_block_mut(&mut body);
        self.scopes.leave();
        self.targets.pop();
        let bound = self.kernel.bound[known..].to_vec();
        let accesses = (node + 1..self.kernel.nodes.len())
            .filter(|inner| matches!(self.kernel.nodes[*inner], Node::Access(_)))
            .collect();
        if let Node::Unroll(unroll) = &mut self.kernel.nodes[node] {
            unroll.body = body;
            unroll.accesses = accesses;
            unroll.offsets = offsets;
            unroll.bound = bound;
        }
    }
}

/// The `let name = ..` of an unrolled body whose right side is written part by part, or is a plain sum.
fn offsets(body: &Block) -> Vec<(Ident, Expr)> {
    let simple = |statement: &Stmt| match statement {
        Stmt::Local(local) => match (&local.pat, &local.init) {
            (Pat::Ident(name), Some(init)) if name.mutability.is_none() && init.diverge.is_none() => {
                let offset = parts(&init.expr).is_some() || name_of(&init.expr).is_some();
                offset.then(|| (name.ident.clone(), (*init.expr).clone()))
            }
            _ => None,
        },
        _ => None,
    };
    body.stmts.iter().filter_map(simple).collect()
}

fn label_name(label: &Option<Label>) -> Option<syn::Lifetime> {
    label.as_ref().map(|label| label.name.clone())
}

/// `for .. in ..`, without the body.
fn head_spot(repeat: &ExprForLoop) -> Spot {
    let ExprForLoop { for_token, pat, in_token, expr, .. } = repeat;
    Spot::new(&quote::quote!(#for_token #pat #in_token #expr))
}
