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

/// How a product meets the third operand, `c`.
#[derive(Clone, Copy)]
pub(super) enum Meeting {
    /// `a * b + c`.
    Plus,
    /// `a * b - c`.
    Minus,
    /// `c - a * b`.
    From,
}

/// Which is evaluated first, the product or the third operand.
#[derive(Clone, Copy)]
pub(super) enum First {
    Product,
    Third,
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
    let parts = |product: (&Expr, &Expr), other: &Expr, meeting, first| {
        contracted(
            product.0.to_token_stream(),
            product.1.to_token_stream(),
            other.to_token_stream(),
            meeting,
            first,
            op.span(),
        )
    };
    match op {
        BinOp::Add(_) => match (product(left), product(right)) {
            (Some(factors), _) => Some(parts(factors, right, Meeting::Plus, First::Product)),
            (None, Some(factors)) => Some(parts(factors, left, Meeting::Plus, First::Third)),
            (None, None) => None,
        },
        BinOp::Sub(_) => match (product(left), product(right)) {
            (Some(factors), _) => Some(parts(factors, right, Meeting::Minus, First::Product)),
            (None, Some(factors)) => Some(parts(factors, left, Meeting::From, First::Third)),
            (None, None) => None,
        },
        // A sum in a variable of the body, which is read last, as in Rust.
        BinOp::AddAssign(_) | BinOp::SubAssign(_) => {
            name_of(left)?;
            let meeting = if matches!(op, BinOp::AddAssign(_)) { Meeting::Plus } else { Meeting::From };
            let value = parts(product(right)?, left, meeting, First::Product);
            Some(quote!(#left = #value))
        }
        _ => None,
    }
}

/// Operands are evaluated once, in the order in which they were written.
pub(super) fn contracted(
    a: TokenStream,
    b: TokenStream,
    c: TokenStream,
    meeting: Meeting,
    first: First,
    span: proc_macro2::Span,
) -> TokenStream {
    let private = private();
    let [x, y, z, plain] = ["x", "y", "z", "plain"].map(hidden);
    let fused = fused();
    let (operands, names) = match first {
        First::Product => (quote!((#a), (#b), (#c)), quote!(#x, #y, #z)),
        First::Third => (quote!((#c), (#a), (#b)), quote!(#z, #x, #y)),
    };
    // Plain operators tell the types, also of literals, and are what an operand without a fused form is left with.
    let (sum, method) = match (meeting, first) {
        (Meeting::Plus, First::Product) => (quote_spanned!(span=> #x * #y + #z), quote!(plus)),
        (Meeting::Plus, First::Third) => (quote_spanned!(span=> #z + #x * #y), quote!(plus)),
        (Meeting::Minus, _) => (quote_spanned!(span=> #x * #y - #z), quote!(minus)),
        (Meeting::From, _) => (quote_spanned!(span=> #z - #x * #y), quote!(from)),
    };
    quote!((match (#operands) {
        (#names) => {
            let #plain = #sum;
            (&#private::Contracted(#x, #y, #z, #plain)).#method(#fused)
        }
    }))
}
