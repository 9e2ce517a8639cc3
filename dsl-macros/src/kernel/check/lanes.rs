//! What loops in lanes may do: `#[kernel(lanes = 16)]`.

use syn::{Block, Expr, Local, Stmt};

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::lanes::{Cut, WIDTHS, cut, is_cut};
use crate::kernel::model::{Action, Kernel, Loop, Place};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    let Some(width) = &kernel.lanes else { return };
    if !width.lanes.is_some_and(|lanes| WIDTHS.contains(&lanes)) {
        diagnostics
            .error(Code::KernelOption, &width.spot.tokens, "the number of lanes is 4, 8, 16, 32 or 64")
            .note("a vector register holds 4 to 16 numbers of 32 bits, and several are worked on at once")
            .help("write `#[kernel(lanes = 16)]`");
    }
    let mut cuts = false;
    for parallel in kernel.loops.iter().filter(|parallel| is_cut(&parallel.body)) {
        cuts = true;
        judge(kernel, parallel, diagnostics);
    }
    if !cuts {
        diagnostics
            .error(Code::Lanes, &width.spot.tokens, "nothing in this kernel runs in lanes")
            .note("lanes are for parallel loops with `for` or `while` loops inside of them, that are left at their ends alone: all others become vectors by themselves, or cannot")
            .help("write `#[kernel]`; or state what ends an inner loop in its head instead of by `break`");
    }
}

fn judge(kernel: &Kernel, parallel: &Loop, diagnostics: &mut Diagnostics) {
    if parallel.continues {
        diagnostics
            .error(Code::Lanes, &parallel.spot.tokens, "a loop in lanes cannot leave an iteration early")
            .note("its iterations go through each stretch of the body together")
            .help("put what `continue` passes by into an `if`");
    }
    for &node in &parallel.accesses {
        let access = kernel.access(node);
        let what = match (&access.action, &access.place) {
            (Action::Exchange { .. }, _) => "take old values of a field",
            (Action::Update { .. }, place) if !matches!(place, Place::Own) => "accumulate into a field",
            _ => continue,
        };
        diagnostics
            .error(Code::Lanes, &access.spot.tokens, format!("a loop in lanes cannot {what}"))
            .note("its iterations go through each stretch of the body together, so that the order would depend on how many lanes there are")
            .help("sum up in a variable of the body, and accumulate in a loop of its own, or remove `lanes`");
    }
    for topology in parallel.topology.iter().filter(|topology| topology.call.changes()) {
        let message = format!("a loop in lanes cannot call `{}`", topology.method);
        diagnostics
            .error(Code::Lanes, &topology.spot.tokens, message)
            .note("its iterations go through each stretch of the body together, so that the order would depend on how many lanes there are")
            .help("call it in a loop of its own, or remove `lanes`");
    }
    for reduction in parallel.reductions.iter().filter(|reduction| reduction.by_parts) {
        let message = format!("a loop in lanes cannot accumulate into a part of `{}`", reduction.name);
        diagnostics
            .error(Code::Lanes, &reduction.first.1.tokens, message)
            .note("its iterations go through each stretch of the body together, so that the order would depend on how many lanes there are")
            .help("accumulate into a variable of its own, or into the whole of it");
    }
    declarations(&parallel.body, diagnostics);
}

/// Variables without a value, in blocks that are cut.
fn declarations(block: &Block, diagnostics: &mut Diagnostics) {
    if !is_cut(block) {
        return;
    }
    for statement in &block.stmts {
        if let Stmt::Local(Local { init: None, .. }) = statement {
            diagnostics
                .error(Code::Lanes, statement, "a variable of a loop in lanes needs a value from the start")
                .note("it is kept for all lanes from one stretch of the body to the next")
                .help("write a value: `let x = 0.0;`");
        }
        match cut(statement) {
            Cut::No => {}
            Cut::For(inner) => declarations(&inner.body, diagnostics),
            Cut::While(inner) => declarations(&inner.body, diagnostics),
            Cut::If(branch) => {
                declarations(&branch.then_branch, diagnostics);
                let mut other = branch.else_branch.as_ref();
                while let Some((_, expr)) = other {
                    other = match &**expr {
                        Expr::Block(block) => {
                            declarations(&block.block, diagnostics);
                            None
                        }
                        Expr::If(branch) => {
                            declarations(&branch.then_branch, diagnostics);
                            branch.else_branch.as_ref()
                        }
                        _ => None,
                    };
                }
            }
        }
    }
}
