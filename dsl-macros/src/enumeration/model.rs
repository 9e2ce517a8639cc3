//! What the user meant: variants and their integers. Every error is collected, none ends the check.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Data, DataEnum, DeriveInput, Expr, ExprLit, ExprUnary, Fields, Lit, UnOp};

use crate::diagnostics::{Code, Diagnostics};

/// The integers that an enum may be stored as, and their ranges; the first that fits is chosen where none is named.
const INTEGERS: [(&str, i128, i128); 6] = [
    ("u8", 0, u8::MAX as i128),
    ("i8", i8::MIN as i128, i8::MAX as i128),
    ("u16", 0, u16::MAX as i128),
    ("i16", i16::MIN as i128, i16::MAX as i128),
    ("u32", 0, u32::MAX as i128),
    ("i32", i32::MIN as i128, i32::MAX as i128),
];

/// An enum that is to be an element.
pub(super) struct Enumeration<'a> {
    pub(super) item: &'a DeriveInput,
    /// The integer type that it is stored as.
    pub(super) integer: &'static str,
    /// Each variant with its integer, one of which is 0.
    pub(super) variants: Vec<(&'a Ident, i128)>,
}

/// The enumeration in an item; none where it is no enum or its integers fit nowhere, which is an error then.
pub(super) fn model<'a>(item: &'a DeriveInput, errors: &mut Diagnostics) -> Option<Enumeration<'a>> {
    let name = &item.ident;
    let Data::Enum(data) = &item.data else {
        errors
            .error(
                Code::NotFieldless,
                name,
                format!("`{name}` is no enum, and only enums become elements by this derive"),
            )
            .help("write `#[derive(Record)]` for a struct whose members are elements");
        return None;
    };
    if !item.generics.params.is_empty() {
        errors
            .error(
                Code::NotFieldless,
                &item.generics.params,
                format!("the enum `{name}` takes parameters, and an element is stored as one integer"),
            )
            .help("remove them, since no variant has a field that could use them");
    }
    let variants = variants(data, errors)?;
    if !variants.iter().any(|(_, value)| *value == 0) {
        errors
            .error(Code::NoZeroVariant, name, format!("no variant of the enum `{name}` has the value 0"))
            .note("a new field holds zeros, which must be a value of each member's type")
            .help("give the variant that a new field shall hold the value 0: `Nothing = 0`");
    }
    let integer = integer(item, &variants, errors)?;
    Some(Enumeration { item, integer, variants })
}

/// Each variant with its integer: the one that is written, or one more than the variant before it has.
fn variants<'a>(data: &'a DataEnum, errors: &mut Diagnostics) -> Option<Vec<(&'a Ident, i128)>> {
    let mut next = Some(0);
    let mut variants = Vec::new();
    for variant in &data.variants {
        let name = &variant.ident;
        if !matches!(variant.fields, Fields::Unit) {
            errors
                .error(
                    Code::NotFieldless,
                    &variant.fields,
                    format!("the variant `{name}` has fields, and an element is stored as one integer"),
                )
                .help("move the fields into members of the record, beside the enum that says which case it is");
        }
        if let Some((_, expression)) = &variant.discriminant {
            next = literal(expression);
            if next.is_none() {
                errors
                    .error(
                        Code::Discriminant,
                        expression,
                        format!("the value of the variant `{name}` is no integer literal, and so it is not known here"),
                    )
                    .help("write the number itself, such as `3` or `-1`");
            }
        }
        variants.extend(next.map(|value| (name, value)));
        next = next.map(|value| value + 1);
    }
    (variants.len() == data.variants.len()).then_some(variants)
}

/// The value of `3` or `-3`, if it has at most 64 bits.
fn literal(expression: &Expr) -> Option<i128> {
    match expression {
        Expr::Lit(ExprLit { lit: Lit::Int(value), .. }) => value.base10_parse::<u64>().ok().map(i128::from),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => literal(expr).map(|value| -value),
        Expr::Group(group) => literal(&group.expr),
        Expr::Paren(paren) => literal(&paren.expr),
        _ => None,
    }
}

/// The integer type of `#[repr(..)]`, or else the smallest that holds all variants.
fn integer(item: &DeriveInput, variants: &[(&Ident, i128)], errors: &mut Diagnostics) -> Option<&'static str> {
    for attribute in item.attrs.iter().filter(|attribute| attribute.path().is_ident("repr")) {
        let text = attribute.meta.to_token_stream().to_string();
        let mut words = text.split(|c: char| !c.is_alphanumeric());
        if let Some((integer, _, _)) =
            INTEGERS.iter().find(|(integer, _, _)| words.clone().any(|word| word == *integer))
        {
            // What does not fit there is the compiler's to say.
            return Some(integer);
        }
        if let Some(wide) = words.find(|word| ["i64", "u64", "i128", "u128", "isize", "usize"].contains(word)) {
            errors
                .error(Code::Discriminant, &attribute.meta, format!("an element is not stored as `{wide}`"))
                .help("write one of `u8`, `i8`, `u16`, `i16`, `u32` and `i32`, or leave the attribute out");
            return None;
        }
    }
    let fits = |&&(_, least, most): &&(&str, i128, i128)| variants.iter().all(|(_, v)| (least..=most).contains(v));
    let integer = INTEGERS.iter().find(fits).map(|(integer, _, _)| *integer);
    if integer.is_none() {
        errors
            .error(
                Code::Discriminant,
                &item.ident,
                format!("no integer of 32 bits holds all values of the enum `{}`", item.ident),
            )
            .help("number the variants from 0 on");
    }
    integer
}
