//! Indices that are multiples of the loop's variables plus constants: `(2 * i + a, j)`.

use syn::{BinOp, Expr, UnOp};

use super::Lower;
use super::jumps::Target;
use super::scope::Kind;
use crate::kernel::model::{Added, Linear, Node, Place};
use crate::kernel::syntax::{bare, integer, name_of, parts};

impl Lower {
    /// An index as multiples of the loop's variables, unless iterations may pass by it: the box of all of them is then checked
    /// once a launch, and one that lies outside would not do without its panic.
    pub(super) fn linear(&self, index: &Expr, place: &Place) -> Option<Vec<Linear>> {
        let parallel = &self.kernel.loops[self.parallel()?];
        let unknown = matches!(place, Place::Computed | Place::Places(_));
        if !unknown || self.branches > 0 || parallel.head.is_sifted() {
            return None;
        }
        if parallel.tuple || parallel.rank == Some(1) {
            let parts = parts(index).unwrap_or_else(|| vec![index]);
            return parts.into_iter().map(|part| self.linear_part(part)).collect();
        }
        None
    }

    /// One place of an index.
    fn linear_part(&self, part: &Expr) -> Option<Linear> {
        let constant = |offset| Linear { variable: None, offset, name: None };
        if let Some(value) = integer(part) {
            return Some(constant(value));
        }
        if let Some(name) = name_of(part) {
            let parallel = &self.kernel.loops[self.parallel()?];
            if let Some(variable) = parallel.variables.iter().position(|known| known.as_ref() == Some(name)) {
                return Some(Linear { variable: Some((variable, 1)), offset: 0, name: None });
            }
            let range = self.unrolled_range(name);
            if range.is_none() && self.outer(name) != Some(Kind::Value) {
                return None;
            }
            let name = Added { name: name.clone(), subtracted: false, range };
            return Some(Linear { variable: None, offset: 0, name: Some(name) });
        }
        match bare(part) {
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => self.linear_part(&unary.expr)?.times(-1),
            Expr::Binary(binary) => {
                let (left, right) = (self.linear_part(&binary.left)?, self.linear_part(&binary.right)?);
                match binary.op {
                    BinOp::Add(_) => left.plus(right),
                    BinOp::Sub(_) => left.plus(right.times(-1)?),
                    BinOp::Mul(_) => match (integer(&binary.left), integer(&binary.right)) {
                        (Some(factor), _) => right.times(factor),
                        (_, Some(factor)) => left.times(factor),
                        _ => None,
                    },
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The range of an unrolled loop's variable.
    fn unrolled_range(&self, name: &syn::Ident) -> Option<(i32, i32)> {
        self.targets.iter().rev().find_map(|target| {
            let Target::Unroll { node, .. } = target else { return None };
            let Node::Unroll(unroll) = &self.kernel.nodes[*node] else { return None };
            let place = unroll.variables.iter().position(|variable| variable.as_ref() == Some(name))?;
            let range = unroll.ranges[place];
            (unroll.axes.is_none() && range.0 < range.1).then_some(range)
        })
    }
}

impl Linear {
    fn times(self, factor: i32) -> Option<Self> {
        let name = match self.name {
            Some(added) if factor == -1 => Some(Added { subtracted: !added.subtracted, ..added }),
            Some(_) if factor != 1 => return None,
            name => name,
        };
        let variable = match self.variable {
            Some((variable, times)) => Some((variable, times.checked_mul(factor)?)),
            None => None,
        };
        Some(Self { variable, offset: self.offset.checked_mul(factor)?, name })
    }

    fn plus(self, other: Self) -> Option<Self> {
        let variable = match (self.variable, other.variable) {
            (Some((a, times)), Some((b, more))) if a == b => Some((a, times.checked_add(more)?)),
            (Some(_), Some(_)) => return None,
            (one, another) => one.or(another),
        };
        let name = match (self.name, other.name) {
            (Some(_), Some(_)) => return None,
            (one, another) => one.or(another),
        };
        Some(Self { variable, offset: self.offset.checked_add(other.offset)?, name })
    }
}
