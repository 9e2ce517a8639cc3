//! Small questions about Rust's syntax.

use syn::visit::Visit;
use syn::{BinOp, Block, Expr, Ident, Lit, Pat, Type, UnOp};

use super::model::Op;

/// The expression inside parentheses and invisible groups.
pub(crate) fn bare(mut expr: &Expr) -> &Expr {
    loop {
        expr = match expr {
            Expr::Paren(paren) => &paren.expr,
            Expr::Group(group) => &group.expr,
            _ => return expr,
        };
    }
}

/// The name, if the expression is nothing but a name.
pub(crate) fn name_of(expr: &Expr) -> Option<&Ident> {
    match bare(expr) {
        Expr::Path(path) if path.attrs.is_empty() => path.path.get_ident(),
        _ => None,
    }
}

/// An integer literal with its sign.
pub(crate) fn integer(expr: &Expr) -> Option<i32> {
    match bare(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(int) => int.base10_parse().ok(),
            _ => None,
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => integer(&unary.expr)?.checked_neg(),
        _ => None,
    }
}

/// The parts of an index written part by part: `(a, b)`, `[a, b]`, `ivec2(a, b)`, `IVec2::new(a, b)`.
pub(crate) fn parts(expr: &Expr) -> Option<Vec<&Expr>> {
    match bare(expr) {
        Expr::Tuple(tuple) => Some(tuple.elems.iter().collect()),
        Expr::Array(array) => Some(array.elems.iter().collect()),
        Expr::Call(call) => vector(call),
        _ => None,
    }
}

/// The parts of a signed or unsigned integer vector's constructor.
fn vector(call: &syn::ExprCall) -> Option<Vec<&Expr>> {
    let Expr::Path(path) = &*call.func else { return None };
    let words: Vec<String> = path.path.segments.iter().rev().take(2).map(|segment| segment.ident.to_string()).collect();
    let size = match (words[0].as_str(), words.get(1).map(String::as_str)) {
        ("ivec2" | "uvec2", _) | ("new", Some("IVec2" | "UVec2")) => 2,
        ("ivec3" | "uvec3", _) | ("new", Some("IVec3" | "UVec3")) => 3,
        ("ivec4" | "uvec4", _) | ("new", Some("IVec4" | "UVec4")) => 4,
        _ => return None,
    };
    (call.args.len() == size).then(|| call.args.iter().collect())
}

/// The operator of a compound assignment.
pub(crate) fn compound(op: &BinOp) -> Option<Op> {
    Some(match op {
        BinOp::AddAssign(_) => Op::Add,
        BinOp::SubAssign(_) => Op::Sub,
        BinOp::MulAssign(_) => Op::Mul,
        BinOp::DivAssign(_) => Op::Div,
        BinOp::RemAssign(_) => Op::Rem,
        BinOp::BitAndAssign(_) => Op::And,
        BinOp::BitOrAssign(_) => Op::Or,
        BinOp::BitXorAssign(_) => Op::Xor,
        BinOp::ShlAssign(_) => Op::Shl,
        BinOp::ShrAssign(_) => Op::Shr,
        _ => return None,
    })
}

/// The names of a pattern that is a name or a tuple of names (`None` for `_`), and whether it is a tuple.
pub(crate) fn plain_names(pat: &Pat) -> Option<(Vec<Option<Ident>>, bool)> {
    match pat {
        Pat::Tuple(tuple) => {
            let names: Option<Vec<_>> = tuple.elems.iter().map(plain_name).collect();
            names.filter(|names| !names.is_empty()).map(|names| (names, true))
        }
        Pat::Paren(paren) => plain_names(&paren.pat),
        single => Some((vec![plain_name(single)?], false)),
    }
}

fn plain_name(pat: &Pat) -> Option<Option<Ident>> {
    match pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.mutability.is_none() && name.subpat.is_none() => {
            Some(Some(name.ident.clone()))
        }
        Pat::Wild(_) => Some(None),
        _ => None,
    }
}

/// Calls `each` with every name that a pattern binds and whether it is `mut`.
pub(crate) fn names(pat: &Pat, each: &mut dyn FnMut(&Ident, bool)) {
    match pat {
        Pat::Ident(name) => {
            each(&name.ident, name.mutability.is_some());
            if let Some((_, inner)) = &name.subpat {
                names(inner, each);
            }
        }
        Pat::Or(or) => or.cases.iter().for_each(|case| names(case, each)),
        Pat::Paren(paren) => names(&paren.pat, each),
        Pat::Reference(reference) => names(&reference.pat, each),
        Pat::Slice(slice) => slice.elems.iter().for_each(|elem| names(elem, each)),
        Pat::Struct(record) => record.fields.iter().for_each(|field| names(&field.pat, each)),
        Pat::Tuple(tuple) => tuple.elems.iter().for_each(|elem| names(elem, each)),
        Pat::TupleStruct(tuple) => tuple.elems.iter().for_each(|elem| names(elem, each)),
        Pat::Type(typed) => names(&typed.pat, each),
        _ => {}
    }
}

/// The macros in a pattern, which may bind any name.
pub(crate) fn pattern_macros(pat: &Pat) -> Vec<syn::Macro> {
    #[derive(Default)]
    struct Macros(Vec<syn::Macro>);
    impl Visit<'_> for Macros {
        fn visit_macro(&mut self, call: &syn::Macro) {
            self.0.push(call.clone());
        }
    }
    let mut macros = Macros::default();
    macros.visit_pat(pat);
    macros.0
}

/// The type inside parentheses and the invisible groups that macros leave.
pub(crate) fn bare_type(mut ty: &Type) -> &Type {
    loop {
        ty = match ty {
            Type::Paren(paren) => &paren.elem,
            Type::Group(group) => &group.elem,
            _ => return ty,
        };
    }
}

/// The last segment of a type's path.
pub(crate) fn last_segment(ty: &Type) -> Option<&syn::PathSegment> {
    match ty {
        Type::Path(path) => path.path.segments.last(),
        Type::Paren(paren) => last_segment(&paren.elem),
        Type::Group(group) => last_segment(&group.elem),
        _ => None,
    }
}

/// The types among the arguments of a path's segment.
pub(crate) fn type_arguments(segment: &syn::PathSegment) -> Vec<&Type> {
    match &segment.arguments {
        syn::PathArguments::AngleBracketed(arguments) => arguments
            .args
            .iter()
            .filter_map(|argument| match argument {
                syn::GenericArgument::Type(ty) => Some(ty),
                _ => None,
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The number of axes of a type, where its name tells.
pub(crate) fn axes_rank(ty: &Type) -> Option<usize> {
    match last_segment(ty)?.ident.to_string().as_str() {
        "O" => Some(0),
        "I" => Some(1),
        "Ij" => Some(2),
        "Ijk" => Some(3),
        "Ijkl" => Some(4),
        _ => None,
    }
}

/// Whether a statement stands last in its block.
pub(crate) fn is_tail(block: &Block, place: usize) -> bool {
    place + 1 == block.stmts.len()
}
