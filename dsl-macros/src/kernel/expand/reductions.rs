//! Variables of the top level that a parallel loop accumulates into.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

use super::launch::Launch;
use super::names::{numbered, private};
use super::rewrite::Rewrite;
use crate::kernel::model::{Group, Loop, Op, Reduce};

/// The pieces of a launch that reductions need.
pub(super) struct Pieces {
    /// Before the launch: the borrow of each variable and the witness of its type.
    pub(super) before: TokenStream,
    /// In a job: its partial results.
    pub(super) partials: TokenStream,
    /// The job's result.
    pub(super) result: TokenStream,
    /// In a strip.
    pub(super) strips: TokenStream,
    /// At the start of an element.
    pub(super) identities: TokenStream,
    /// At its end.
    pub(super) puts: TokenStream,
    /// At the end of a strip.
    pub(super) absorbs: TokenStream,
    /// After the launch, for each job's result, which is called `__out`.
    pub(super) combines: TokenStream,
}

/// The pieces for a loop.
pub(super) fn pieces(parallel: &Loop) -> Pieces {
    let private = private();
    let count = parallel.reductions.len();
    let local = |name: &'static str| move |number: usize| numbered(name, number);
    let (r, t, p, s, e) = (local("r"), local("t"), local("p"), local("s"), local("e"));
    let each = |piece: &dyn Fn(usize) -> TokenStream| -> TokenStream { (0..count).map(piece).collect() };
    let partials: Vec<_> = (0..count).map(p).collect();
    let (cell, run, out) = (super::names::hidden("cell"), super::names::hidden("run"), super::names::hidden("out"));
    Pieces {
        before: each(&|n| {
            let reduction = &parallel.reductions[n];
            let (name, kind) = (&reduction.name, kind(reduction.group));
            let at = |local: Ident| Ident::new(&local.to_string(), local.span().located_at(name.span()));
            let (r, t) = (at(r(n)), at(t(n)));
            quote_spanned! {name.span()=>
                let #r = &mut #name;
                let #t = #private::reduction(#private::#kind, &*#r);
            }
        }),
        partials: each(&|n| {
            let (p, t) = (p(n), t(n));
            quote!(let mut #p = #t.partial();)
        }),
        result: match partials.as_slice() {
            [] => quote!(),
            [one] => quote!(#one.total()),
            several => quote!((#(#several.total()),*)),
        },
        strips: each(&|n| {
            let (s, t) = (s(n), t(n));
            quote!(let mut #s = #t.strip();)
        }),
        identities: each(&|n| {
            let (e, t) = (e(n), t(n));
            quote!(let mut #e = #t.identity();)
        }),
        puts: each(&|n| {
            let (s, e) = (s(n), e(n));
            quote!(#s.put(&#cell, #e);)
        }),
        absorbs: each(&|n| {
            let (p, s) = (p(n), s(n));
            quote!(#p.absorb(&#s, &#run);)
        }),
        combines: each(&|n| {
            let (t, r) = (t(n), r(n));
            let part = if count == 1 {
                quote!(#out)
            } else {
                let n = syn::Index::from(n);
                quote!(#out.#n)
            };
            quote!(#t.combine(#r, #part);)
        }),
    }
}

fn kind(group: Group) -> TokenStream {
    match group {
        Group::Sum => quote!(Sum),
        Group::Product => quote!(Product),
        Group::Min => quote!(Min),
        Group::Max => quote!(Max),
        Group::And => quote!(BitAnd),
        Group::Or => quote!(BitOr),
        Group::Xor => quote!(BitXor),
    }
}

/// `variable op= value` in the loop's body.
pub(super) fn apply(rewrite: &Rewrite<'_>, launch: &Launch<'_>, reduce: &Reduce) -> TokenStream {
    let number = launch.parallel.reductions.iter().position(|reduction| reduction.name == reduce.variable);
    let number = number.unwrap_or_default();
    let at = |local: Ident| Ident::new(&local.to_string(), local.span().located_at(reduce.variable.span()));
    let (t, e, value) = (at(numbered("t", number)), numbered("e", number), rewrite.expr(&reduce.value));
    let method = if reduce.op == Op::Sub { quote!(subtract) } else { quote!(apply) };
    quote_spanned!(reduce.variable.span()=> #t.#method(&mut #e, #value))
}
