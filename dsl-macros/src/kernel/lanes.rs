//! Where a body is cut that runs in lanes: at the loops inside of it, and at branches around such.

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprForLoop, ExprIf, ExprWhile, Stmt};

/// The numbers of lanes that there are.
pub(crate) const WIDTHS: [usize; 5] = [4, 8, 16, 32, 64];

/// What a statement of a body is to lanes.
pub(crate) enum Cut<'a> {
    /// All lanes run it to its end, one after another.
    No,
    For(&'a ExprForLoop),
    While(&'a ExprWhile),
    /// A branch around loops.
    If(&'a ExprIf),
}

/// Whether, and as what, lanes are cut at a statement.
pub(crate) fn cut(statement: &Stmt) -> Cut<'_> {
    match statement {
        Stmt::Expr(Expr::ForLoop(inner), _)
            if inner.attrs.is_empty() && inner.label.is_none() && !jumps(&inner.body) =>
        {
            Cut::For(inner)
        }
        Stmt::Expr(Expr::While(inner), _)
            if inner.attrs.is_empty()
                && inner.label.is_none()
                && !matches!(*inner.cond, Expr::Let(_))
                && !binds(&inner.cond)
                && !jumps(&inner.body) =>
        {
            Cut::While(inner)
        }
        Stmt::Expr(Expr::If(branch), _) if branch.attrs.is_empty() && !binds(&branch.cond) && around_loops(branch) => {
            Cut::If(branch)
        }
        _ => Cut::No,
    }
}

/// Whether lanes are cut anywhere in a block.
pub(crate) fn is_cut(block: &Block) -> bool {
    block.stmts.iter().any(|statement| !matches!(cut(statement), Cut::No))
}

fn around_loops(branch: &ExprIf) -> bool {
    is_cut(&branch.then_branch)
        || branch.else_branch.as_ref().is_some_and(|(_, other)| match &**other {
            Expr::Block(block) => is_cut(&block.block),
            Expr::If(branch) => !binds(&branch.cond) && around_loops(branch),
            _ => false,
        })
}

/// Whether a condition binds names: `let Some(x) = y`.
fn binds(condition: &Expr) -> bool {
    struct Lets(bool);
    impl Visit<'_> for Lets {
        fn visit_expr_let(&mut self, _: &syn::ExprLet) {
            self.0 = true;
        }
        fn visit_block(&mut self, _: &Block) {}
    }
    let mut lets = Lets(false);
    lets.visit_expr(condition);
    lets.0
}

/// Whether a loop's body leaves it, or an iteration of it, early.
fn jumps(body: &Block) -> bool {
    #[derive(Default)]
    struct Jumps {
        depth: usize,
        found: bool,
    }
    impl Jumps {
        fn jump(&mut self, label: bool) {
            self.found |= label || self.depth == 0;
        }
        fn inside(&mut self, visit: impl FnOnce(&mut Self)) {
            self.depth += 1;
            visit(self);
            self.depth -= 1;
        }
    }
    impl Visit<'_> for Jumps {
        fn visit_expr_break(&mut self, jump: &syn::ExprBreak) {
            self.jump(jump.label.is_some());
        }
        fn visit_expr_continue(&mut self, jump: &syn::ExprContinue) {
            self.jump(jump.label.is_some());
        }
        fn visit_expr_for_loop(&mut self, inner: &ExprForLoop) {
            self.inside(|this| visit::visit_expr_for_loop(this, inner));
        }
        fn visit_expr_while(&mut self, inner: &ExprWhile) {
            self.inside(|this| visit::visit_expr_while(this, inner));
        }
        fn visit_expr_loop(&mut self, inner: &syn::ExprLoop) {
            self.inside(|this| visit::visit_expr_loop(this, inner));
        }
        fn visit_item(&mut self, _: &syn::Item) {}
    }
    let mut jumps = Jumps::default();
    jumps.visit_block(body);
    jumps.found
}
