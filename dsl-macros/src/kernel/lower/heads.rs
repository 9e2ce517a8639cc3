//! Loop heads: what a `for` runs over.

use proc_macro2::TokenStream;
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::{Expr, RangeLimits, Token};

use super::Lower;
use super::targets::Base;
use crate::kernel::model::{Branch, Call, Head, Place, Sieve, Spot, Topology, Upon, What};
use crate::kernel::syntax::{bare, integer};
use crate::kernel::text::text;

/// The methods of fields that name a part of them.
const PARTS: &[&str] = &["interior", "border", "checkerboard", "colored"];

impl Lower {
    /// The head of a parallel loop; what is in no list is a finding.
    pub(super) fn parallel_head(&mut self, expr: &mut Expr) -> Head {
        if let Some(head) = self.field_head(expr, true) {
            return head;
        }
        match bare(expr) {
            Expr::Range(_) => self.ranges(vec![bare(expr).clone()]),
            Expr::Macro(call) if call.mac.path.is_ident("ndrange") => {
                let tokens = call.mac.tokens.clone();
                self.ndrange(tokens)
            }
            Expr::Macro(call) if call.mac.path.is_ident("unroll") => {
                self.find(What::OutermostUnroll, expr);
                Head::Invalid
            }
            other => {
                let upon = self.upon(other);
                self.find(What::Head { upon }, expr);
                Head::Invalid
            }
        }
    }

    /// A head over a field: `f`, `f.interior(w)`, `f.border(w)`, and the colours of one. Other methods of fields are findings where the loop is parallel.
    pub(super) fn field_head(&mut self, expr: &mut Expr, parallel: bool) -> Option<Head> {
        match self.head_branch(expr) {
            Some(branch) if branch.path.is_empty() || !self.kernel.fields[branch.field].storage.is_single() => {
                return Some(Head::Field(branch));
            }
            Some(_) if parallel => {
                self.find(What::MemberHead, expr);
                return Some(Head::Invalid);
            }
            _ => {}
        }
        let whole = expr.clone();
        if let Some(colour) = self.colour_head(expr, parallel) {
            return Some(colour);
        }
        let Expr::MethodCall(call) = bare(expr) else { return None };
        let name = call.method.to_string();
        if let Some(row) = self.row_head(expr, parallel) {
            return Some(row);
        }
        let Expr::MethodCall(call) = bare(expr) else { return None };
        let branch = self.head_branch(&call.receiver)?;
        if !matches!(name.as_str(), "interior" | "border") || call.args.len() != 1 {
            if parallel {
                let upon = self.upon(&whole);
                self.find(What::Head { upon }, &whole);
                return Some(Head::Invalid);
            }
            return None;
        }
        let mut width = call.args[0].clone();
        self.visit_expr_mut_free(&mut width);
        let width = Box::new(width);
        Some(match name.as_str() {
            "border" => Head::Sifted { base: Box::new(Head::Field(branch)), sieve: Sieve::Border(width) },
            _ => Head::Interior { branch, width },
        })
    }

    /// `f.row(index)`: a list's entries, in a serial loop.
    fn row_head(&mut self, expr: &Expr, parallel: bool) -> Option<Head> {
        let Expr::MethodCall(call) = bare(expr) else { return None };
        if call.method != "row" {
            return None;
        }
        let Base { field, path } = self.base(&call.receiver)?;
        let spot = Spot::new(expr);
        if parallel {
            self.find(What::RowHead, expr);
            return Some(Head::Invalid);
        }
        if !path.is_empty() {
            self.find(What::MemberAppend { field, name: "row".to_owned() }, expr);
            return Some(Head::Invalid);
        }
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        let place = arguments.first().map_or(Place::Computed, |index| self.place(index));
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut_free(argument));
        let [index] = arguments.as_slice() else {
            let (takes, example) = ("the index of a list", "i");
            let what = What::TopologyArguments { field: text(&call.receiver), name: "row".to_owned(), takes, example };
            self.find(what, expr);
            return Some(Head::Invalid);
        };
        let index = Box::new(index.clone());
        let method = call.method.clone();
        self.note_topology(&Topology { field, path, call: Call::Row, method, arguments, place, spot });
        Some(Head::Row { field, index })
    }

    /// A field, or a member of the branch that is meant.
    fn head_branch(&self, expr: &Expr) -> Option<Branch> {
        self.base(expr).map(|Base { field, path }| Branch { field, path })
    }

    /// One colour of a head over a field: `f.checkerboard(c)`, `f.interior(w).colored(n, c)`.
    fn colour_head(&mut self, expr: &Expr, parallel: bool) -> Option<Head> {
        let Expr::MethodCall(call) = bare(expr) else { return None };
        let colours = call.args.len() == if call.method == "checkerboard" { 1 } else { 2 };
        if !colours || !(call.method == "checkerboard" || call.method == "colored") {
            return None;
        }
        let mut receiver = (*call.receiver).clone();
        let base = match self.field_head(&mut receiver, parallel)? {
            Head::Invalid => return Some(Head::Invalid),
            Head::Sifted { sieve: Sieve::Checkerboard(_) | Sieve::Colored(..), .. } => return None,
            base => Box::new(base),
        };
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut_free(argument));
        let mut arguments = arguments.into_iter().map(Box::new);
        let sieve = match (arguments.next()?, arguments.next()) {
            (colour, None) => Sieve::Checkerboard(colour),
            (modulus, Some(colour)) => Sieve::Colored(modulus, colour),
        };
        Some(Head::Sifted { base, sieve })
    }

    /// What an expression is built upon.
    fn upon(&self, expr: &Expr) -> Upon {
        match bare(expr) {
            Expr::Range(_) => Upon::Range,
            Expr::MethodCall(call) => match self.upon(&call.receiver) {
                Upon::Field(_) if PARTS.contains(&call.method.to_string().as_str()) => Upon::Part,
                Upon::Name => Upon::Other,
                upon => upon,
            },
            Expr::Path(_) if self.base(expr).is_none() => Upon::Name,
            other => match self.borrowed_base(other) {
                Some(base) => Upon::Field(self.kernel.fields[base.field].name.to_string()),
                None => Upon::Other,
            },
        }
    }

    /// `ndrange!(a..b, c..d)`.
    pub(super) fn ndrange(&mut self, tokens: TokenStream) -> Head {
        match arguments(tokens.clone()) {
            Some(list) if !list.is_empty() && list.iter().all(|part| matches!(bare(part), Expr::Range(_))) => {
                self.ranges(list.iter().map(|part| bare(part).clone()).collect())
            }
            _ => {
                self.find(What::HeadArguments { name: "ndrange".to_owned() }, &tokens);
                Head::Invalid
            }
        }
    }

    fn ranges(&mut self, list: Vec<Expr>) -> Head {
        let mut ranges = Vec::new();
        for range in list {
            let Expr::Range(parts) = &range else { continue };
            match (&parts.start, &parts.end, &parts.limits) {
                (Some(start), Some(end), RangeLimits::HalfOpen(_)) => {
                    let (mut start, mut end) = ((**start).clone(), (**end).clone());
                    self.visit_expr_mut_free(&mut start);
                    self.visit_expr_mut_free(&mut end);
                    ranges.push((start, end));
                }
                (Some(start), Some(end), RangeLimits::Closed(_)) => {
                    let what = What::InclusiveRange { start: text(start), end: text(end) };
                    self.find(what, &range);
                    return Head::Invalid;
                }
                _ => {
                    self.find(What::OpenRange, &range);
                    return Head::Invalid;
                }
            }
        }
        Head::Ranges(ranges)
    }

    /// Visits an expression of a head, which is evaluated outside the loop.
    fn visit_expr_mut_free(&mut self, expr: &mut Expr) {
        syn::visit_mut::VisitMut::visit_expr_mut(self, expr);
    }

    /// The constant ranges of `unroll!`.
    pub(super) fn unroll_ranges(&mut self, tokens: TokenStream) -> Option<Unrolled> {
        let Some(mut list) = arguments(tokens.clone()).filter(|list| !list.is_empty()) else {
            self.find(What::HeadArguments { name: "unroll".to_owned() }, &tokens);
            return None;
        };
        let axes = match bare(&list[0]) {
            Expr::Path(path) if list.len() == 2 && is_type(&path.path) => Some(path.path.clone()),
            _ => None,
        };
        if axes.is_some() {
            list.remove(0);
        }
        let mut ranges = Vec::new();
        for range in &list {
            let Expr::Range(parts) = bare(range) else {
                self.find(What::HeadArguments { name: "unroll".to_owned() }, range);
                return None;
            };
            match (&parts.start, &parts.end) {
                (Some(start), Some(end)) => {
                    let (Some(first), Some(last)) = (integer(start), integer(end)) else {
                        self.find(What::UnrollBound, if integer(start).is_none() { start } else { end });
                        return None;
                    };
                    let inclusive = matches!(parts.limits, RangeLimits::Closed(_));
                    ranges.push((first, if inclusive { last.saturating_add(1) } else { last }));
                }
                _ => {
                    self.find(What::OpenRange, range);
                    return None;
                }
            }
        }
        Some(Unrolled { axes, ranges })
    }
}

/// What `unroll!` runs over.
pub(super) struct Unrolled {
    /// The type over all of whose axes the one range runs.
    pub(super) axes: Option<syn::Path>,
    pub(super) ranges: Vec<(i32, i32)>,
}

/// Whether a path is named as types are.
fn is_type(path: &syn::Path) -> bool {
    path.segments.last().is_some_and(|last| last.ident.to_string().starts_with(char::is_uppercase))
}

/// Expressions separated by commas.
fn arguments(tokens: TokenStream) -> Option<Vec<Expr>> {
    let list = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(tokens).ok()?;
    Some(list.into_iter().collect())
}

/// The whole of a head as a span for what replaces it.
pub(super) fn span(expr: &Expr) -> proc_macro2::Span {
    expr.span()
}
