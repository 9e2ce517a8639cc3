//! Where an index lies as seen from the iteration.

use syn::{BinOp, Expr, Ident};

use crate::kernel::model::{Place, Slot};
use crate::kernel::syntax::{bare, integer, name_of, parts};

/// The loop that an index is seen from.
pub(super) struct Iteration<'a> {
    pub(super) variables: &'a [Option<Ident>],
    /// Whether the variables were written as a tuple.
    pub(super) tuple: bool,
    pub(super) rank: Option<usize>,
}

impl Iteration<'_> {
    /// Where `index` lies.
    pub(super) fn place(&self, index: &Expr) -> Place {
        if !self.tuple && self.rank != Some(1) {
            return self.whole(index);
        }
        if !self.tuple && parts(index).is_none() {
            // One variable over one axis: `p`, `p + 1`.
            return match self.shifted(index) {
                Some((0, offset)) => at(vec![offset]),
                _ => Place::Computed,
            };
        }
        match parts(index) {
            Some(parts) => self.by_parts(&parts),
            None => Place::Computed,
        }
    }

    /// One variable over several axes: `ij`, `ij + ivec2(1, 0)`.
    fn whole(&self, index: &Expr) -> Place {
        let is_variable =
            |expr: &Expr| matches!((name_of(expr), &self.variables[0]), (Some(name), Some(own)) if name == own);
        if is_variable(index) {
            return Place::Own;
        }
        let offset = match bare(index) {
            Expr::Binary(sum) if matches!(sum.op, BinOp::Add(_)) => {
                if is_variable(&sum.left) {
                    constant(&sum.right)
                } else if is_variable(&sum.right) {
                    constant(&sum.left)
                } else {
                    None
                }
            }
            Expr::Binary(difference) if matches!(difference.op, BinOp::Sub(_)) && is_variable(&difference.left) => {
                constant(&difference.right).and_then(|offset| offset.iter().map(|o| o.checked_neg()).collect())
            }
            _ => None,
        };
        match offset {
            Some(offset) if self.rank.is_none_or(|rank| rank == offset.len()) => at(offset),
            _ => Place::Computed,
        }
    }

    fn by_parts(&self, parts: &[&Expr]) -> Place {
        let shifted: Vec<Option<(usize, i32)>> = parts.iter().map(|part| self.shifted(part)).collect();
        if parts.len() == self.variables.len() {
            let offsets: Option<Vec<i32>> = shifted
                .iter()
                .enumerate()
                .map(|(place, shifted)| shifted.filter(|(variable, _)| *variable == place).map(|(_, offset)| offset))
                .collect();
            if let Some(offsets) = offsets {
                return at(offsets);
            }
        }
        let stands = |variable: usize| shifted.contains(&Some((variable, 0)));
        if !(0..self.variables.len()).all(stands) {
            return Place::Computed;
        }
        let slot = |shifted: &Option<(usize, i32)>| match shifted {
            Some((variable, 0)) => Slot::Variable(*variable),
            _ => Slot::Free,
        };
        Place::Places(shifted.iter().map(slot).collect())
    }

    /// A loop variable plus a constant.
    fn shifted(&self, expr: &Expr) -> Option<(usize, i32)> {
        if let Some(name) = name_of(expr) {
            return Some((self.variable(name)?, 0));
        }
        let Expr::Binary(binary) = bare(expr) else { return None };
        match binary.op {
            BinOp::Add(_) => match name_of(&binary.left).and_then(|name| self.variable(name)) {
                Some(variable) => Some((variable, integer(&binary.right)?)),
                None => Some((self.variable(name_of(&binary.right)?)?, integer(&binary.left)?)),
            },
            BinOp::Sub(_) => Some((self.variable(name_of(&binary.left)?)?, integer(&binary.right)?.checked_neg()?)),
            _ => None,
        }
    }

    fn variable(&self, name: &Ident) -> Option<usize> {
        self.variables.iter().position(|variable| variable.as_ref() == Some(name))
    }
}

fn at(offset: Vec<i32>) -> Place {
    if offset.iter().all(|o| *o == 0) { Place::Own } else { Place::Offset(offset) }
}

/// A constant vector: `ivec2(1, 0)`, `IVec2::X`.
fn constant(expr: &Expr) -> Option<Vec<i32>> {
    if let Some(parts) = parts(expr) {
        return parts.into_iter().map(integer).collect();
    }
    let Expr::Path(path) = bare(expr) else { return None };
    let mut words = path.path.segments.iter().rev().map(|segment| segment.ident.to_string());
    let (name, ty) = (words.next()?, words.next()?);
    let rank = match ty.as_str() {
        "IVec2" => 2,
        "IVec3" => 3,
        "IVec4" => 4,
        _ => return None,
    };
    let unit = |axis: usize, value: i32| {
        (axis < rank).then(|| (0..rank).map(|place| if place == axis { value } else { 0 }).collect())
    };
    match name.as_str() {
        "X" => unit(0, 1),
        "Y" => unit(1, 1),
        "Z" => unit(2, 1),
        "W" => unit(3, 1),
        "NEG_X" => unit(0, -1),
        "NEG_Y" => unit(1, -1),
        "NEG_Z" => unit(2, -1),
        "NEG_W" => unit(3, -1),
        "ZERO" => Some(vec![0; rank]),
        "ONE" => Some(vec![1; rank]),
        "NEG_ONE" => Some(vec![-1; rank]),
        _ => None,
    }
}
