//! Bodies that call functions of the program's own behind a branch: no vector loop comes of such, and what a call may bring along makes each
//! further copy of the body dear to compile.

use syn::visit::{self, Visit};
use syn::{Block, Expr};

use super::arithmetic::computes;
use super::model::{Action, Kernel, MacroArguments, Node, node_of};

/// Functions, of any type, that make a value of others at little cost.
const CONSTRUCTORS: [&str; 9] = ["abs_diff", "clone", "default", "from", "identity", "into", "new", "splat", "zero"];

/// Whether a function that the macro does not know is called behind a branch.
pub(crate) fn calls_behind_branches(kernel: &Kernel, body: &Block) -> bool {
    let mut calls = Calls { kernel, depth: 0, found: false };
    calls.visit_block(body);
    calls.found
}

struct Calls<'a> {
    kernel: &'a Kernel,
    /// How many branches stand around.
    depth: usize,
    found: bool,
}

impl Calls<'_> {
    fn call(&mut self, name: Option<String>) {
        let known = name.is_some_and(|name| computes(&name) || CONSTRUCTORS.contains(&&*name));
        self.found |= self.depth > 0 && !known;
    }

    fn node(&mut self, node: usize) {
        let kernel = self.kernel;
        match &kernel.nodes[node] {
            Node::Access(access) => {
                self.visit_expr(&access.index);
                match &access.action {
                    Action::Read => {}
                    Action::Write { value, .. } | Action::Update { value, .. } => self.visit_expr(value),
                    Action::Exchange { arguments, .. } => arguments.iter().for_each(|value| self.visit_expr(value)),
                }
            }
            Node::Reduce(reduce) => self.visit_expr(&reduce.value),
            Node::Unroll(repeat) => self.visit_block(&repeat.body),
            Node::Macro(call) => match &call.arguments {
                MacroArguments::List(list) => list.iter().for_each(|argument| self.visit_expr(argument)),
                MacroArguments::Repeat(value, count) => {
                    self.visit_expr(value);
                    self.visit_expr(count);
                }
                MacroArguments::Matches { value, .. } => self.visit_expr(value),
            },
            _ => {}
        }
    }

    fn behind(&mut self, inside: impl FnOnce(&mut Self)) {
        self.depth += 1;
        inside(self);
        self.depth -= 1;
    }
}

impl Visit<'_> for Calls<'_> {
    fn visit_expr(&mut self, expr: &Expr) {
        if let Some(node) = node_of(expr) {
            return self.node(node);
        }
        match expr {
            Expr::If(branch) => {
                self.visit_expr(&branch.cond);
                self.behind(|inside| {
                    inside.visit_block(&branch.then_branch);
                    branch.else_branch.iter().for_each(|(_, other)| inside.visit_expr(other));
                });
            }
            Expr::Match(choice) => {
                self.visit_expr(&choice.expr);
                self.behind(|inside| choice.arms.iter().for_each(|arm| inside.visit_arm(arm)));
            }
            _ => {
                match expr {
                    Expr::Call(call) => self.call(match &*call.func {
                        Expr::Path(path) => path.path.segments.last().map(|segment| segment.ident.to_string()),
                        _ => None,
                    }),
                    Expr::MethodCall(call) => self.call(Some(call.method.to_string())),
                    _ => {}
                }
                visit::visit_expr(self, expr);
            }
        }
    }
}
