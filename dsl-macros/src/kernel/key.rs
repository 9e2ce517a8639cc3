//! Where an iteration accumulates, told before it runs: the index of an accumulation, and the statements that it depends on.

use std::collections::BTreeSet;

use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{BinOp, Block, Expr, Ident, Local, Pat, Stmt};

use super::access::{Plan, View};
use super::model::{Access, Action, Boundary, Jump, Kernel, Loop, MacroArguments, Node, Place, node_of};
use super::offsets::{reach, split};
use super::syntax::{bare, integer, name_of, names, parts};

/// The key of a loop.
pub(crate) struct Key {
    /// The target whose index it is.
    pub(crate) slot: usize,
    /// What it is; none for the iteration's own index.
    pub(crate) index: Option<Expr>,
    /// The statements before, in order.
    pub(crate) steps: Vec<Step>,
    pub(crate) reach: Reach,
    /// Whether all accumulations lie within the reach.
    pub(crate) certain: bool,
    /// The accesses that it reads.
    pub(crate) reads: BTreeSet<usize>,
}

/// A statement of a loop's body that its key depends on.
pub(crate) enum Step {
    Let(Local),
    /// `if condition { continue; }`.
    Guard(Expr),
}

/// The lowest and highest offset of what is updated from the key: along every axis, or along each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    All(i32, i32),
    Axes(Vec<(i32, i32)>),
}

impl Reach {
    fn union(&self, other: &Reach) -> Option<Reach> {
        let wider = |a: (i32, i32), b: (i32, i32)| (a.0.min(b.0), a.1.max(b.1));
        Some(match (self, other) {
            (Reach::All(a, b), Reach::All(c, d)) => {
                let (low, high) = wider((*a, *b), (*c, *d));
                Reach::All(low, high)
            }
            (Reach::Axes(axes), Reach::All(low, high)) | (Reach::All(low, high), Reach::Axes(axes)) => {
                Reach::Axes(axes.iter().map(|&axis| wider(axis, (*low, *high))).collect())
            }
            (Reach::Axes(these), Reach::Axes(those)) if these.len() == those.len() => {
                Reach::Axes(these.iter().zip(those).map(|(&this, &that)| wider(this, that)).collect())
            }
            (Reach::Axes(_), Reach::Axes(_)) => return None,
        })
    }
}

/// Where one accumulation lies.
#[derive(Clone)]
struct Candidate {
    node: usize,
    /// None for the iteration's own index.
    base: Option<Expr>,
    reach: Reach,
}

impl Candidate {
    fn same(&self, other: &Candidate) -> bool {
        let text = |base: &Option<Expr>| base.as_ref().map(|base| base.to_token_stream().to_string());
        text(&self.base) == text(&other.base)
    }
}

/// The key of a loop, where there is one.
pub(crate) fn key(kernel: &Kernel, number: usize, plan: &Plan) -> Option<Key> {
    let parallel = &kernel.loops[number];
    if plan.targets.is_empty() {
        return None;
    }
    if parallel.scatter.as_ref().is_some_and(|scatter| scatter != "Colored" && scatter != "Auto") {
        return None;
    }
    let adds = |node: &&usize| plan.views[plan.view_of[*node]].view == View::Accumulate;
    let nodes: Vec<usize> = parallel.accesses.iter().filter(adds).copied().collect();
    if let Some(index) = &parallel.key {
        let reads = accesses(kernel, index);
        let reach = parallel.reach.unwrap_or_default();
        let (index, steps) = (Some(index.clone()), Vec::new());
        return Some(Key { slot: 0, index, steps, reach: Reach::All(-reach, reach), certain: true, reads });
    }
    let asked = parallel.scatter.as_ref().is_some_and(|scatter| scatter == "Colored");
    let found: Vec<Option<Candidate>> = nodes.iter().map(|&node| candidate(kernel, node)).collect();
    let (first, (steps, reads)) =
        found.iter().flatten().find_map(|first| Some((first, resolve(kernel, parallel, plan, first)?)))?;
    // What runs twice must do nothing but compute, unless the loop itself asks for it.
    let computes = |step: &Step| match step {
        Step::Let(local) => local.init.as_ref().is_none_or(|init| only_computes(kernel, &init.expr)),
        Step::Guard(condition) => only_computes(kernel, condition),
    };
    let pure = steps.iter().all(computes) && first.base.as_ref().is_none_or(|base| only_computes(kernel, base));
    if !asked && !pure {
        return None;
    }
    let alike = || found.iter().flatten().filter(|other| other.same(first));
    let widest = alike().try_fold(first.reach.clone(), |widest, other| widest.union(&other.reach));
    let mut certain = alike().count() == nodes.len() && widest.is_some();
    let mut reach = widest.unwrap_or_else(|| first.reach.clone());
    if let Some(told) = parallel.reach {
        reach = reach.union(&Reach::All(-told, told)).unwrap_or(reach);
        certain = true;
    }
    let field = kernel.access(first.node).field;
    let slot = plan.targets.iter().position(|(target, _)| *target == field)?;
    Some(Key { slot, index: first.base.clone(), steps, reach, certain, reads })
}

/// Whether all calls in an expression are of functions that are known to do nothing but compute.
fn only_computes<'a>(kernel: &'a Kernel, expr: &'a Expr) -> bool {
    let mut walk = Walk::new(kernel);
    walk.visit_expr(expr);
    walk.calls.iter().all(|name| {
        const KNOWN: [&str; 37] = [
            "abs",
            "ceil",
            "clamp",
            "cross",
            "div_euclid",
            "dot",
            "element_product",
            "element_sum",
            "exp",
            "extend",
            "floor",
            "fract",
            "from",
            "length",
            "length_squared",
            "ln",
            "max",
            "max_element",
            "min",
            "min_element",
            "mul_add",
            "normalize",
            "powf",
            "powi",
            "recip",
            "rem_euclid",
            "round",
            "rotate",
            "signum",
            "splat",
            "sqrt",
            "trunc",
            "truncate",
            "zero",
            "one",
            "count_ones",
            "trailing_zeros",
        ];
        const KINDS: [&str; 5] = ["as_", "to_", "wrapping_", "saturating_", "select"];
        let vector = name.strip_prefix(['i', 'u', 'd']).unwrap_or(name);
        let vector = vector.strip_prefix("vec").is_some_and(|size| matches!(size, "2" | "3" | "3a" | "4"));
        vector || KNOWN.contains(&name.as_str()) || KINDS.iter().any(|kind| name.starts_with(kind))
    })
}

/// What an accumulation's index is built upon.
fn candidate(kernel: &Kernel, node: usize) -> Option<Candidate> {
    let access = kernel.access(node);
    let found = |base: Option<&Expr>, reach| Some(Candidate { node, base: base.cloned(), reach });
    match &access.place {
        Place::Own => return found(None, Reach::All(0, 0)),
        Place::Offset(offset) => return found(None, Reach::Axes(offset.iter().map(|&o| (o, o)).collect())),
        Place::Places(_) | Place::Computed => {}
    }
    let around = kernel.nodes.iter().filter_map(|around| match around {
        Node::Unroll(repeat) if repeat.accesses.contains(&node) => Some(repeat),
        _ => None,
    });
    let mut unrolled = false;
    for repeat in around {
        unrolled = true;
        let Some((base, offset)) = split(kernel, repeat, &access.index) else { continue };
        let Some(axes) = reach(repeat, offset) else { continue };
        let reach = match (&repeat.axes, axes.as_slice()) {
            (Some(_), &[(low, high)]) => Reach::All(low, high),
            (None, _) if kernel.fields[access.field].rank.is_none_or(|rank| rank == axes.len()) => Reach::Axes(axes),
            _ => continue,
        };
        return found(Some(base), reach);
    }
    if unrolled {
        return None;
    }
    if let Expr::Binary(sum) = bare(&access.index)
        && matches!(sum.op, BinOp::Add(_))
        && name_of(&sum.left).is_some()
        && let Some(offset) = parts(&sum.right)
        && let Some(offset) = offset.into_iter().map(integer).collect::<Option<Vec<i32>>>()
    {
        return found(Some(&sum.left), Reach::Axes(offset.into_iter().map(|o| (o, o)).collect()));
    }
    found(Some(&access.index), Reach::All(0, 0))
}

/// The statements that a candidate depends on, and what it reads; none where they do more than that, or do not stand at the top of the body.
fn resolve(
    kernel: &Kernel,
    parallel: &Loop,
    plan: &Plan,
    candidate: &Candidate,
) -> Option<(Vec<Step>, BTreeSet<usize>)> {
    let Some(base) = &candidate.base else { return Some((Vec::new(), BTreeSet::new())) };
    let statements = &parallel.body.stmts;
    if statements.iter().any(|statement| matches!(statement, Stmt::Item(_))) {
        return None;
    }
    let mut reads = reads_of(kernel, plan, base)?;
    let local = |name: &Ident| parallel.bound.contains(name) && !parallel.variables.contains(&Some(name.clone()));
    let mut needed: BTreeSet<Ident> = mentioned(kernel, base).into_iter().filter(&local).collect();
    // A plain name may stand under conditions: its value is found whether they hold or not.
    let end = match name_of(base) {
        Some(_) => statements.len(),
        None => statements.iter().position(|statement| is_access(statement, candidate.node))?,
    };
    let (mut steps, mut begun) = (Vec::new(), name_of(base).is_none());
    for statement in statements[..end].iter().rev() {
        let bound = bound_by(statement);
        if bound.iter().any(|name| needed.contains(name)) {
            let Stmt::Local(local_statement) = statement else { return None };
            let init = local_statement.init.as_ref().filter(|init| init.diverge.is_none())?;
            let once = |name: &Ident| {
                parallel.bound.iter().filter(|bound| *bound == name).count() == 1
                    && !kernel.mutable.contains(&name.to_string())
            };
            if !bound.iter().all(once) || is_told_later(local_statement, &init.expr) {
                return None;
            }
            reads.append(&mut reads_of(kernel, plan, &init.expr)?);
            bound.iter().for_each(|name| {
                needed.remove(name);
            });
            needed.extend(mentioned(kernel, &init.expr).into_iter().filter(&local));
            steps.push(Step::Let(local_statement.clone()));
            begun = true;
        } else if begun && let Some(condition) = guard(kernel, statement) {
            reads.append(&mut reads_of(kernel, plan, condition)?);
            needed.extend(mentioned(kernel, condition).into_iter().filter(&local));
            steps.push(Step::Guard(condition.clone()));
        } else if begun && jumps(kernel, statement) {
            return None;
        }
    }
    steps.reverse();
    needed.is_empty().then_some((steps, reads))
}

/// `if condition { continue; }` of the parallel loop.
fn guard<'s>(kernel: &Kernel, statement: &'s Stmt) -> Option<&'s Expr> {
    let Stmt::Expr(Expr::If(branch), _) = statement else { return None };
    let [Stmt::Expr(jump, _)] = branch.then_branch.stmts.as_slice() else { return None };
    let jumps = node_of(jump).is_some_and(|node| matches!(kernel.nodes[node], Node::Jump(Jump::Element)));
    let plain = branch.else_branch.is_none() && !matches!(*branch.cond, Expr::Let(_));
    (jumps && plain).then_some(&*branch.cond)
}

/// Whether a statement is nothing but an access.
fn is_access(statement: &Stmt, node: usize) -> bool {
    matches!(statement, Stmt::Expr(expr, _) if node_of(expr) == Some(node))
}

/// The names that a statement binds for those after it.
fn bound_by(statement: &Stmt) -> Vec<Ident> {
    let mut bound = Vec::new();
    if let Stmt::Local(local) = statement {
        names(&local.pat, &mut |name, _| bound.push(name.clone()));
    }
    bound
}

/// Whether the type of what is bound may be told by what follows alone.
fn is_told_later(local: &Local, value: &Expr) -> bool {
    const OPEN: [&str; 9] = ["into", "try_into", "parse", "collect", "default", "Default", "sum", "product", "new"];
    struct Open(bool);
    impl Visit<'_> for Open {
        fn visit_ident(&mut self, name: &Ident) {
            self.0 |= OPEN.contains(&name.to_string().as_str());
        }
        fn visit_type_infer(&mut self, _: &syn::TypeInfer) {
            self.0 = true;
        }
    }
    // A literal has the type of what it is used with.
    let untyped = |expr: &Expr| {
        let mut names = false;
        struct Names<'n>(&'n mut bool);
        impl Visit<'_> for Names<'_> {
            fn visit_ident(&mut self, _: &Ident) {
                *self.0 = true;
            }
        }
        Names(&mut names).visit_expr(expr);
        !names
    };
    let shifted = matches!(bare(value), Expr::Binary(shift) if matches!(shift.op, BinOp::Shl(_) | BinOp::Shr(_)) && untyped(&shift.left));
    let typed = matches!(&local.pat, Pat::Type(typed) if !typed.ty.to_token_stream().to_string().contains('_'));
    let mut open = Open(false);
    open.visit_expr(value);
    (open.0 || shifted || untyped(value)) && !typed
}

/// The names in an expression, those of accesses' indices included.
fn mentioned<'a>(kernel: &'a Kernel, expr: &'a Expr) -> BTreeSet<Ident> {
    let mut walk = Walk::new(kernel);
    walk.visit_expr(expr);
    walk.names
}

/// The accesses in an expression that reads fields and variables and does nothing else that could be seen.
fn reads_of<'a>(kernel: &'a Kernel, plan: &Plan, expr: &'a Expr) -> Option<BTreeSet<usize>> {
    let mut walk = Walk::new(kernel);
    walk.visit_expr(expr);
    let mut reads = BTreeSet::new();
    for &node in &walk.nodes {
        match &kernel.nodes[node] {
            Node::Access(access) if is_read(access) => {
                let view = &plan.views[*plan.view_of.get(&node)?].view;
                if matches!(view, View::Accumulate | View::Together | View::AccumulateTogether) {
                    return None;
                }
                reads.insert(node);
            }
            Node::FieldCall(_) => {}
            _ => return None,
        }
    }
    (!walk.other).then_some(reads)
}

/// The accesses in an expression.
fn accesses<'a>(kernel: &'a Kernel, expr: &'a Expr) -> BTreeSet<usize> {
    let mut walk = Walk::new(kernel);
    walk.visit_expr(expr);
    walk.nodes.into_iter().filter(|&node| matches!(kernel.nodes[node], Node::Access(_))).collect()
}

fn is_read(access: &Access) -> bool {
    matches!(access.action, Action::Read) && !matches!(access.boundary, Boundary::Lent)
}

/// Whether a statement ends its iteration.
fn jumps<'a>(kernel: &'a Kernel, statement: &'a Stmt) -> bool {
    let mut walk = Walk::new(kernel);
    walk.visit_stmt(statement);
    walk.nodes.iter().any(|&node| matches!(kernel.nodes[node], Node::Jump(Jump::Element)))
}

/// What an expression is made of.
struct Walk<'a> {
    kernel: &'a Kernel,
    names: BTreeSet<Ident>,
    nodes: Vec<usize>,
    /// What is called.
    calls: Vec<String>,
    /// Whether there is anything that does more than to compute a value.
    other: bool,
}

impl<'a> Walk<'a> {
    fn new(kernel: &'a Kernel) -> Self {
        Self { kernel, names: BTreeSet::new(), nodes: Vec::new(), calls: Vec::new(), other: false }
    }

    fn block(&mut self, block: &'a Block) {
        block.stmts.iter().for_each(|statement| self.visit_stmt(statement));
    }
}

impl<'a> Visit<'a> for Walk<'a> {
    fn visit_expr(&mut self, expr: &'a Expr) {
        let kernel = self.kernel;
        if let Some(node) = node_of(expr) {
            self.nodes.push(node);
            match &kernel.nodes[node] {
                Node::Access(access) => {
                    Walk::visit_expr(self, &access.index);
                    if let Boundary::Or(value) = &access.boundary {
                        Walk::visit_expr(self, value);
                    }
                }
                Node::Unroll(repeat) => self.block(&repeat.body),
                Node::Macro(call) => match &call.arguments {
                    MacroArguments::List(list) => list.iter().for_each(|argument| Walk::visit_expr(self, argument)),
                    MacroArguments::Repeat(value, count) => {
                        Walk::visit_expr(self, value);
                        Walk::visit_expr(self, count);
                    }
                    MacroArguments::Matches { value, .. } => Walk::visit_expr(self, value),
                },
                _ => {}
            }
            return;
        }
        match expr {
            Expr::Call(call) => self.calls.push(match &*call.func {
                // A vector's constructor goes by its type.
                Expr::Path(path) => {
                    let mut words = path.path.segments.iter().rev().map(|segment| segment.ident.to_string());
                    match (words.next(), words.next()) {
                        (Some(name), Some(of)) if name == "new" => of.to_lowercase(),
                        (name, _) => name.unwrap_or_default(),
                    }
                }
                _ => String::new(),
            }),
            Expr::MethodCall(call) => self.calls.push(call.method.to_string()),
            Expr::Path(path) => self.names.extend(path.path.get_ident().cloned()),
            Expr::Return(_) | Expr::Break(_) | Expr::Continue(_) | Expr::Try(_) | Expr::Await(_) | Expr::Assign(_) => {
                self.other = true;
            }
            Expr::Macro(_) | Expr::Unsafe(_) | Expr::Verbatim(_) => self.other = true,
            _ => {}
        }
        visit::visit_expr(self, expr);
    }
}
