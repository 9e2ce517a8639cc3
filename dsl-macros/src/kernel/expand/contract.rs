//! Products that are added to something, in one rounding: `#[kernel(contract)]`.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprBinary};

use super::names::{hidden, private};
use crate::kernel::syntax::name_of;

/// The local that tells whether the running version of the body rounds once.
pub(super) fn fused() -> Ident {
    hidden("fused")
}

/// What brings the methods of [`contracted`] into scope, and the local.
pub(super) fn prepare(task: &Ident) -> TokenStream {
    let (private, fused) = (private(), fused());
    quote!(use #private::{FuseAny as _, FuseKnown as _}; let #fused = #task.fused();)
}

/// How a product meets the third operand.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// `a * b + c`, or `c + a * b` if `last`.
    Plus { last: bool },
    /// `a * b - c`.
    Minus,
    /// `c - a * b`.
    From,
}

/// The factors of a product.
pub(super) fn product(expr: &Expr) -> Option<(&Expr, &Expr)> {
    match expr {
        Expr::Paren(paren) => product(&paren.expr),
        Expr::Group(group) => product(&group.expr),
        Expr::Binary(ExprBinary { left, op: BinOp::Mul(_), right, attrs }) if attrs.is_empty() => Some((left, right)),
        _ => None,
    }
}

/// What an expression becomes that adds a product or takes it away, its operands rewritten already.
pub(super) fn rewritten(expr: &Expr) -> Option<TokenStream> {
    let Expr::Binary(ExprBinary { left, op, right, .. }) = expr else { return None };
    let parts = |product: (&Expr, &Expr), other: &Expr, meeting| {
        contracted(
            product.0.to_token_stream(),
            product.1.to_token_stream(),
            other.to_token_stream(),
            meeting,
            op.span(),
        )
    };
    match op {
        BinOp::Add(_) => match (product(left), product(right)) {
            (Some(factors), _) => Some(parts(factors, right, Meeting::Plus { last: false })),
            (None, Some(factors)) => Some(parts(factors, left, Meeting::Plus { last: true })),
            (None, None) => None,
        },
        BinOp::Sub(_) => match (product(left), product(right)) {
            (Some(factors), _) => Some(parts(factors, right, Meeting::Minus)),
            (None, Some(factors)) => Some(parts(factors, left, Meeting::From)),
            (None, None) => None,
        },
        // A sum in a variable of the body.
        BinOp::AddAssign(_) | BinOp::SubAssign(_) => {
            name_of(left)?;
            let value = parts(product(right)?, left, meeting_of(op)?);
            Some(quote!(#left = #value))
        }
        _ => None,
    }
}

/// How `target += a * b` and `target -= a * b` are written out.
fn meeting_of(op: &BinOp) -> Option<Meeting> {
    match op {
        BinOp::AddAssign(_) => Some(Meeting::Plus { last: true }),
        BinOp::SubAssign(_) => Some(Meeting::From),
        _ => None,
    }
}

/// Operands are evaluated once, in the order in which they were written.
pub(super) fn contracted(
    a: TokenStream,
    b: TokenStream,
    c: TokenStream,
    meeting: Meeting,
    span: proc_macro2::Span,
) -> TokenStream {
    let private = private();
    let [x, y, z] = ["x", "y", "z"].map(hidden);
    let fused = fused();
    let (operands, names) = match meeting {
        Meeting::Plus { last: false } | Meeting::Minus => (quote!((#a), (#b), (#c)), quote!(#x, #y, #z)),
        Meeting::Plus { last: true } | Meeting::From => (quote!((#c), (#a), (#b)), quote!(#z, #x, #y)),
    };
    // Plain operators tell the types, also of literals, and are what an operand without a fused form is left with.
    let (plain, method) = match meeting {
        Meeting::Plus { last: false } => (quote_spanned!(span=> #x * #y + #z), quote!(plus)),
        Meeting::Plus { last: true } => (quote_spanned!(span=> #z + #x * #y), quote!(plus)),
        Meeting::Minus => (quote_spanned!(span=> #x * #y - #z), quote!(minus)),
        Meeting::From => (quote_spanned!(span=> #z - #x * #y), quote!(from)),
    };
    quote!((match (#operands) {
        (#names) => {
            let __plain = #plain;
            (&#private::Contracted(#x, #y, #z, __plain)).#method(#fused)
        }
    }))
}
