//! `unroll!`: the body once for each value, and one check for a base with unrolled offsets.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::spanned::Spanned;
use syn::{Expr, Stmt};

use super::launch::Launch;
use super::names::{label, numbered, private};
use super::rewrite::{Rewrite, Scope};
use crate::kernel::access::View;
use crate::kernel::model::{Action, Boundary, Kernel, Node, Place, Unroll, node_of};
use crate::kernel::offsets::{fills, reach, split};
use crate::kernel::syntax::name_of;

/// The tokens of an unrolled loop.
pub(super) fn unroll(rewrite: &Rewrite<'_>, node: usize, repeat: &Unroll) -> TokenStream {
    let Scope::Parallel(launch) = rewrite.scope else { return copies(rewrite, node, repeat) };
    let bases = bases(launch, repeat);
    if bases.is_empty() {
        return copies(rewrite, node, repeat);
    }
    let private = private();
    let locals: Vec<_> = (0..bases.len()).map(|number| numbered(&format!("b{node}_"), number)).collect();
    let checks = bases.iter().enumerate().map(|(number, base)| {
        let handle = launch.accumulated(base.field);
        let corners = numbered(&format!("corners{node}_"), number);
        launch.corners.borrow_mut().insert(corners.clone(), handle.clone());
        let at = rewrite.expr(&base.base);
        let filled = !launch.parallel.jumps && base.is_filled(launch.kernel, repeat);
        if repeat.axes.is_some() {
            let (low, high) = (literal(base.low[0], "i64"), literal(base.high[0], "i64"));
            return quote!(#handle.based_all::<#filled>(&#corners, #at, #low, #high));
        }
        let (low, high) = (array(&base.low), array(&base.high));
        quote!(#handle.based::<#filled, _>(&#corners, #at, #low, #high))
    });
    let mut based = launch.based.clone();
    for (base, local) in bases.iter().zip(&locals) {
        based.extend(base.accesses.iter().map(|(access, offset)| (*access, (local.clone(), offset.clone()))));
    }
    let inside = launch.with_based(based);
    let fast = copies(&Rewrite { kernel: rewrite.kernel, scope: Scope::Parallel(&inside) }, node, repeat);
    let far: BTreeSet<usize> = bases.iter().flat_map(|base| base.accesses.iter().map(|(access, _)| *access)).collect();
    launch.far_views.borrow_mut().extend(far.iter().map(|access| launch.plan.view_of[access]));
    let outside = launch.with_far(far);
    let slow = rolled(&Rewrite { kernel: rewrite.kernel, scope: Scope::Parallel(&outside) }, node, repeat);
    quote! {
        match (#(#checks,)*) {
            (#(::core::option::Option::Some(#locals),)*) => { #fast }
            _ => { #private::cold(); #slow }
        }
    }
}

/// All values, the last variable fastest.
fn values(ranges: &[(i32, i32)]) -> Vec<Vec<i32>> {
    let mut all = vec![Vec::new()];
    for (start, end) in ranges {
        all = all
            .into_iter()
            .flat_map(|values| {
                (*start..*end).map(move |value| {
                    let mut values = values.clone();
                    values.push(value);
                    values
                })
            })
            .collect();
    }
    all
}

/// The body in a closure, called for all indices over some axes.
fn over_axes(rewrite: &Rewrite<'_>, node: usize, repeat: &Unroll, axes: &syn::Path, method: &str) -> TokenStream {
    let (body, (start, end)) = (rewrite.statements(&repeat.body), repeat.ranges[0]);
    let step = repeat.continues.then(|| label(&format!("step{node}"))).map(|label| quote!(#label:));
    let (index, method) = (name(&repeat.variables[0]), Ident::new(method, axes.span()));
    let length = Literal::u32_unsuffixed(end.saturating_sub(start).max(0).unsigned_abs());
    let low = literal(start, "i32");
    quote! {
        <#axes as ::allotrope::spatial::Spatial>::#method::<#length>(
            #low,
            #[inline(always)]
            |#index| #step { #body },
        );
    }
}

/// The body once for each value.
fn copies(rewrite: &Rewrite<'_>, node: usize, repeat: &Unroll) -> TokenStream {
    if let Some(axes) = &repeat.axes {
        return over_axes(rewrite, node, repeat, axes, "unrolled");
    }
    let body = rewrite.statements(&repeat.body);
    let step = repeat.continues.then(|| label(&format!("step{node}"))).map(|label| quote!(#label:));
    let names: Vec<_> = repeat.variables.iter().map(name).collect();
    let copies = values(&repeat.ranges).into_iter().map(|values| {
        let values = values.into_iter().map(|value| literal(value, "i32"));
        quote! { #step { #[allow(unused_variables)] let (#(#names,)*) = (#(#values,)*); #body } }
    });
    let whole = repeat.breaks.then(|| label(&format!("unrolled{node}"))).map(|label| quote!(#label:));
    quote!(#whole { #(#copies)* })
}

/// The body once, in loops.
fn rolled(rewrite: &Rewrite<'_>, node: usize, repeat: &Unroll) -> TokenStream {
    if let Some(axes) = &repeat.axes {
        return over_axes(rewrite, node, repeat, axes, "rolled");
    }
    let body = rewrite.statements(&repeat.body);
    let step = repeat.continues.then(|| label(&format!("step{node}"))).map(|label| quote!(#label:));
    let mut loops = quote!(#step { #body });
    for (variable, (start, end)) in repeat.variables.iter().zip(&repeat.ranges).rev() {
        let (name, start, end) = (name(variable), literal(*start, "i32"), literal(*end, "i32"));
        loops = quote!(for #name in #start..#end { #loops });
    }
    let whole = repeat.breaks.then(|| label(&format!("unrolled{node}"))).map(|label| quote!(#label:));
    quote!(#whole { #loops })
}

fn name(name: &Option<Ident>) -> TokenStream {
    name.as_ref().map_or_else(|| quote!(_), |name| quote!(#name))
}

fn literal(value: i32, kind: &str) -> TokenStream {
    let size = Literal::u32_unsuffixed(value.unsigned_abs());
    let sign = (value < 0).then(|| quote!(-));
    let size: TokenStream = format!("{size}{kind}").parse().unwrap_or_default();
    quote!(#sign #size)
}

pub(super) fn array(values: &[i32]) -> TokenStream {
    let values = values.iter().map(|value| {
        let size = Literal::u32_unsuffixed(value.unsigned_abs());
        let sign = (*value < 0).then(|| quote!(-));
        quote!(#sign #size)
    });
    quote!([#(#values),*])
}

/// A base that is checked once for all offsets from it.
struct Base {
    field: usize,
    base: Expr,
    low: Vec<i32>,
    high: Vec<i32>,
    /// The accesses, and their offsets.
    accesses: Vec<(usize, Expr)>,
}

impl Base {
    /// Whether an access that is a statement of the body accumulates at all offsets of the box: no branch stands before it, and the body is left by no
    /// jump.
    fn is_filled(&self, kernel: &Kernel, repeat: &Unroll) -> bool {
        let mut statements = repeat.body.stmts.iter().filter_map(|statement| match statement {
            Stmt::Expr(expr, _) => node_of(expr),
            _ => None,
        });
        let of_box = |offset: &Expr| fills(repeat, offset) && reach(repeat, offset) == Some(self.reach());
        statements.any(|node| {
            let offset = self.accesses.iter().find(|(access, _)| *access == node).map(|(_, offset)| offset);
            let Node::Access(access) = &kernel.nodes[node] else { return false };
            matches!(access.action, Action::Update { .. }) && offset.is_some_and(of_box)
        })
    }

    fn reach(&self) -> Vec<(i32, i32)> {
        self.low.iter().copied().zip(self.high.iter().copied()).collect()
    }
}

/// The pairs of a field and a base in an unrolled body.
fn bases(launch: &Launch<'_>, repeat: &Unroll) -> Vec<Base> {
    let mut found: Vec<Base> = Vec::new();
    if launch.kernel.unchecked {
        return found;
    }
    for &node in &repeat.accesses {
        let access = launch.kernel.access(node);
        let view = &launch.plan.views[launch.plan.view_of[&node]].view;
        if launch.based.contains_key(&node)
            || !matches!(view, View::Any | View::Accumulate)
            || !matches!(access.place, Place::Computed)
            || !matches!(access.boundary, Boundary::Checked)
        {
            continue;
        }
        let Some((base, offset)) = split(launch.kernel, repeat, &access.index) else { continue };
        let Some(reach) = reach(repeat, offset) else { continue };
        let (base, offset) = (base.clone(), offset.clone());
        // `base + 1` with a vector adds to each part: as many parts as axes are needed.
        if repeat.axes.is_none() && launch.kernel.fields[access.field].rank != Some(reach.len()) {
            continue;
        }
        let (low, high): (Vec<i32>, Vec<i32>) = reach.into_iter().unzip();
        let name = name_of(&base);
        let same = |known: &&mut Base| {
            known.field == access.field && name_of(&known.base) == name && known.low.len() == low.len()
        };
        match found.iter_mut().find(same) {
            Some(known) => {
                known.low.iter_mut().zip(&low).for_each(|(known, low)| *known = (*known).min(*low));
                known.high.iter_mut().zip(&high).for_each(|(known, high)| *known = (*known).max(*high));
                known.accesses.push((node, offset));
            }
            None => found.push(Base { field: access.field, base, low, high, accesses: vec![(node, offset)] }),
        }
    }
    found
}
