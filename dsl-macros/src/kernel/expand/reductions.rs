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
    let by_parts = |number: usize| parallel.reductions[number].by_parts;
    let local = |name: &'static str| move |number: usize| numbered(name, number);
    let (r, t, p, s, e) = (local("r"), local("t"), local("p"), local("s"), local("e"));
    let each = |piece: &dyn Fn(usize) -> TokenStream| -> TokenStream { (0..count).map(piece).collect() };
    // What concerns the lanes and the buffer of a strip.
    let in_lanes = |piece: &dyn Fn(usize) -> TokenStream| -> TokenStream {
        (0..count).filter(|n| !by_parts(*n)).map(piece).collect()
    };
    let partial = |n| {
        let p = p(n);
        if by_parts(n) { quote!(#p) } else { quote!(#p.total()) }
    };
    let partials: Vec<_> = (0..count).map(partial).collect();
    let (cell, run, out) = (super::names::hidden("cell"), super::names::hidden("run"), super::names::hidden("out"));
    Pieces {
        before: each(&|n| {
            let reduction = &parallel.reductions[n];
            let (name, place, kind) = (&reduction.name, &reduction.place, kind(reduction.group));
            let at = |local: Ident| Ident::new(&local.to_string(), local.span().located_at(name.span()));
            let (r, t) = (at(r(n)), at(t(n)));
            quote_spanned! {name.span()=>
                let #r = &mut #name #(.#place)*;
                let #t = #private::reduction(#private::#kind, &*#r);
            }
        }),
        partials: each(&|n| {
            let (p, t) = (p(n), t(n));
            let start = if by_parts(n) { quote!(identity) } else { quote!(partial) };
            quote!(let mut #p = #t.#start();)
        }),
        result: match partials.as_slice() {
            [] => quote!(),
            [one] => quote!(#one),
            several => quote!((#(#several),*)),
        },
        strips: in_lanes(&|n| {
            let (s, t) = (s(n), t(n));
            quote!(let mut #s = #t.strip();)
        }),
        identities: in_lanes(&|n| {
            let (e, t) = (e(n), t(n));
            quote!(let mut #e = #t.identity();)
        }),
        puts: in_lanes(&|n| {
            let (s, e) = (s(n), e(n));
            quote!(#s.put(&#cell, #e);)
        }),
        absorbs: in_lanes(&|n| {
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

/// The operator's type.
pub(super) fn kind(group: Group) -> TokenStream {
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

/// `variable op= value` in the loop's body, or to a part of the variable.
pub(super) fn apply(rewrite: &Rewrite<'_>, launch: &Launch<'_>, reduce: &Reduce) -> TokenStream {
    let (number, span) = (reduce.reduction, reduce.variable.span());
    let at = |local: Ident| Ident::new(&local.to_string(), local.span().located_at(span));
    let by_parts = launch.parallel.reductions[number].by_parts;
    let to = numbered(if by_parts { "p" } else { "e" }, number);
    let (t, value) = (at(numbered("t", number)), rewrite.expr(&reduce.value));
    let method = match reduce.op {
        Op::Sub => quote!(subtract),
        Op::Mul => quote!(multiply),
        _ => quote!(apply),
    };
    if reduce.part.is_empty() {
        return quote_spanned!(span=> #t.#method(&mut #to, #value));
    }
    let method = Ident::new(&format!("{method}_part"), span);
    let (part, new) = (rewrite.part(&reduce.part), super::names::hidden("new"));
    // As in Rust, the value comes first.
    quote_spanned!(span=> { let #new = #value; #t.#method(&mut #to #part, #new) })
}
