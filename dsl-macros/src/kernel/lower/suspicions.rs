//! What compiles and may be a mistake.

use proc_macro2::Span;
use quote::ToTokens;
use syn::{BinOp, Expr, Ident, UnOp};

use super::Lower;
use super::jumps::Target;
use crate::kernel::model::{Head, Node, Spot, Suspicion};
use crate::kernel::syntax::{bare, integer, name_of, parts};

/// What is known of a value: nothing below the first, and nothing above the second, where that is known.
type Interval = (i64, Option<i64>);

impl Lower {
    /// `left % right` in a parallel loop.
    pub(super) fn note_remainder(&mut self, binary: &syn::ExprBinary) {
        if let (BinOp::Rem(_), Some(_)) = (&binary.op, self.parallel())
            && self.interval(&binary.left).is_some_and(|(low, _)| low < 0)
        {
            let (left, whole) = (Spot::new(&binary.left), Spot::new(binary));
            self.kernel.suspicions.push(Suspicion::Remainder { left, whole });
        }
    }

    /// A call of `random` in a parallel loop.
    pub(super) fn note_random(&mut self, call: &syn::ExprCall) {
        let Expr::Path(path) = &*call.func else { return };
        let last = path.path.segments.last().map(|segment| &segment.ident);
        let Some(name) = last.filter(|name| *name == "random") else { return };
        if let (Some(parallel), 2, None) = (self.parallel(), call.args.len(), self.scopes.find(name)) {
            let (arguments, call) = (Spot::new(&call.args), Spot::new(call));
            self.kernel.suspicions.push(Suspicion::Random { parallel, arguments, call });
        }
    }

    /// `unroll!` over these ranges, in whatever is unrolled around it.
    pub(super) fn note_unrolled(&mut self, ranges: &[(i32, i32)], at: Span) {
        let bodies = |ranges: &[(i32, i32)]| -> u64 {
            let lengths = ranges.iter().map(|(start, end)| (i64::from(*end) - i64::from(*start)).max(0).unsigned_abs());
            lengths.fold(1, u64::saturating_mul)
        };
        let around = self.unrolled().map(|unroll| bodies(&unroll.ranges)).fold(1, u64::saturating_mul);
        let bodies = around.saturating_mul(bodies(ranges));
        self.kernel.suspicions.push(Suspicion::Unrolled { around, bodies, at: Spot::new(&Ident::new("here", at)) });
    }

    /// The unrolled loops around the present place.
    fn unrolled(&self) -> impl Iterator<Item = &crate::kernel::model::Unroll> {
        self.targets.iter().filter_map(|target| match target {
            Target::Unroll { node, .. } => match &self.kernel.nodes[*node] {
                Node::Unroll(unroll) => Some(unroll),
                _ => None,
            },
            _ => None,
        })
    }

    /// The bounds of a value made of literals, loop variables and unrolled ones; vectors by their least and greatest component.
    fn interval(&self, expr: &Expr) -> Option<Interval> {
        if let Some(value) = integer(expr) {
            return Some((value.into(), Some(value.into())));
        }
        if let Some(parts) = parts(expr) {
            let parts: Option<Vec<Interval>> = parts.into_iter().map(|part| self.interval(part)).collect();
            let hull = |a: Interval, b: Interval| (a.0.min(b.0), a.1.zip(b.1).map(|(a, b)| a.max(b)));
            return parts?.into_iter().reduce(hull);
        }
        match bare(expr) {
            Expr::Binary(binary) => {
                let (left, right) = (self.interval(&binary.left)?, self.interval(&binary.right)?);
                match binary.op {
                    BinOp::Add(_) => Some((left.0 + right.0, left.1.zip(right.1).map(|(a, b)| a + b))),
                    BinOp::Sub(_) => Some((
                        right.1.map_or(i64::from(i32::MIN), |high| left.0 - high),
                        left.1.map(|high| high - right.0),
                    )),
                    _ => None,
                }
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                let (low, high) = self.interval(&unary.expr)?;
                Some((high.map_or(i64::from(i32::MIN), |high| -high), Some(-low)))
            }
            Expr::Cast(cast) => {
                let kind = cast.ty.to_token_stream().to_string();
                matches!(kind.as_str(), "i32" | "i64" | "isize").then(|| self.interval(&cast.expr))?
            }
            Expr::Path(path) => match name_of(expr) {
                Some(name) => self.variable(name),
                None => {
                    let unit = path.path.segments.last()?.ident.to_string();
                    matches!(unit.as_str(), "X" | "Y" | "Z" | "W" | "ONE").then_some((0, Some(1)))
                }
            },
            _ => None,
        }
    }

    /// The bounds of a loop's variable.
    fn variable(&self, name: &Ident) -> Option<Interval> {
        let unrolled = self.unrolled().find_map(|unroll| {
            let place = unroll.variables.iter().position(|variable| variable.as_ref() == Some(name))?;
            let (start, end) = unroll.ranges[place];
            Some((i64::from(start), Some(i64::from(end) - 1)))
        });
        if unrolled.is_some() {
            return unrolled;
        }
        let parallel = &self.kernel.loops[self.parallel()?];
        let place = parallel.variables.iter().position(|variable| variable.as_ref() == Some(name))?;
        match &parallel.head {
            Head::Ranges(ranges) => Some((i64::from(integer(&ranges.get(place)?.0)?), None)),
            head => {
                let left_out = head.left_out().map_or(Some(0), integer)?;
                Some((left_out.into(), None))
            }
        }
    }
}
