//! Which slices a kernel uses as fields. A slice that its loops only read is as good as any other Rust value.

use syn::visit::{self, Visit};
use syn::{Attribute, Block, Expr, Ident};

use super::lower::root;
use super::model::Projection;
use super::syntax::{bare, compound, name_of};

/// Heads over a field that are written as its method.
const HEADS: &[&str] = &["interior", "border", "checkerboard", "colored"];

/// Whether a parallel loop of the body runs over the slice of that name, changes its elements, or reads it by a boundary rule.
pub(super) fn is_field(body: &Block, name: &Ident) -> bool {
    let mut uses = Uses { name, parallel: false, found: false };
    uses.visit_block(body);
    uses.found
}

struct Uses<'a> {
    name: &'a Ident,
    /// Whether the present place is inside of a parallel loop.
    parallel: bool,
    found: bool,
}

impl Uses<'_> {
    fn is_head(&self, head: &Expr) -> bool {
        match bare(head) {
            Expr::MethodCall(call) => HEADS.contains(&call.method.to_string().as_str()) && self.is_head(&call.receiver),
            path => name_of(path) == Some(self.name),
        }
    }

    fn change(&mut self, left: &Expr) {
        let entry = |root: super::lower::Root| {
            root.name == *self.name && !root.dereferenced && matches!(root.part.first(), Some(Projection::Index(_)))
        };
        self.found |= self.parallel && root(left).is_some_and(entry);
    }
}

fn marked(attributes: &[Attribute], word: &str) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident(word))
}

impl Visit<'_> for Uses<'_> {
    fn visit_expr_for_loop(&mut self, repeat: &syn::ExprForLoop) {
        if self.parallel || marked(&repeat.attrs, "ordered") {
            return visit::visit_expr_for_loop(self, repeat);
        }
        if marked(&repeat.attrs, "serial") {
            return;
        }
        self.found |= self.is_head(&repeat.expr);
        self.parallel = true;
        self.visit_block(&repeat.body);
        self.parallel = false;
    }

    fn visit_expr_closure(&mut self, closure: &syn::ExprClosure) {
        // Loops in a closure of the top level are serial.
        if self.parallel {
            visit::visit_expr_closure(self, closure);
        }
    }

    fn visit_expr_assign(&mut self, assign: &syn::ExprAssign) {
        self.change(&assign.left);
        visit::visit_expr_assign(self, assign);
    }

    fn visit_expr_binary(&mut self, binary: &syn::ExprBinary) {
        if compound(&binary.op).is_some() {
            self.change(&binary.left);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_method_call(&mut self, call: &syn::ExprMethodCall) {
        match call.method.to_string().as_str() {
            "min_assign" | "max_assign" => self.change(&call.receiver),
            "clamped" | "wrapped" | "or" => self.found |= name_of(&call.receiver) == Some(self.name),
            _ => {}
        }
        visit::visit_expr_method_call(self, call);
    }

    // Items have names of their own.
    fn visit_item(&mut self, _: &syn::Item) {}
}
