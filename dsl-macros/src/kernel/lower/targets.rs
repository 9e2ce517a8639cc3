//! Which expressions are accesses.

use syn::{Expr, Ident, Member};

use super::Lower;
use crate::kernel::model::{Projection, Storage};
use crate::kernel::syntax::{bare, name_of};

/// A field or a member of it, without an index.
pub(super) struct Base {
    pub(super) field: usize,
    pub(super) path: Vec<Ident>,
}

impl Lower {
    /// The field or member that an expression names.
    pub(super) fn base(&self, expr: &Expr) -> Option<Base> {
        match bare(expr) {
            Expr::Field(member) => {
                let Member::Named(name) = &member.member else { return None };
                let mut base = self.base(&member.base)?;
                base.path.push(name.clone());
                Some(base)
            }
            path @ Expr::Path(_) => Some(Base { field: self.field(name_of(path)?)?, path: Vec::new() }),
            _ => None,
        }
    }

    /// The same behind `&`, `&mut` and `*`.
    pub(super) fn borrowed_base(&self, expr: &Expr) -> Option<Base> {
        match bare(expr) {
            Expr::Reference(reference) => self.borrowed_base(&reference.expr),
            Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Deref(_)) => self.borrowed_base(&unary.expr),
            other => self.base(other),
        }
    }

    /// Whether an expression is a field or member, bare or borrowed.
    pub(super) fn is_alias(&self, expr: &Expr) -> bool {
        self.borrowed_base(expr).is_some()
    }

    /// Whether an expression is `field.path[index]`.
    pub(super) fn is_access(&self, expr: &Expr) -> bool {
        matches!(bare(expr), Expr::Index(index) if self.names_element(index))
    }

    /// Whether an index names an element of a field. A range of a slice is a slice again, as anywhere in Rust.
    fn names_element(&self, index: &syn::ExprIndex) -> bool {
        let range = matches!(bare(&index.index), Expr::Range(_));
        self.base(&index.expr).is_some_and(|base| !range || self.kernel.fields[base.field].storage != Storage::Slice)
    }

    /// Takes the target of an assignment apart: `field.path[index]`, and the steps from there to a part of the element.
    pub(super) fn target(&self, expr: &Expr) -> Option<(syn::ExprIndex, Vec<Projection>)> {
        match bare(expr) {
            Expr::Index(index) => {
                if self.names_element(index) {
                    return Some((index.clone(), Vec::new()));
                }
                let (access, mut part) = self.target(&index.expr)?;
                part.push(Projection::Index(index.index.clone()));
                Some((access, part))
            }
            Expr::Field(member) => {
                let (access, mut part) = self.target(&member.base)?;
                part.push(Projection::Member(member.member.clone()));
                Some((access, part))
            }
            _ => None,
        }
    }

    /// Whether an assignment's left side takes elements apart: `(u[i], v[i])`.
    pub(super) fn holds_access(&self, expr: &Expr) -> bool {
        match bare(expr) {
            Expr::Tuple(tuple) => tuple.elems.iter().any(|elem| self.holds_access(elem)),
            Expr::Array(array) => array.elems.iter().any(|elem| self.holds_access(elem)),
            Expr::Call(call) => call.args.iter().any(|argument| self.holds_access(argument)),
            Expr::Struct(record) => record.fields.iter().any(|field| self.holds_access(&field.expr)),
            other => self.target(other).is_some(),
        }
    }
}

/// The variable that an assignment's left side changes, and what of it.
pub(in crate::kernel) struct Root {
    pub(in crate::kernel) name: Ident,
    /// The steps from the variable to the part.
    pub(in crate::kernel) part: Vec<Projection>,
    /// Whether it is what the variable refers to.
    pub(in crate::kernel) dereferenced: bool,
}

/// Takes an assignment's left side apart.
pub(in crate::kernel) fn root(expr: &Expr) -> Option<Root> {
    let (inner, step) = match bare(expr) {
        Expr::Field(member) => (&member.base, Projection::Member(member.member.clone())),
        Expr::Index(index) => (&index.expr, Projection::Index(index.index.clone())),
        Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Deref(_)) => {
            return root(&unary.expr).map(|root| Root { dereferenced: true, ..root });
        }
        path => {
            let name = name_of(path)?.clone();
            return Some(Root { name, part: Vec::new(), dereferenced: false });
        }
    };
    let mut root = root(inner)?;
    root.part.push(step);
    Some(root)
}
