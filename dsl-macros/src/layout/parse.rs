//! Tokens to syntax: chains of words with arguments.
//!
//! A layout is an expression to Rust's grammar (so that rustfmt formats it); this stage takes that apart into the words
//! from the root down and gives none of them a meaning.

use proc_macro2::TokenStream;
use syn::parse::{Parse, ParseStream};
use syn::{BinOp, Expr, ExprBinary, Ident, Member, Path, Token};

/// `[Record:] chain + chain ..`
pub(super) struct Syntax {
    /// The record whose members the layout names.
    pub(super) record: Option<Path>,
    /// The chains, and the `+` before each but the first.
    pub(super) branches: Vec<(Option<Token![+]>, Vec<Word>)>,
}

/// One word of a chain: `dense(ij, 8)`, `aos`.
pub(super) struct Word {
    pub(super) name: Ident,
    /// The arguments, if there are parentheses.
    pub(super) arguments: Option<Vec<Expr>>,
}

/// Reads a layout.
pub(super) fn parse(tokens: TokenStream) -> syn::Result<Syntax> {
    syn::parse2(tokens)
}

impl Parse for Syntax {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let ahead = input.fork();
        let record = if ahead.parse::<Path>().is_ok() && ahead.peek(Token![:]) {
            let record: Path = input.parse()?;
            // As a path it is read for the sake of a macro of old.
            if let Some(segment) = record.segments.iter().find(|segment| segment.ident == "try") {
                return Err(syn::Error::new_spanned(segment, "`try` is a keyword, and no record's name"));
            }
            input.parse::<Token![:]>()?;
            Some(record)
        } else {
            None
        };
        let mut branches = Vec::new();
        sum(input.parse()?, None, &mut branches)?;
        Ok(Self { record, branches })
    }
}

/// Takes `a + b + c` apart, left to right.
fn sum(expr: Expr, plus: Option<Token![+]>, branches: &mut Vec<(Option<Token![+]>, Vec<Word>)>) -> syn::Result<()> {
    match expr {
        Expr::Binary(ExprBinary { left, op: BinOp::Add(next), right, .. }) => {
            sum(*left, plus, branches)?;
            sum(*right, Some(next), branches)
        }
        expr => {
            let mut words = Vec::new();
            chain(expr, &mut words)?;
            branches.push((plus, words));
            Ok(())
        }
    }
}

/// Takes `a(..).b(..).c` apart, root first.
fn chain(expr: Expr, words: &mut Vec<Word>) -> syn::Result<()> {
    match expr {
        Expr::MethodCall(call) if call.turbofish.is_none() => {
            chain(*call.receiver, words)?;
            words.push(Word { name: call.method, arguments: Some(call.args.into_iter().collect()) });
        }
        Expr::Field(field) => {
            let Member::Named(name) = field.member else {
                return Err(syn::Error::new_spanned(field.member, "expected the name of a node or a place"));
            };
            chain(*field.base, words)?;
            words.push(Word { name, arguments: None });
        }
        Expr::Call(call) => {
            let arguments = call.args.into_iter().collect();
            words.push(Word { name: word(&call.func)?, arguments: Some(arguments) });
        }
        expr => words.push(Word { name: word(&expr)?, arguments: None }),
    }
    Ok(())
}

/// The single identifier that an expression is.
fn word(expr: &Expr) -> syn::Result<Ident> {
    name(expr).ok_or_else(|| syn::Error::new_spanned(expr, "expected the name of a node or a place"))
}

/// The single identifier that an expression is, if it is one that may name something.
pub(super) fn name(expr: &Expr) -> Option<Ident> {
    match expr {
        Expr::Path(path) => path
            .path
            .get_ident()
            .filter(|name| !["self", "Self", "crate", "super"].iter().any(|word| name == word))
            .cloned(),
        _ => None,
    }
}
