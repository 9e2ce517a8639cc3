//! Puts tokens where the model has placeholders.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, Pat, Stmt, Type};

use super::launch::Launch;
use super::names::{Ends, label, private};
use super::{contract, host, launch, unroll, views};
use crate::kernel::model::{Head, Indices, Jump, Kernel, MacroArguments, MacroCall, Node, Projection, Sieve, node_of};
use crate::kernel::syntax::name_of;

/// Where an expression stands.
#[derive(Clone, Copy)]
pub(super) enum Scope<'a> {
    /// At the top level or in a serial loop.
    Host,
    /// In a parallel loop.
    Parallel(&'a Launch<'a>),
}

/// The rewriting of one stretch of a body.
#[derive(Clone, Copy)]
pub(super) struct Rewrite<'a> {
    pub(super) kernel: &'a Kernel,
    pub(super) scope: Scope<'a>,
}

impl Rewrite<'_> {
    /// A block with its braces.
    pub(super) fn block(&self, block: &Block) -> TokenStream {
        let statements = self.statements(block);
        quote!({ #statements })
    }

    /// What a block holds.
    pub(super) fn statements(&self, block: &Block) -> TokenStream {
        let mut block = block.clone();
        Visitor(*self).visit_block_mut(&mut block);
        block.stmts.iter().map(ToTokens::to_token_stream).collect()
    }

    pub(super) fn expr(&self, expr: &Expr) -> TokenStream {
        let mut expr = expr.clone();
        Visitor(*self).visit_expr_mut(&mut expr);
        expr.into_token_stream()
    }

    /// Whether products that are added to something are rounded once here.
    pub(super) fn contracts(&self) -> bool {
        self.kernel.contract && matches!(self.scope, Scope::Parallel(_))
    }

    /// The steps from a value to a part of it.
    pub(super) fn part(&self, part: &[Projection]) -> TokenStream {
        let steps = part.iter().map(|step| match step {
            Projection::Member(member) => quote!(.#member),
            Projection::Index(index) => {
                let index = self.expr(index);
                quote!([#index])
            }
        });
        steps.collect()
    }

    fn node(&self, node: usize) -> TokenStream {
        match (&self.kernel.nodes[node], self.scope) {
            (Node::Access(access), Scope::Host) => host::access(self, access),
            (Node::Access(access), Scope::Parallel(launch)) => views::access(self, launch, node, access),
            (Node::Unchecked(access), Scope::Host) => host::unchecked_access(self, access),
            (Node::Unchecked(access), Scope::Parallel(launch)) => views::unchecked_access(self, launch, access),
            (Node::Topology(call), _) => super::topology::call(self, call),
            (Node::Launch(number), _) => launch::launch(self.kernel, *number),
            (Node::Indices(indices), _) => self.indices(&indices.head, indices),
            (Node::Unroll(repeat), _) => unroll::unroll(self, node, repeat),
            (Node::Macro(call), _) => self.macro_call(call),
            (Node::FieldCall(call), _) => {
                let handle = super::names::handle(&self.kernel.fields[call.field]);
                let method = &call.method;
                let group = Ends::at(method.span()).group(quote!(#handle.#method()), method.span());
                quote!(#group)
            }
            (Node::Reduce(reduce), Scope::Parallel(launch)) => super::reductions::apply(self, launch, reduce),
            (Node::Reduce(_), Scope::Host) => unreachable!("reductions stand in parallel loops"),
            (Node::Jump(jump), _) => {
                let label = match jump {
                    Jump::Element => label("element"),
                    Jump::Step(loop_node) => label(&format!("step{loop_node}")),
                    Jump::Leave(loop_node) => label(&format!("unrolled{loop_node}")),
                };
                quote!(break #label)
            }
        }
    }

    /// The iterator of a serial loop over a field or an `ndrange!`.
    fn indices(&self, head: &Head, indices: &Indices) -> TokenStream {
        let private = private();
        let kind = if indices.tuple { "tuples" } else { "indices" };
        let name = |prefix: &str, whole: &str| {
            let name = if prefix.is_empty() { whole.to_owned() } else { format!("{prefix}_{kind}") };
            proc_macro2::Ident::new(&name, proc_macro2::Span::call_site())
        };
        let whole = if indices.tuple { "index_tuples" } else { "indices" };
        match (head, indices.parallel) {
            (Head::Row { field, index }, parallel) => {
                let (field, index) = (&self.kernel.fields[*field], self.expr(index));
                let (handle, name) = (super::names::handle(field), &field.name);
                match (parallel, indices.tuple) {
                    (Some(_), false) => quote!(#handle.entries(#index)),
                    (Some(_), true) => quote!(#handle.entry_tuples(#index)),
                    (None, false) => quote!(#private::row(&*#name, #index)),
                    (None, true) => quote!(#private::row_tuples(&*#name, #index)),
                }
            }
            (Head::Ranges(ranges), _) => {
                let ranges = ranges.iter().map(|(start, end)| {
                    let (start, end) = (self.expr(start), self.expr(end));
                    quote!((#start)..(#end),)
                });
                quote!(#private::ndrange((#(#ranges)*)))
            }
            (Head::Field(branch), None) => {
                let (method, field) = (name("", whole), &self.kernel.fields[branch.field].name);
                quote!(#private::#method(&*#field))
            }
            (Head::Field(branch), Some(_)) => {
                let (method, handle) = (name("", whole), super::names::handle(&self.kernel.fields[branch.field]));
                quote!(#handle.#method())
            }
            (Head::Interior { branch, width }, None) => {
                let field = &self.kernel.fields[branch.field].name;
                let (method, width) = (name("interior", ""), self.expr(width));
                quote!(#private::#method(&*#field, #width))
            }
            (Head::Interior { branch, width }, Some(_)) => {
                let handle = super::names::handle(&self.kernel.fields[branch.field]);
                let (method, width) = (name("interior", ""), self.expr(width));
                quote!(#handle.#method(#width))
            }
            (Head::Sifted { base, sieve }, parallel) => {
                let all = self.indices(base, indices);
                let sieve = match (sieve, head.field(), parallel) {
                    (Sieve::Border(width), Some(field), None) => {
                        let (field, width) = (&self.kernel.fields[field].name, self.expr(width));
                        quote!(#private::border(&*#field, #width))
                    }
                    (Sieve::Border(width), Some(field), Some(_)) => {
                        let (handle, width) = (super::names::handle(&self.kernel.fields[field]), self.expr(width));
                        quote!(#handle.border(#width))
                    }
                    _ => launch::colour_of(self, sieve),
                };
                quote!(#private::sifted(#all, #sieve))
            }
            (Head::Invalid, _) => unreachable!("a kernel with an invalid head is not expanded"),
        }
    }

    fn macro_call(&self, call: &MacroCall) -> TokenStream {
        let mut mac = call.call.clone();
        mac.tokens = match &call.arguments {
            MacroArguments::List(list) => {
                let list = list.iter().map(|argument| match argument {
                    Expr::Assign(named) => {
                        let (name, value) = (&named.left, self.expr(&named.right));
                        quote!(#name = #value)
                    }
                    other => self.expr(other),
                });
                quote!(#(#list),*)
            }
            MacroArguments::Repeat(value, count) => {
                let (value, count) = (self.expr(value), self.expr(count));
                quote!(#value; #count)
            }
            MacroArguments::Matches { value, pattern, guard } => {
                let value = self.expr(value);
                let guard = guard.as_ref().map(|guard| {
                    let guard = self.expr(guard);
                    quote!(if #guard)
                });
                quote!(#value, #pattern #guard)
            }
        };
        quote!(#mac)
    }
}

/// The walk that replaces placeholders and captured names.
struct Visitor<'a>(Rewrite<'a>);

impl VisitMut for Visitor<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        if let (Some(node), Expr::Macro(placeholder)) = (node_of(expr), &*expr) {
            let (attributes, tokens) = (&placeholder.attrs, self.0.node(node));
            *expr = Expr::Verbatim(quote!(#(#attributes)* #tokens));
            return;
        }
        if let (Scope::Parallel(launch), Expr::Path(_)) = (self.0.scope, &*expr)
            && let Some(held) = name_of(expr).and_then(|name| launch.captured(name))
        {
            *expr = Expr::Verbatim(held);
            return;
        }
        visit_mut::visit_expr_mut(self, expr);
        if self.0.contracts()
            && let Some(contracted) = contract::rewritten(expr)
        {
            *expr = Expr::Verbatim(contracted);
        }
    }

    fn visit_stmt_mut(&mut self, statement: &mut Stmt) {
        // Items have names of their own.
        if !matches!(statement, Stmt::Item(_)) {
            visit_mut::visit_stmt_mut(self, statement);
        }
    }

    fn visit_field_value_mut(&mut self, value: &mut syn::FieldValue) {
        self.visit_expr_mut(&mut value.expr);
        // `Point { x }` reads the variable `x`: what stands in its place needs the name beside it.
        if value.colon_token.is_none() && !matches!(value.expr, Expr::Path(_)) {
            value.colon_token = Some(syn::Token![:](value.member.span()));
        }
    }

    fn visit_pat_mut(&mut self, _: &mut Pat) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
}
