//! Bases with offsets in unrolled bodies: `base + offset`, where the offset's box is known.

use syn::{BinOp, Expr};

use super::model::{Kernel, Unroll};
use super::syntax::{bare, integer, name_of, parts};

/// Takes `base + offset` apart, where the base is a variable that the unrolled body leaves alone.
pub(crate) fn split<'e>(kernel: &Kernel, repeat: &Unroll, index: &'e Expr) -> Option<(&'e Expr, &'e Expr)> {
    let Expr::Binary(sum) = bare(index) else { return None };
    if !matches!(sum.op, BinOp::Add(_)) {
        return None;
    }
    let fixed = |expr: &Expr| {
        name_of(expr).is_some_and(|name| {
            !repeat.bound.contains(name)
                && !repeat.variables.contains(&Some(name.clone()))
                && !kernel.mutable.contains(&name.to_string())
        })
    };
    fixed(&sum.left).then_some((&*sum.left, &*sum.right))
}

/// What an offset is: a name's value, where the body binds it to it once.
fn value<'e>(repeat: &'e Unroll, offset: &'e Expr) -> Option<&'e Expr> {
    Some(match name_of(offset) {
        Some(name) if repeat.bound.iter().filter(|bound| *bound == name).count() == 1 => {
            &repeat.offsets.iter().find(|(known, _)| known == name)?.1
        }
        _ => offset,
    })
}

/// Whether the unrolled offset takes all values in its box: each part is another variable of the loop, or such a one and a literal.
pub(crate) fn fills(repeat: &Unroll, offset: &Expr) -> bool {
    let Some(offset) = value(repeat, offset) else { return false };
    let mut seen = Vec::new();
    let mut alone = |part: &Expr| {
        let name = match bare(part) {
            Expr::Binary(sum) if integer(&sum.right).is_some() => name_of(&sum.left),
            Expr::Binary(sum) if integer(&sum.left).is_some() => name_of(&sum.right),
            _ if integer(part).is_some() => return true,
            _ => name_of(part),
        };
        let is_new = name.is_some_and(|name| !seen.contains(name));
        seen.extend(name.cloned());
        is_new
    };
    match parts(offset) {
        Some(parts) => parts.into_iter().all(alone),
        None => alone(offset),
    }
}

/// The lowest and highest value of each part of an unrolled offset.
pub(crate) fn reach(repeat: &Unroll, offset: &Expr) -> Option<Vec<(i32, i32)>> {
    let offset = value(repeat, offset)?;
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
