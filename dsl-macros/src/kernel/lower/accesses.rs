//! Accesses, assignments and calls.

use proc_macro2::Span;
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Ident, Member};

use super::index::Iteration;
use super::scope::Kind;
use super::targets::{Base, Root, root};
use super::{Lower, Mode};
use crate::kernel::model::{
    Access, Action, Assigned, Boundary, Capture, FieldCall, Group, Node, Op, Place, Projection, Reduce, Reduction,
    Spot, UncheckedAccess, What,
};
use crate::kernel::syntax::{bare, compound};
use crate::kernel::text::text;

/// Methods of elements that return the old value, and how many arguments each takes.
const EXCHANGES: &[(&str, usize)] = &[
    ("fetch_add", 1),
    ("fetch_sub", 1),
    ("fetch_min", 1),
    ("fetch_max", 1),
    ("fetch_or", 1),
    ("fetch_and", 1),
    ("fetch_xor", 1),
    ("swap", 1),
    ("compare_exchange", 2),
];

impl Lower {
    /// Reads `field.path[index]`, or indexes something else.
    pub(super) fn visit_index(&mut self, expr: &mut Expr) {
        if !self.is_access(expr) {
            return visit_mut::visit_expr_mut(self, expr);
        }
        let Expr::Index(index) = bare(expr).clone() else { return };
        let spot = Spot::new(expr);
        *expr = self.access(index, Action::Read, spot);
    }

    /// The placeholder of a new access.
    fn access(&mut self, target: syn::ExprIndex, action: Action, spot: Spot) -> Expr {
        let Some(base) = self.base(&target.expr) else { return Expr::Index(target) };
        let span = target.span();
        let target_spot = Spot::new(&target);
        let mut index = *target.index;
        let place = self.place(&index);
        let linear = self.linear(&index, &place);
        // An own index is never evaluated: its place in the loop is what counts.
        if matches!(place, Place::Computed | Place::Places(_)) {
            self.visit_expr_mut(&mut index);
        }
        let boundary = Boundary::Checked;
        let (parallel, target) = (self.parallel(), target_spot);
        let Base { field, path } = base;
        self.access_node(Access { field, path, index, place, linear, action, boundary, parallel, spot, target }, span)
    }

    fn access_node(&mut self, access: Access, span: Span) -> Expr {
        let parallel = access.parallel;
        let node = self.node(Node::Access(Box::new(access)), span);
        if let Some(number) = parallel {
            self.kernel.loops[number].accesses.push(self.kernel.nodes.len() - 1);
        }
        node
    }

    /// Where an index lies as seen from the parallel loop around it.
    pub(super) fn place(&self, index: &Expr) -> Place {
        let Some(number) = self.parallel() else { return Place::Computed };
        let parallel = &self.kernel.loops[number];
        Iteration { variables: &parallel.variables, tuple: parallel.tuple, rank: parallel.rank }.place(index)
    }

    /// The same for a read with a rule for indices outside, which may be of any element. Only under a checkerboard do
    /// constants tell something of it: its colour.
    fn boundary_place(&self, index: &Expr) -> Place {
        let coloured = self.parallel().is_some_and(|number| self.kernel.loops[number].head.is_checkerboard());
        match self.place(index) {
            place @ Place::Offset(_) if coloured => place,
            _ => Place::Computed,
        }
    }

    /// `field.path.clamped(index)` and its like: a read at any index, with a rule for those outside.
    fn boundary_read(&mut self, expr: &mut Expr, base: Base) {
        let spot = Spot::new(expr);
        let Expr::MethodCall(call) = &mut *expr else { return };
        let name = call.method.to_string();
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        let place = arguments.first().map_or(Place::Computed, |index| self.boundary_place(index));
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
        let mut arguments = arguments.into_iter();
        let (boundary, index) = match (name.as_str(), arguments.next(), arguments.next(), arguments.next()) {
            ("clamped", Some(index), None, None) => (Boundary::Clamped, index),
            ("wrapped", Some(index), None, None) => (Boundary::Wrapped, index),
            ("or", Some(index), Some(value), None) => (Boundary::Or(Box::new(value)), index),
            _ => {
                let field = text(&call.receiver);
                return self.find(What::BoundaryArguments { field, name }, &spot.tokens);
            }
        };
        let (Base { field, path }, parallel) = (base, self.parallel());
        let (linear, action, target, span) = (None, Action::Read, spot.clone(), spot.tokens.span());
        let access = Access { field, path, index, place, linear, action, boundary, parallel, spot, target };
        *expr = self.access_node(access, span);
    }

    /// `field.path.get_unchecked(index)` and `field.path.set_unchecked(index, value)`: whatever the caller promises.
    fn unchecked_access(&mut self, expr: &mut Expr, base: Base) {
        let spot = Spot::new(expr);
        let Expr::MethodCall(call) = &mut *expr else { return };
        let name = call.method.to_string();
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
        let mut arguments = arguments.into_iter();
        let (index, value) = match (name.as_str(), arguments.next(), arguments.next(), arguments.next()) {
            ("get_unchecked", Some(index), None, None) => (index, None),
            ("set_unchecked", Some(index), value @ Some(_), None) => (index, value),
            _ => {
                let field = text(&call.receiver);
                return self.find(What::BoundaryArguments { field, name }, &spot.tokens);
            }
        };
        let Base { field, path } = base;
        self.kernel.handed_on.insert(field);
        if let Some(number) = self.parallel() {
            *self.kernel.loops[number].unchecked.entry(field).or_default() |= value.is_some();
        }
        let span = spot.tokens.span();
        *expr = self.node(Node::Unchecked(Box::new(UncheckedAccess { field, path, index, value, spot })), span);
    }

    /// `target = value`.
    pub(super) fn visit_assign(&mut self, expr: &mut Expr, statement: bool) {
        let spot = Spot::new(expr);
        let Expr::Assign(assign) = expr else { return };
        if let Some((access, mut part)) = self.target(&assign.left) {
            if !statement {
                self.find(What::AssignmentValue { text: spot.text(), accumulates: false }, &spot.tokens);
            }
            self.visit_expr_mut(&mut assign.right);
            self.visit_part(&mut part);
            let value = (*assign.right).clone();
            *expr = self.access(access, Action::Write { part, value }, spot);
            return;
        }
        if self.holds_access(&assign.left) {
            self.visit_expr_mut(&mut assign.right);
            return self.find(What::Destructuring, &spot.tokens);
        }
        if let Some((root, how)) = self.outer_root(&assign.left) {
            self.find(What::OuterAssigned { name: root.name.to_string(), how }, &spot.tokens);
            return self.visit_expr_mut(&mut assign.right);
        }
        visit_mut::visit_expr_mut(self, expr);
    }

    fn visit_part(&mut self, part: &mut [Projection]) {
        for step in part {
            if let Projection::Index(index) = step {
                self.visit_expr_mut(index);
            }
        }
    }

    /// The variable from outside the parallel loop that a left side changes, and how.
    fn outer_root(&self, left: &Expr) -> Option<(Root, Assigned)> {
        let root = root(left)?;
        let referring = root.dereferenced || matches!(self.outer(&root.name)?, Kind::Reference | Kind::Exclusive);
        self.outer(&root.name)?;
        Some((root, if referring { Assigned::Reference } else { Assigned::Plain }))
    }

    /// `target op= value`.
    pub(super) fn visit_update(&mut self, expr: &mut Expr, statement: bool) {
        let spot = Spot::new(expr);
        let Expr::Binary(binary) = &*expr else { return };
        let Some(op) = compound(&binary.op) else { return };
        let (left, right) = ((*binary.left).clone(), (*binary.right).clone());
        if !self.update(expr, &left, right, op, statement, spot) {
            visit_mut::visit_expr_mut(self, expr);
        }
    }

    /// Replaces an accumulation by its node; `false` if it is one into a variable of the loop itself.
    fn update(&mut self, expr: &mut Expr, left: &Expr, mut value: Expr, op: Op, statement: bool, spot: Spot) -> bool {
        if let Some((access, mut part)) = self.target(left) {
            if !statement {
                self.find(What::AssignmentValue { text: spot.text(), accumulates: true }, &spot.tokens);
            }
            self.visit_expr_mut(&mut value);
            self.visit_part(&mut part);
            *expr = self.access(access, Action::Update { part, op, value }, spot);
            return true;
        }
        let Some((root, how)) = self.outer_root(left) else { return false };
        self.visit_expr_mut(&mut value);
        match (how, op.group()) {
            (Assigned::Plain, Some(group)) => {
                let Root { name: variable, mut part, .. } = root;
                self.visit_part(&mut part);
                let entries = part.iter().take_while(|step| matches!(step, Projection::Member(Member::Unnamed(_))));
                let rest = part.split_off(entries.count());
                if let Some(reduction) = self.reduction(&variable, part, !rest.is_empty(), (op, group), &spot) {
                    let reduce = Reduce { variable, reduction, part: rest, op, value };
                    *expr = self.node(Node::Reduce(reduce), spot.tokens.span());
                }
            }
            (how, _) => {
                let how = if how == Assigned::Plain { Assigned::Operator(op) } else { how };
                self.find(What::OuterAssigned { name: root.name.to_string(), how }, &spot.tokens);
            }
        }
        true
    }

    /// The reduction that an accumulation belongs to; none where that is an error.
    fn reduction(
        &mut self,
        name: &Ident,
        place: Vec<Projection>,
        by_parts: bool,
        (op, group): (Op, Group),
        spot: &Spot,
    ) -> Option<usize> {
        let number = self.parallel()?;
        let entry = |step| match step {
            Projection::Member(member) => Some(member),
            Projection::Index(_) => None,
        };
        let place: Vec<Member> = place.into_iter().filter_map(entry).collect();
        let reductions = &mut self.kernel.loops[number].reductions;
        let line = |known: &Reduction| known.first.1.line();
        for (known, reduction) in reductions.iter_mut().enumerate().filter(|(_, known)| known.name == *name) {
            let shorter = place.len().min(reduction.place.len());
            if reduction.place[..shorter] != place[..shorter] {
                continue;
            }
            let what = if reduction.place != place {
                What::ReductionParts { name: name.to_string(), line: line(reduction) }
            } else if reduction.group != group {
                let (first, line) = (reduction.first.0, line(reduction));
                What::ReductionGroups { name: name.to_string(), op, first, line }
            } else {
                reduction.by_parts |= by_parts;
                return Some(known);
            };
            self.find(what, &spot.tokens);
            return None;
        }
        reductions.push(Reduction { name: name.clone(), place, by_parts, group, first: (op, spot.clone()) });
        Some(reductions.len() - 1)
    }

    /// Notes that the parallel loop reads a variable from outside.
    pub(super) fn capture(&mut self, name: &Ident, kind: Kind) {
        let Some(number) = self.parallel() else { return };
        let captures = &mut self.kernel.loops[number].captures;
        if !captures.iter().any(|capture| capture.name == *name) {
            captures.push(Capture { name: name.clone(), reference: kind == Kind::Reference });
        }
    }

    /// `receiver.method(arguments)`.
    pub(super) fn visit_method_call(&mut self, expr: &mut Expr, statement: bool) {
        let spot = Spot::new(expr);
        let Expr::MethodCall(call) = &mut *expr else { return };
        let name = call.method.to_string();
        let op = match name.as_str() {
            "min_assign" => Some(Op::Min),
            "max_assign" => Some(Op::Max),
            _ => None,
        };
        if let (Some(op), 1) = (op, call.args.len()) {
            let (left, value) = ((*call.receiver).clone(), call.args[0].clone());
            if self.update(expr, &left, value, op, statement, spot.clone()) {
                return;
            }
            return visit_mut::visit_expr_mut(self, expr);
        }
        if let Some(base) = self.borrowed_base(&call.receiver) {
            if matches!(name.as_str(), "clamped" | "wrapped" | "or") {
                return self.boundary_read(expr, base);
            }
            if matches!(name.as_str(), "get_unchecked" | "set_unchecked") {
                return self.unchecked_access(expr, base);
            }
            if self.topology(expr, &base) {
                return;
            }
            return self.field_method(expr, base.field, base.path.is_empty(), &name);
        }
        if self.exchange(expr) {
            return;
        }
        let Expr::MethodCall(call) = &mut *expr else { return };
        let function = call.method.to_string();
        self.visit_expr_mut(&mut call.receiver);
        for argument in &mut call.args {
            self.visit_argument(argument, &function);
        }
    }

    /// `field.path[index].fetch_add(value)` and its like; `false` if it is none.
    fn exchange(&mut self, expr: &mut Expr) -> bool {
        let Expr::MethodCall(call) = &*expr else { return false };
        let (name, given) = (call.method.to_string(), call.args.len());
        let Some(&(_, takes)) = EXCHANGES.iter().find(|(known, _)| *known == name) else { return false };
        let Some((access, part)) = self.target(&call.receiver) else { return false };
        // Arrays and slices swap two of their own elements.
        if name == "swap" && given == 2 {
            return false;
        }
        let (spot, method) = (Spot::new(expr), call.method.clone());
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
        if given != takes || !part.is_empty() {
            self.find(What::Exchange { name, takes, part: !part.is_empty() }, &spot.tokens);
        }
        *expr = self.access(access, Action::Exchange { method, arguments }, spot);
        true
    }

    fn field_method(&mut self, expr: &mut Expr, field: usize, whole: bool, name: &str) {
        let Expr::MethodCall(call) = &mut *expr else { return };
        let method = call.method.clone();
        if let Some(number) = self.parallel() {
            if whole && call.args.is_empty() && matches!(name, "len" | "shape" | "origin") {
                self.kernel.loops[number].shapes.insert(field);
                *expr = self.node(Node::FieldCall(FieldCall { field, method: method.clone() }), method.span());
                return;
            }
            self.find(What::FieldMethod { field, name: name.to_owned() }, &method);
        } else if whole {
            self.kernel.handed_on.insert(field);
        } else {
            let receiver = call.receiver.to_token_stream();
            self.find(What::BareMember { field, in_loop: false }, &receiver);
        }
        call.args.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
    }

    /// `function(arguments)`.
    pub(super) fn visit_call(&mut self, call: &mut syn::ExprCall) {
        let function = call.func.to_token_stream().to_string();
        self.note_random(call);
        self.visit_expr_mut(&mut call.func);
        for argument in &mut call.args {
            self.visit_argument(argument, &function);
        }
    }

    /// An argument of a call: a member is handed on to be read, and so is a whole field inside a parallel loop.
    fn visit_argument(&mut self, argument: &mut Expr, function: &str) {
        let parallel = self.parallel();
        match self.base(argument) {
            Some(Base { field, path }) if parallel.is_some() || !path.is_empty() => {
                let spot = Spot::new(argument);
                let span = spot.tokens.span();
                let (index, place, action, boundary) =
                    (Expr::Verbatim(Default::default()), Place::Computed, Action::Read, Boundary::Lent);
                let target = spot.clone();
                let linear = None;
                let access = Access { field, path, index, place, linear, action, boundary, parallel, spot, target };
                *argument = self.access_node(access, span);
            }
            None if parallel.is_some() && self.borrowed_base(argument).is_some() => {
                self.find(What::Argument { function: function.to_owned() }, argument);
            }
            _ => self.visit_expr_mut(argument),
        }
    }

    /// `base.member`.
    pub(super) fn visit_field_access(&mut self, expr: &mut Expr) {
        match self.base(expr) {
            Some(base) => {
                let in_loop = self.mode != Mode::Top && self.parallel().is_some();
                self.find(What::BareMember { field: base.field, in_loop }, expr);
            }
            None => visit_mut::visit_expr_mut(self, expr),
        }
    }
}
