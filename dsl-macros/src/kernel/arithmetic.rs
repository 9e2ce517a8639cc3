//! Bodies that are nothing but arithmetic: they may run for elements that are none of the loop's, if what they write there is thrown away.
//!
//! Whether the numbers are floats, whose arithmetic cannot panic, the types say. Whole numbers of a loop's variables stand in indices alone, or are
//! made floats at once; others are the same for all elements, and where one panics it does so for those of the loop too, since there are no branches by which
//! some could be spared it.

use syn::{BinOp, Block, Expr, Pat, Stmt, Type};

use super::access::{Plan, View};
use super::model::{Access, Action, Boundary, Kernel, Loop, Node, Projection, node_of};
use super::syntax::{last_segment, name_of};

/// Functions of floats and their vectors that only compute.
const METHODS: [&str; 34] = [
    "abs",
    "ceil",
    "cos",
    "cross",
    "distance",
    "distance_squared",
    "dot",
    "element_product",
    "element_sum",
    "exp",
    "floor",
    "fract",
    "length",
    "length_squared",
    "ln",
    "max",
    "max_element",
    "min",
    "min_element",
    "mul_add",
    "normalize",
    "normalize_or_zero",
    "perp",
    "powf",
    "powi",
    "recip",
    "round",
    "signum",
    "sin",
    "sqrt",
    "tanh",
    "transpose",
    "trunc",
    "truncate",
];

/// Constructors of vectors of floats.
const VECTORS: [&str; 6] = ["vec2", "vec3", "vec4", "dvec2", "dvec3", "dvec4"];

/// Whether a function of that name only computes.
pub(crate) fn computes(name: &str) -> bool {
    METHODS.contains(&name) || VECTORS.contains(&name)
}

/// Whether a loop's body is arithmetic of its own elements and of rows beside them.
pub(crate) fn is_arithmetic(kernel: &Kernel, parallel: &Loop, plan: &Plan) -> bool {
    let body = Body { kernel, parallel, plan };
    plan.light
        && !parallel.jumps
        && parallel.reductions.is_empty()
        && parallel.macros.is_empty()
        && body.block(&parallel.body)
}

struct Body<'a> {
    kernel: &'a Kernel,
    parallel: &'a Loop,
    plan: &'a Plan,
}

impl Body<'_> {
    fn block(&self, block: &Block) -> bool {
        block.stmts.iter().all(|statement| match statement {
            Stmt::Local(local) => {
                let init = local.init.as_ref();
                self.pattern(&local.pat) && init.is_none_or(|init| init.diverge.is_none() && self.expr(&init.expr))
            }
            Stmt::Expr(expr, _) => self.expr(expr),
            Stmt::Item(_) | Stmt::Macro(_) => false,
        })
    }

    fn pattern(&self, pat: &Pat) -> bool {
        match pat {
            Pat::Ident(name) => name.by_ref.is_none() && name.subpat.is_none(),
            Pat::Wild(_) => true,
            Pat::Tuple(tuple) => tuple.elems.iter().all(|part| self.pattern(part)),
            Pat::Type(typed) => self.pattern(&typed.pat),
            Pat::Paren(paren) => self.pattern(&paren.pat),
            _ => false,
        }
    }

    fn expr(&self, expr: &Expr) -> bool {
        if let Some(node) = node_of(expr) {
            return matches!(&self.kernel.nodes[node], Node::Access(access) if self.access(node, access));
        }
        match expr {
            Expr::Lit(_) => true,
            Expr::Path(_) => {
                name_of(expr).is_none_or(|name| !self.parallel.variables.iter().flatten().any(|v| v == name))
            }
            Expr::Paren(inner) => self.expr(&inner.expr),
            Expr::Group(inner) => self.expr(&inner.expr),
            Expr::Unary(inner) => !matches!(inner.op, syn::UnOp::Deref(_)) && self.expr(&inner.expr),
            Expr::Field(part) => self.expr(&part.base),
            Expr::Tuple(tuple) => tuple.elems.iter().all(|part| self.expr(part)),
            Expr::Cast(cast) => is_float(&cast.ty) && (name_of(&cast.expr).is_some() || self.expr(&cast.expr)),
            Expr::Binary(binary) => {
                !matches!(
                    binary.op,
                    BinOp::And(_)
                        | BinOp::Or(_)
                        | BinOp::Shl(_)
                        | BinOp::Shr(_)
                        | BinOp::ShlAssign(_)
                        | BinOp::ShrAssign(_)
                ) && self.expr(&binary.left)
                    && self.expr(&binary.right)
            }
            Expr::Assign(assign) => self.expr(&assign.left) && self.expr(&assign.right),
            Expr::MethodCall(call) => {
                METHODS.contains(&call.method.to_string().as_str())
                    && call.turbofish.is_none()
                    && self.expr(&call.receiver)
                    && call.args.iter().all(|argument| self.expr(argument))
            }
            Expr::Call(call) => {
                name_of(&call.func).is_some_and(|name| VECTORS.contains(&name.to_string().as_str()))
                    && call.args.iter().all(|argument| self.expr(argument))
            }
            _ => false,
        }
    }

    /// Reads and writes through rows, whose indices need no check.
    fn access(&self, node: usize, access: &Access) -> bool {
        let row = matches!(self.plan.views[self.plan.view_of[&node]].view, View::Own | View::Row(_));
        let (part, value) = match &access.action {
            Action::Read => (None, None),
            Action::Write { part, value } | Action::Update { part, value, .. } => (Some(part), Some(value)),
            Action::Exchange { .. } => return false,
        };
        row && matches!(access.boundary, Boundary::Checked)
            && !self.parallel.unchecked.contains_key(&access.field)
            && part.is_none_or(|part| part.iter().all(|step| matches!(step, Projection::Member(_))))
            && value.is_none_or(|value| self.expr(value))
    }
}

fn is_float(ty: &Type) -> bool {
    last_segment(ty).is_some_and(|segment| segment.ident == "f32" || segment.ident == "f64")
}
