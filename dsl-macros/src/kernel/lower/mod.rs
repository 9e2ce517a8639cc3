//! Syntax to model: finds loops, accesses and names in a kernel's body, and puts placeholders where they stood.

mod accesses;
mod heads;
mod index;
mod jumps;
mod linear;
mod loops;
pub(super) mod macros;
mod scope;
mod suspicions;
mod targets;
mod topology;

use std::collections::BTreeSet;
use std::mem;

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, FnArg, Ident, ItemFn, Pat, Stmt, Type};

use self::jumps::Target;
use self::scope::{Kind, Scopes};
pub(super) use self::targets::{Root, root};
use super::model::{Finding, Kernel, Node, Spot, What, placeholder};
use super::parse;
use super::syntax::{bare_type, compound, is_tail, name_of, names, pattern_macros};

/// What surrounds the present place.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// The top level: loops are launches.
    Top,
    /// Inside a serial loop or a closure of the top level.
    Serial,
    /// Inside the parallel loop of that number.
    Parallel(usize),
}

/// Makes the model of a kernel.
pub(super) fn lower(function: ItemFn, options: TokenStream) -> Kernel {
    walk(function, options, Mode::Top)
}

/// The model of a kernel none of whose loops is parallel.
pub(super) fn lower_on_one_thread(function: ItemFn) -> Kernel {
    walk(function, TokenStream::new(), Mode::Serial)
}

fn walk(mut function: ItemFn, options: TokenStream, mode: Mode) -> Kernel {
    let fields = parse::fields(&function);
    let mut body = mem::replace(&mut *function.block, Block { brace_token: Default::default(), stmts: Vec::new() });
    let options = parse::options(options);
    let kernel = Kernel {
        function,
        unchecked: options.unchecked,
        contract: options.contract,
        lanes: options.lanes,
        unknown_options: options.unknown,
        fields,
        nodes: Vec::new(),
        loops: Vec::new(),
        bound: Vec::new(),
        mutable: BTreeSet::new(),
        findings: Vec::new(),
        listed: BTreeSet::new(),
        handed_on: BTreeSet::new(),
        suspicions: Vec::new(),
    };
    let mut lower = Lower {
        kernel,
        mode,
        scopes: Scopes::default(),
        targets: Vec::new(),
        statement: false,
        loop_depth: 0,
        branches: 0,
    };
    lower.scopes.enter();
    lower.bind_parameters();
    lower.visit_block_mut(&mut body);
    *lower.kernel.function.block = body;
    lower.kernel
}

/// The walk over the body.
struct Lower {
    kernel: Kernel,
    mode: Mode,
    scopes: Scopes,
    /// The loops, labelled blocks and closures around, for `break` and `continue`.
    targets: Vec<Target>,
    /// Whether the next expression's value is not used.
    statement: bool,
    /// The depth of scopes at the parallel loop: what lies below comes from outside.
    loop_depth: usize,
    /// How many branches of the parallel loop's body are around, which iterations may pass by.
    branches: usize,
}

impl Lower {
    fn bind_parameters(&mut self) {
        let inputs = self.kernel.function.sig.inputs.clone();
        for input in &inputs {
            match input {
                FnArg::Receiver(receiver) => {
                    let kind = match (&receiver.reference, &receiver.mutability) {
                        (None, _) => Kind::Value,
                        (Some(_), None) => Kind::Reference,
                        (Some(_), Some(_)) => Kind::Exclusive,
                    };
                    self.scopes.bind(&Ident::new("self", receiver.self_token.span), kind);
                }
                FnArg::Typed(parameter) => match (&*parameter.pat, bare_type(&parameter.ty)) {
                    (Pat::Ident(name), Type::Reference(reference)) if name.by_ref.is_none() => {
                        let kind = if reference.mutability.is_some() { Kind::Exclusive } else { Kind::Reference };
                        self.scopes.bind(&name.ident, kind);
                    }
                    (pat, _) => names(pat, &mut |name, mutable| {
                        self.scopes.bind(name, Kind::Value);
                        if mutable {
                            self.kernel.mutable.insert(name.to_string());
                        }
                    }),
                },
            }
        }
    }

    /// The placeholder of a new node.
    fn node(&mut self, node: Node, span: Span) -> Expr {
        self.kernel.nodes.push(node);
        placeholder(self.kernel.nodes.len() - 1, span)
    }

    fn find(&mut self, what: What, at: &impl ToTokens) {
        self.kernel.findings.push(Finding { what, spot: Spot::new(at) });
    }

    /// The parallel loop around the present place.
    fn parallel(&self) -> Option<usize> {
        match self.mode {
            Mode::Parallel(number) => Some(number),
            Mode::Top | Mode::Serial => None,
        }
    }

    /// The field of that name.
    fn field(&self, name: &Ident) -> Option<usize> {
        self.kernel.fields.iter().position(|field| field.name == *name)
    }

    /// The variable from outside the parallel loop that a name stands for.
    fn outer(&self, name: &Ident) -> Option<Kind> {
        self.parallel()?;
        let (depth, variable) = self.scopes.find(name)?;
        (depth < self.loop_depth && self.field(name).is_none()).then_some(variable.kind)
    }

    fn bind_pattern(&mut self, pat: &Pat) {
        names(pat, &mut |name, mutable| {
            self.scopes.bind(name, Kind::Value);
            if mutable {
                self.kernel.mutable.insert(name.to_string());
            }
            if let Some(number) = self.parallel() {
                self.kernel.loops[number].bound.push(name.clone());
            }
            self.kernel.bound.push(name.clone());
        });
        for call in pattern_macros(pat) {
            self.opaque_macro(&call, false);
        }
    }

    /// Visits an expression whose value is not used.
    fn visit_statement(&mut self, expr: &mut Expr) {
        self.statement = true;
        self.visit_expr_mut(expr);
        self.statement = false;
    }

    fn visit_local(&mut self, local: &mut syn::Local) {
        if let Some(init) = &mut local.init {
            if self.is_alias(&init.expr) {
                self.find(What::Alias, &init.expr);
            } else {
                self.visit_expr_mut(&mut init.expr);
            }
            if let Some((_, diverge)) = &mut init.diverge {
                self.branch(|this| this.visit_expr_mut(diverge));
            }
        }
        self.visit_pat_mut(&mut local.pat);
        self.bind_pattern(&local.pat);
    }

    /// Visits what iterations may pass by.
    fn branch(&mut self, visit: impl FnOnce(&mut Self)) {
        self.branches += 1;
        visit(self);
        self.branches -= 1;
    }

    fn visit_closure(&mut self, closure: &mut syn::ExprClosure) {
        let mode = self.mode;
        if mode == Mode::Top {
            self.mode = Mode::Serial;
        }
        self.scopes.enter();
        self.targets.push(Target::Closure);
        for input in &closure.inputs {
            self.bind_pattern(input);
        }
        let known = self.kernel.nodes.len();
        self.branch(|this| this.visit_statement(&mut closure.body));
        self.targets.pop();
        self.scopes.leave();
        self.mode = mode;
        let accesses = self.kernel.nodes[known..]
            .iter()
            .any(|node| matches!(node, Node::Access(_) | Node::FieldCall(_) | Node::Unchecked(_) | Node::Topology(_)));
        if let (Some(word), true, true) = (closure.capture, accesses, self.parallel().is_some()) {
            self.find(What::MoveClosure, &word);
        }
    }

    fn visit_if(&mut self, branch: &mut syn::ExprIf) {
        self.scopes.enter();
        self.visit_expr_mut(&mut branch.cond);
        self.branch(|this| this.visit_block_mut(&mut branch.then_branch));
        self.scopes.leave();
        if let Some((_, otherwise)) = &mut branch.else_branch {
            self.branch(|this| this.visit_statement(otherwise));
        }
    }

    fn visit_match(&mut self, choice: &mut syn::ExprMatch) {
        self.visit_expr_mut(&mut choice.expr);
        for arm in &mut choice.arms {
            self.scopes.enter();
            self.bind_pattern(&arm.pat);
            self.branch(|this| {
                if let Some((_, guard)) = &mut arm.guard {
                    this.visit_expr_mut(guard);
                }
                this.visit_statement(&mut arm.body);
            });
            self.scopes.leave();
        }
    }

    fn visit_labelled_block(&mut self, block: &mut syn::ExprBlock) {
        self.targets.push(Target::Block(block.label.as_ref().map(|label| label.name.clone())));
        self.visit_block_mut(&mut block.block);
        self.targets.pop();
    }

    /// Visits an expression without its attributes.
    fn visit_bare_expr(&mut self, expr: &mut Expr) {
        let statement = mem::take(&mut self.statement);
        match expr {
            Expr::ForLoop(_) => self.visit_for(expr),
            Expr::Index(_) => self.visit_index(expr),
            Expr::Assign(_) => self.visit_assign(expr, statement),
            Expr::Binary(binary) if compound(&binary.op).is_some() => self.visit_update(expr, statement),
            Expr::MethodCall(_) => self.visit_method_call(expr, statement),
            Expr::Call(call) => self.visit_call(call),
            Expr::Field(_) => self.visit_field_access(expr),
            Expr::Path(_) => self.visit_name(expr),
            Expr::Macro(_) => self.visit_macro(expr),
            Expr::Break(_) | Expr::Continue(_) | Expr::Return(_) | Expr::Try(_) | Expr::Await(_) => {
                self.visit_jump(expr)
            }
            Expr::Closure(closure) => self.visit_closure(closure),
            Expr::If(branch) => self.visit_if(branch),
            Expr::Match(choice) => self.visit_match(choice),
            Expr::Block(block) => self.visit_labelled_block(block),
            Expr::While(repeat) => {
                self.inner_loop(repeat.label.as_ref());
                self.scopes.enter();
                self.visit_expr_mut(&mut repeat.cond);
                self.branch(|this| this.visit_block_mut(&mut repeat.body));
                self.scopes.leave();
                self.targets.pop();
            }
            Expr::Loop(repeat) => {
                self.inner_loop(repeat.label.as_ref());
                self.branch(|this| this.visit_block_mut(&mut repeat.body));
                self.targets.pop();
            }
            Expr::Let(condition) => {
                self.visit_expr_mut(&mut condition.expr);
                self.bind_pattern(&condition.pat);
            }
            Expr::Paren(paren) => {
                self.statement = statement;
                self.visit_expr_mut(&mut paren.expr);
                self.statement = false;
            }
            Expr::Binary(binary) if matches!(binary.op, syn::BinOp::And(_) | syn::BinOp::Or(_)) => {
                self.visit_expr_mut(&mut binary.left);
                self.branch(|this| this.visit_expr_mut(&mut binary.right));
            }
            Expr::Binary(binary) => {
                self.note_remainder(binary);
                visit_mut::visit_expr_mut(self, expr);
            }
            _ => visit_mut::visit_expr_mut(self, expr),
        }
    }

    /// A name used as a value.
    fn visit_name(&mut self, expr: &mut Expr) {
        let Some(name) = name_of(expr).cloned() else { return };
        if let Some(field) = self.field(&name) {
            if self.parallel().is_some() {
                self.find(What::BareField { field }, &name);
            } else {
                self.kernel.handed_on.insert(field);
            }
        } else if let Some(kind) = self.outer(&name) {
            self.capture(&name, kind);
        }
    }
}

impl VisitMut for Lower {
    fn visit_block_mut(&mut self, block: &mut Block) {
        self.scopes.enter();
        for place in 0..block.stmts.len() {
            let tail = is_tail(block, place);
            self.known_macro_statement(&mut block.stmts[place], tail);
            self.visit_stmt_mut(&mut block.stmts[place]);
        }
        self.scopes.leave();
    }

    fn visit_stmt_mut(&mut self, statement: &mut Stmt) {
        match statement {
            Stmt::Local(local) => self.visit_local(local),
            Stmt::Expr(expr, _) => self.visit_statement(expr),
            Stmt::Macro(call) => self.opaque_macro(&call.mac, false),
            Stmt::Item(item) => {
                if let syn::Item::Macro(definition) = item {
                    self.opaque_macro(&definition.mac, true);
                }
            }
        }
    }

    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        // `#[cfg(..)] u[p] = 1.0;`: attributes stay on what stands in the expression's place.
        let attributes = attributes_of(expr).map(mem::take).unwrap_or_default();
        self.visit_bare_expr(expr);
        if let (false, Some(kept)) = (attributes.is_empty(), attributes_of(expr)) {
            *kept = attributes;
        }
    }

    // Patterns hold no expressions that could be accesses, and types none at all.
    fn visit_pat_mut(&mut self, _: &mut Pat) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
}

/// The attributes of an expression of a kind that may be replaced: syn keeps those of a statement at its leftmost part.
/// Those of a loop are the language's.
fn attributes_of(expr: &mut Expr) -> Option<&mut Vec<syn::Attribute>> {
    match expr {
        Expr::Assign(inner) => attributes_of(&mut inner.left),
        Expr::Binary(inner) => attributes_of(&mut inner.left),
        Expr::Path(inner) => Some(&mut inner.attrs),
        Expr::MethodCall(inner) => Some(&mut inner.attrs),
        Expr::Macro(inner) => Some(&mut inner.attrs),
        Expr::Index(inner) => Some(&mut inner.attrs),
        Expr::Break(inner) => Some(&mut inner.attrs),
        Expr::Continue(inner) => Some(&mut inner.attrs),
        _ => None,
    }
}
