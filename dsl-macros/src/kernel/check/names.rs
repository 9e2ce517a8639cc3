//! Names that must mean one thing, and macros that could change what they mean.

use syn::Ident;

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Kernel, Loop};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for name in kernel.bound.iter().chain(kernel.loops.iter().flat_map(|found| found.variables.iter().flatten())) {
        if kernel.fields.iter().any(|field| field.name == *name) {
            rebinding(name, "a field of this kernel", diagnostics);
        }
    }
    for found in &kernel.loops {
        for name in &found.bound {
            if found.variables.contains(&Some(name.clone())) {
                rebinding(name, "a variable of the parallel loop around it", diagnostics);
            } else if found.reductions.iter().any(|reduction| reduction.name == *name) {
                rebinding(name, "accumulated into by the parallel loop around it", diagnostics);
            }
        }
        macros(kernel, found, diagnostics);
    }
}

fn rebinding(name: &Ident, what: &str, diagnostics: &mut Diagnostics) {
    diagnostics
        .error(Code::Rebinding, name, format!("`{name}` is {what} and cannot be bound again"))
        .note("the kernel tells accesses apart by the names in them")
        .help("choose another name");
}

fn macros(kernel: &Kernel, found: &Loop, diagnostics: &mut Diagnostics) {
    for call in &found.macros {
        let named = |name: &&Ident| {
            kernel.fields.iter().any(|field| field.name == **name)
                || found.variables.contains(&Some((*name).clone()))
                || found.reductions.iter().any(|reduction| reduction.name == **name)
        };
        let Some(name) = call.mentions.iter().find(named) else { continue };
        if call.definition {
            diagnostics
                .error(
                    Code::MacroDefinition,
                    &call.spot.tokens,
                    format!("a macro defined in a parallel loop mentions `{name}`"),
                )
                .note("the kernel does not see what the macro expands to, which could be another access")
                .help("write a closure or a function on values instead");
        } else {
            let message = format!("`{name}` is handed to the macro `{}!`, which the kernel does not know", call.name);
            diagnostics
                .error(Code::OpaqueMacro, &call.spot.tokens, message)
                .note("the macro could bind the name again, or hide an access")
                .help("bind the value with `let` first, and hand that to the macro; or call a function");
        }
    }
}
