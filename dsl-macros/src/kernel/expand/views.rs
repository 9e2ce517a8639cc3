//! Accesses in a parallel loop, each through its view.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::contract::{self, First, Meeting};
use super::launch::Launch;
use super::names::{Ends, handle, hidden, private, span, unchecked};
use super::reductions::kind;
use super::rewrite::Rewrite;
use crate::kernel::access::View;
use crate::kernel::model::{Access, Action, Boundary, Op, Place, Projection, Slot, UncheckedAccess};
use crate::kernel::syntax::parts;

/// Reads, writes or changes one element.
pub(super) fn access(rewrite: &Rewrite<'_>, launch: &Launch<'_>, node: usize, access: &Access) -> TokenStream {
    let number = launch.plan.view_of[&node];
    let planned = &launch.plan.views[number];
    let ends = Ends::of(&access.target);
    let view = ends.local(&launch.view_name(number));
    match planned.view {
        View::Accumulate | View::AccumulateTogether => return accumulate(rewrite, launch, node, access, &view),
        View::Together => return together(rewrite, access, &view),
        _ => {}
    }
    if let Some(hoisted) = launch.hoisted(number) {
        let hoisted = ends.local(&hoisted);
        return ends.read(quote!(#hoisted));
    }
    if access.is_lent() {
        return ends.call(&view, "lent", TokenStream::new());
    }
    let cell = ends.local(&hidden("cell"));
    let boxed = launch.boxed(node, access, &rewrite.expr(&access.index));
    let places = match planned.view {
        View::OwnFree | View::Any if boxed.is_some() => quote!(&#cell, #boxed),
        View::Own | View::Row(_) | View::Beside(_) => quote!(&#cell),
        View::OwnFree => {
            let places = promised(rewrite, places(rewrite, access));
            quote!(&#cell, #places)
        }
        _ if matches!(access.boundary, Boundary::Checked) => promised(rewrite, rewrite.expr(&access.index)),
        _ => rewrite.expr(&access.index),
    };
    let based = launch.based(node);
    let read = match (&access.boundary, &based) {
        (Boundary::Checked, Some((base, offset))) => ends.call(&view, "get_at", quote!(&#base, #offset)),
        (Boundary::Checked, None) if boxed.is_some() && planned.view == View::Any => {
            ends.call(&view, "get_in", places.clone())
        }
        (Boundary::Checked, None) => ends.call(&view, "get", places.clone()),
        (Boundary::Clamped, _) => ends.call(&view, "clamped", places.clone()),
        (Boundary::Wrapped, _) => ends.call(&view, "wrapped", places.clone()),
        (Boundary::Lent, _) => unreachable!("a member that is handed on has no index"),
        (Boundary::Or(value), _) => {
            let value = rewrite.expr(value);
            ends.call(&view, "or", quote!(#places, #value))
        }
    };
    let (part, value) = match &access.action {
        Action::Read => return ends.read(read),
        Action::Write { part, value } | Action::Update { part, value, .. } => (part, rewrite.expr(value)),
        Action::Exchange { .. } => unreachable!("an old value is taken through a view of its own"),
    };
    if part.is_empty() && matches!(access.action, Action::Write { .. }) {
        return ends.call(&view, "set", quote!(#places, #value));
    }
    let (new, target) = (hidden("value"), hidden("target"));
    let contracted = contracted_update(rewrite, &access.action, &target, &new, span(&access.spot.tokens));
    let (value, change) = contracted
        .unwrap_or_else(|| (value, change(rewrite, &access.action, &target, &new, span(&access.spot.tokens))));
    let (bind, places) = bound_places(&planned.view, &places);
    let read = ends.call(&view, "get", places.clone());
    let write = ends.call(&view, "set", quote!(#places, #target));
    quote!({
        let #new = #value;
        #bind
        let mut #target = #read;
        #change
        #write;
    })
}

/// The factors of a product that an element of a loop's own is updated by, and the update of its copy in one rounding.
fn contracted_update(
    rewrite: &Rewrite<'_>,
    action: &Action,
    target: &Ident,
    value: &Ident,
    span: Span,
) -> Option<(TokenStream, TokenStream)> {
    let Action::Update { part, op, value: written } = action else { return None };
    let meeting = match op {
        Op::Add => Meeting::Plus,
        Op::Sub => Meeting::From,
        _ => return None,
    };
    let (a, b) = contract::product(written).filter(|_| rewrite.contracts())?;
    let (a, b, part) = (rewrite.expr(a), rewrite.expr(b), rewrite.part(part));
    let place = quote!(#target #part);
    let sum = contract::contracted(quote!(#value.0), quote!(#value.1), place.clone(), meeting, First::Product, span);
    Some((quote!((#a, #b)), quote!(#place = #sum;)))
}

/// Reads, writes or exchanges an element where iterations may meet.
fn together(rewrite: &Rewrite<'_>, access: &Access, view: &Ident) -> TokenStream {
    let ends = Ends::of(&access.target);
    let index = rewrite.expr(&access.index);
    let (part, value) = match (&access.action, &access.boundary) {
        (Action::Read, Boundary::Checked) => return ends.read(ends.call(view, "get", promised(rewrite, index))),
        (Action::Read, Boundary::Clamped) => return ends.read(ends.call(view, "clamped", index)),
        (Action::Read, Boundary::Wrapped) => return ends.read(ends.call(view, "wrapped", index)),
        (Action::Read, Boundary::Or(value)) => {
            let value = rewrite.expr(value);
            return ends.read(ends.call(view, "or", quote!(#index, #value)));
        }
        (Action::Read, Boundary::Lent) => unreachable!("what is handed on is read alone"),
        (Action::Exchange { method, arguments }, _) => {
            let ends = Ends::of(&access.spot);
            let arguments = arguments.iter().map(|argument| rewrite.expr(argument));
            let index = promised(rewrite, index);
            return ends.call(view, &method.to_string(), quote!(#index, #(#arguments),*));
        }
        (Action::Write { part, value }, _) => (part, rewrite.expr(value)),
        (Action::Update { .. }, _) => unreachable!("an accumulation has a view of its own"),
    };
    let index = promised(rewrite, index);
    if part.is_empty() {
        return ends.call(view, "set", quote!(#index, #value));
    }
    // The other components may be changed by others meanwhile, and stay as they are.
    let (new, at, before, target) = (hidden("value"), hidden("at"), hidden("before"), hidden("target"));
    let change = change(rewrite, &access.action, &target, &new, span(&access.spot.tokens));
    let read = ends.call(view, "get", quote!(#at));
    let write = ends.call(view, "set_changes", quote!(#at, #before, #target));
    quote!({
        let #new = #value;
        let #at = #index;
        let #before = #read;
        let mut #target = #before;
        #change
        #write;
    })
}

/// An index, which in an unchecked kernel was promised to lie within its field.
fn promised(rewrite: &Rewrite<'_>, index: TokenStream) -> TokenStream {
    if !rewrite.kernel.unchecked {
        return index;
    }
    let unchecked = unchecked();
    quote!(#unchecked.index(#index))
}

/// `f.get_unchecked(index)` and `f.set_unchecked(index, value)`: the user's `unsafe` block is around them.
pub(super) fn unchecked_access(rewrite: &Rewrite<'_>, launch: &Launch<'_>, access: &UncheckedAccess) -> TokenStream {
    let ends = Ends::of(&access.spot);
    let handle = ends.local(&handle(&launch.kernel.fields[access.field]));
    let (tag, index) = (launch.tag(access.field, &access.path), rewrite.expr(&access.index));
    match &access.value {
        None => ends.read(ends.call(&handle, "get_unchecked", quote!(#tag, #index))),
        Some(value) => {
            let value = rewrite.expr(value);
            ends.call(&handle, "set_unchecked", quote!(#tag, #index, #value))
        }
    }
}

/// Free places are evaluated once.
fn bound_places(view: &View, places: &TokenStream) -> (TokenStream, TokenStream) {
    if *view != View::OwnFree {
        return (TokenStream::new(), places.clone());
    }
    let (cell, at) = (hidden("cell"), hidden("at"));
    let inner: TokenStream = places.clone().into_iter().skip(3).collect();
    (quote!(let #at = #inner;), quote!(&#cell, #at))
}

/// Where the loop's variables stand in an index: `(Var::<1>, Free(k))`.
fn places(rewrite: &Rewrite<'_>, access: &Access) -> TokenStream {
    let private = private();
    let Place::Places(slots) = &access.place else { unreachable!("a free own index has places") };
    let parts = parts(&access.index).unwrap_or_default();
    let places = slots.iter().zip(parts).map(|(slot, part)| match slot {
        Slot::Variable(number) => quote!(#private::Var::<#number>),
        Slot::Free => {
            let part = rewrite.expr(part);
            quote!(#private::Free(#part))
        }
    });
    quote!((#(#places,)*))
}

/// Changes a copy of the element, `target`, by `value`.
pub(super) fn change(rewrite: &Rewrite<'_>, action: &Action, target: &Ident, value: &Ident, span: Span) -> TokenStream {
    let (part, op) = match action {
        Action::Read | Action::Exchange { .. } => return TokenStream::new(),
        Action::Write { part, .. } => (part, None),
        Action::Update { part, op, .. } => (part, Some(*op)),
    };
    let part = rewrite.part(part);
    let place = quote!(#target #part);
    let private = private();
    match op {
        None => quote_spanned!(span=> #place = #value;),
        Some(Op::Min) => quote_spanned!(span=> #place = #private::min(#place, #value);),
        Some(Op::Max) => quote_spanned!(span=> #place = #private::max(#place, #value);),
        Some(op) => {
            let op: TokenStream = op.text().parse().unwrap_or_default();
            let op = op.into_iter().map(|mut token| {
                token.set_span(span);
                token
            });
            let op: TokenStream = op.collect();
            // An error about the operator is underlined from the first token to the last.
            let at = |local: &Ident| Ident::new(&local.to_string(), local.span().located_at(span));
            let (target, value) = (at(target), at(value));
            quote!(#target #part #op #value;)
        }
    }
}

/// `view.add(index, value)`.
fn accumulate(rewrite: &Rewrite<'_>, launch: &Launch<'_>, node: usize, access: &Access, view: &Ident) -> TokenStream {
    let Action::Update { part, op, value } = &access.action else { unreachable!("an accumulation has an operator") };
    let ends = Ends::of(&access.spot);
    let value = rewrite.expr(value);
    let based = launch.based(node);
    let far = launch.far.contains(&node);
    let (at, place) = match based {
        Some((base, offset)) => ("_at", quote!(&#base, #offset)),
        None => ("", promised(rewrite, rewrite.expr(&access.index))),
    };
    if !part.is_empty() {
        let value = element_with(rewrite, *op, part, &value, view);
        let (private, kind) = (private(), op.group().map(kind));
        return call(&ends, view, far, &format!("part{at}"), quote!(#private::#kind, #place, #value));
    }
    let method = match op {
        Op::Add => "add",
        Op::Sub => "sub",
        Op::Mul => "mul",
        Op::Min => "min",
        Op::Max => "max",
        Op::Or => "or",
        Op::And => "and",
        Op::Xor => "xor",
        Op::Div | Op::Rem | Op::Shl | Op::Shr => unreachable!("`{}` accumulates nothing", op.text()),
    };
    call(&ends, view, far, &format!("{method}{at}"), quote!(#place, #value))
}

/// Calls a method of a view, or of what stands for it where code is not to grow.
fn call(ends: &Ends, view: &Ident, far: bool, method: &str, arguments: TokenStream) -> TokenStream {
    if !far {
        return ends.call(view, method, arguments);
    }
    ends.call(&Ident::new(&format!("{view}_far"), view.span()), method, arguments)
}

/// The element with a part that is accumulated, and nothing to accumulate in the others.
fn element_with(rewrite: &Rewrite<'_>, op: Op, part: &[Projection], value: &TokenStream, view: &Ident) -> TokenStream {
    let (kind, part) = (op.group().map(kind), rewrite.part(part));
    let (element, new, private) = (hidden("element"), hidden("new"), private());
    let changed = if op == Op::Sub { quote!(#private::negative(#new)) } else { quote!(#new) };
    quote!({
        let #new = #value;
        let mut #element = #view.identity(#private::#kind);
        #element #part = #changed;
        #element
    })
}
