//! `break`, `continue`, `return`, `?` and `.await`.

use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Lifetime};

use super::Lower;
use crate::kernel::model::{Jump, Node, What};

/// What a jump may name or pass through.
pub(super) enum Target {
    /// The parallel loop of that number.
    Parallel { number: usize, label: Option<Lifetime> },
    /// An unrolled loop, by its node.
    Unroll {
        node: usize,
        label: Option<Lifetime>,
        /// Whether the body stands in a closure, which jumps cannot leave.
        closed: bool,
    },
    /// Any other loop.
    Plain(Option<Lifetime>),
    /// A block, with a label or without.
    Block(Option<Lifetime>),
    /// A closure: jumps stay inside.
    Closure,
}

impl Target {
    fn label(&self) -> Option<&Lifetime> {
        match self {
            Target::Parallel { label, .. }
            | Target::Unroll { label, .. }
            | Target::Plain(label)
            | Target::Block(label) => label.as_ref(),
            Target::Closure => None,
        }
    }
}

/// Where a jump goes.
enum Found {
    /// Somewhere that the expansion leaves as it is.
    Inside,
    Parallel(usize),
    Unroll(usize),
    /// Past the parallel loop.
    Outside,
    /// Out of an unrolled loop whose body stands in a closure.
    Closed,
}

impl Lower {
    fn destination(&self, label: Option<&Lifetime>) -> Found {
        let (mut passed, mut closed) = (false, false);
        for target in self.targets.iter().rev() {
            let matches = match label {
                Some(label) => target.label() == Some(label),
                None => !matches!(target, Target::Block(_)),
            };
            match target {
                Target::Closure => return Found::Inside,
                _ if matches && closed => return Found::Closed,
                Target::Parallel { number, .. } if matches && !passed => return Found::Parallel(*number),
                Target::Parallel { .. } => passed = true,
                Target::Unroll { node, .. } if matches && !passed => return Found::Unroll(*node),
                Target::Unroll { closed: true, .. } => closed = true,
                _ if matches => return if passed { Found::Outside } else { Found::Inside },
                _ => {}
            }
        }
        if passed { Found::Outside } else { Found::Inside }
    }

    /// Whether `return` here would leave a parallel loop.
    fn leaves(&self) -> bool {
        let inner = self.targets.iter().rev().find(|t| matches!(t, Target::Closure | Target::Parallel { .. }));
        matches!(inner, Some(Target::Parallel { .. }))
    }

    /// Whether `return` here would leave an unrolled loop whose body stands in a closure, and no parallel loop.
    fn leaves_unrolled(&self) -> bool {
        let closed = |target: &&Target| matches!(target, Target::Closure | Target::Unroll { closed: true, .. });
        matches!(self.targets.iter().rev().find(closed), Some(Target::Unroll { .. })) && !self.leaves()
    }

    /// Whether the body of an unrolled loop stands in a closure.
    fn closed(&self, node: usize) -> bool {
        matches!(&self.kernel.nodes[node], Node::Unroll(unroll) if unroll.axes.is_some())
    }

    pub(super) fn visit_jump(&mut self, expr: &mut Expr) {
        visit_mut::visit_expr_mut(&mut Inner(self), expr);
        if let Some(number) = self.parallel() {
            self.kernel.loops[number].jumps = true;
        }
        let span = expr.span();
        match expr {
            Expr::Continue(jump) => match self.destination(jump.label.as_ref()) {
                Found::Inside => {}
                Found::Parallel(number) => {
                    self.kernel.loops[number].continues = true;
                    *expr = self.node(Node::Jump(Jump::Element), span);
                }
                Found::Unroll(node) => {
                    if let Node::Unroll(unroll) = &mut self.kernel.nodes[node] {
                        unroll.continues = true;
                    }
                    *expr = self.node(Node::Jump(Jump::Step(node)), span);
                }
                Found::Outside => self.find(What::Escape { how: "continue" }, expr),
                Found::Closed => self.find(What::UnrollEscape { how: "continue" }, expr),
            },
            Expr::Break(jump) => match self.destination(jump.label.as_ref()) {
                Found::Inside => {}
                Found::Parallel(_) | Found::Outside => self.find(What::Escape { how: "break" }, expr),
                Found::Closed => self.find(What::UnrollEscape { how: "break" }, expr),
                Found::Unroll(node) if self.closed(node) => self.find(What::UnrollEscape { how: "break" }, expr),
                Found::Unroll(node) => {
                    if let Node::Unroll(unroll) = &mut self.kernel.nodes[node] {
                        unroll.breaks = true;
                    }
                    *expr = self.node(Node::Jump(Jump::Leave(node)), span);
                }
            },
            Expr::Return(_) if self.leaves_unrolled() => self.find(What::UnrollEscape { how: "return" }, expr),
            Expr::Try(attempt) if self.leaves_unrolled() => {
                let mark = attempt.question_token;
                self.find(What::UnrollEscape { how: "?" }, &mark);
            }
            Expr::Return(_) if self.leaves() => self.find(What::Escape { how: "return" }, expr),
            Expr::Try(attempt) if self.leaves() => {
                let mark = attempt.question_token;
                self.find(What::Escape { how: "?" }, &mark);
            }
            Expr::Await(wait) if self.leaves() => {
                let word = wait.await_token;
                self.find(What::Escape { how: ".await" }, &word);
            }
            _ => {}
        }
    }
}

/// Visits what a jump carries, and not the jump again.
struct Inner<'a>(&'a mut Lower);

impl VisitMut for Inner<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        self.0.visit_expr_mut(expr);
    }
}
