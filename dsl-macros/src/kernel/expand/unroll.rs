//! `unroll!`: the body once for each value, and one check for a base with unrolled offsets.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::spanned::Spanned;
use syn::{BinOp, Expr};

use super::launch::Launch;
use super::names::{label, numbered, private};
use super::rewrite::{Rewrite, Scope};
use crate::kernel::access::View;
use crate::kernel::model::{Boundary, Place, Unroll};
use crate::kernel::syntax::{bare, integer, name_of, parts};

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
        if repeat.axes.is_some() {
            let (low, high) = (literal(base.low[0], "i64"), literal(base.high[0], "i64"));
            return quote!(#handle.based_all(&#corners, #at, #low, #high));
        }
        let (low, high) = (array(&base.low), array(&base.high));
        quote!(#handle.based(&#corners, #at, #low, #high))
    });
    let mut based = launch.based.clone();
    for (base, local) in bases.iter().zip(&locals) {
        based.extend(base.accesses.iter().map(|(access, offset)| (*access, (local.clone(), offset.clone()))));
    }
    let inside = launch.with_based(based);
    let fast = copies(&Rewrite { kernel: rewrite.kernel, scope: Scope::Parallel(&inside) }, node, repeat);
    let slow = rolled(rewrite, node, repeat);
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

fn array(values: &[i32]) -> TokenStream {
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
        let Some((base, offset)) = split(launch, repeat, &access.index) else { continue };
        let Some(reach) = reach(repeat, &offset) else { continue };
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

/// Takes `base + offset` apart, where the base is a variable that the unrolled body leaves alone.
fn split(launch: &Launch<'_>, repeat: &Unroll, index: &Expr) -> Option<(Expr, Expr)> {
    let Expr::Binary(sum) = bare(index) else { return None };
    if !matches!(sum.op, BinOp::Add(_)) {
        return None;
    }
    let fixed = |expr: &Expr| {
        name_of(expr).is_some_and(|name| {
            !repeat.bound.contains(name)
                && !repeat.variables.contains(&Some(name.clone()))
                && !launch.kernel.mutable.contains(&name.to_string())
        })
    };
    if fixed(&sum.left) { Some(((*sum.left).clone(), (*sum.right).clone())) } else { None }
}

/// The lowest and highest value of each part of an unrolled offset.
fn reach(repeat: &Unroll, offset: &Expr) -> Option<Vec<(i32, i32)>> {
    let offset = match name_of(offset) {
        Some(name) if repeat.bound.iter().filter(|bound| *bound == name).count() == 1 => {
            &repeat.offsets.iter().find(|(known, _)| known == name)?.1
        }
        _ => offset,
    };
    match parts(offset) {
        Some(parts) => parts.into_iter().map(|part| interval(repeat, part)).collect(),
        None => interval(repeat, offset).map(|interval| vec![interval]),
    }
}

/// The lowest and highest value of a sum of unrolled variables and literals.
fn interval(repeat: &Unroll, expr: &Expr) -> Option<(i32, i32)> {
    if let Some(value) = integer(expr) {
        return Some((value, value));
    }
    match bare(expr) {
        Expr::Binary(binary) => {
            let ((a, b), (c, d)) = (interval(repeat, &binary.left)?, interval(repeat, &binary.right)?);
            match binary.op {
                BinOp::Add(_) => Some((a.checked_add(c)?, b.checked_add(d)?)),
                BinOp::Sub(_) => Some((a.checked_sub(d)?, b.checked_sub(c)?)),
                _ => None,
            }
        }
        path => {
            let name = name_of(path)?;
            let place = repeat.variables.iter().position(|variable| variable.as_ref() == Some(name))?;
            let rebound = repeat.bound.contains(name);
            let (start, end) = repeat.ranges[place];
            (!rebound && start < end).then_some((start, end - 1))
        }
    }
}
