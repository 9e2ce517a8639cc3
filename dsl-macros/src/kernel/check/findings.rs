//! What was found on the way: most of it concerns single expressions.

use super::{loops, variables};
use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Finding, Kernel, What};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for finding in &kernel.findings {
        if !loops::report(finding, diagnostics) && !variables::report(finding, diagnostics) {
            elements(kernel, finding, diagnostics);
        }
    }
}

/// Fields, members and elements in places where they cannot stand.
fn elements(kernel: &Kernel, finding: &Finding, diagnostics: &mut Diagnostics) {
    let at = &finding.spot.tokens;
    let text = finding.spot.text();
    match &finding.what {
        What::BareMember { field, in_loop } => {
            let name = &kernel.fields[*field].name;
            let error = diagnostics.error(Code::Alias, at, format!("`{text}` needs an index"));
            error.note("a member is reached one element at a time");
            if *in_loop {
                error.help(format!("write `{text}[..]`"));
            } else {
                error.help(format!("write `{text}[..]`, or `{name}.members()` for whole members outside of loops"));
            }
        }
        // Its name is bound again, which is told: what stands here is no field to the user.
        What::BareField { field } if kernel.bound.contains(&kernel.fields[*field].name) => {}
        What::BareField { field } => {
            let name = &kernel.fields[*field].name;
            diagnostics
                .error(Code::HandedOn, at, format!("the field `{name}` can only be indexed inside a parallel loop"))
                .note("the loop holds the field, and finds what each iteration touches by the indices")
                .help(format!("write `{name}[..]`; `{name}.len()` and `{name}.shape()` may be asked as well"));
        }
        What::Alias => {
            diagnostics
                .error(Code::Alias, at, format!("`{text}` cannot be bound to a variable"))
                .note("the kernel finds accesses by the names of its fields, and would not see those through the variable")
                .help(format!("write `{}[..]` at each use, or bind one element's value", bare(&text)));
        }
        What::Argument { function } => {
            diagnostics
                .error(Code::HandedOn, at, format!("`{text}` cannot be handed to `{function}` inside a parallel loop"))
                .note("a function that reads a member takes it by value, as `Read<f32, _>`, and is marked `#[func]`")
                .help(format!("write `{}`; or read the values first and hand those on: `{0}[..]`", bare(&text)));
        }
        What::FieldMethod { field, name } => {
            let field = &kernel.fields[*field].name;
            let error = diagnostics
                .error(Code::FieldMethod, at, format!("`{field}.{name}` cannot be called inside a parallel loop"))
                .note("the loop holds the field until it ends");
            let instead = match name.as_str() {
                "clear" | "prune" => {
                    format!("call it before or after the loop; inside, `{field}.deactivate(..)` is for single elements")
                }
                "retain" | "truncate" => {
                    format!("call it before or after the loop; inside, `{field}.remove(..)` is for single entries")
                }
                "row" => format!("write `for q in {field}.row(..)`, which is what loops take"),
                _ => {
                    format!("call it before or after the loop; inside, elements are read and written as `{field}[..]`")
                }
            };
            error.help(instead);
        }
        What::TopologyArguments { field, name, takes, example } => {
            diagnostics
                .error(Code::IndexCount, at, format!("`{field}.{name}` takes {takes}"))
                .note("an index over several axes is one tuple or one vector; that of a list leaves out the entries' axis")
                .help(format!("write `{field}.{name}({example})`"));
        }
        What::MemberAppend { field, name } => {
            let field = &kernel.fields[*field].name;
            diagnostics
                .error(
                    Code::MemberAppend,
                    at,
                    format!("`{text}` names a member, and the entries of lists are whole records"),
                )
                .help(format!("write `{field}.{name}(..)`"));
        }
        What::BoundaryArguments { field, name } => {
            let (takes, example) = match name.as_str() {
                "or" | "set_unchecked" => ("an index and a value", "(i, j), 0.0"),
                _ => ("one index", "(i, j)"),
            };
            diagnostics
                .error(Code::IndexCount, at, format!("`{field}.{name}` takes {takes}"))
                .note("an index over several axes is one tuple or one vector")
                .help(format!("write `{field}.{name}({example})`"));
        }
        What::Exchange { part: true, name, .. } => {
            diagnostics
                .error(
                    Code::OldValueForm,
                    at,
                    format!("`{name}` takes a whole member, and `{text}` names a part of one"),
                )
                .note("the old value is taken in one step, which is possible for one integer")
                .help(
                    "make the part a member of its own; or, where the old value is not needed, accumulate: `+=`, `|=`",
                );
        }
        What::Exchange { name, takes, .. } => {
            let (takes, example) =
                if *takes == 1 { ("one value", "1") } else { ("the current value and the new one", "0, 1") };
            diagnostics
                .error(Code::OldValueForm, at, format!("`{name}` takes {takes}"))
                .note("unlike atomic variables, elements take no `Ordering`: their operations come in any order")
                .help(format!("write `{name}({example})`"));
        }
        What::AssignmentValue { text, accumulates } => {
            let error = diagnostics.error(Code::AccumulateValue, at, format!("`{text}` has no value"));
            if *accumulates {
                error
                    .note("an accumulation may be put off until the loop ends, so that there is no old value")
                    .help("write the accumulation as a statement")
                    .help("where the old value of an integer is needed, as for places in a list, `fetch_add` and its like return it");
            } else {
                error.help("write the assignment as a statement");
            }
        }
        What::Destructuring => {
            diagnostics
                .error(Code::Destructuring, at, "an element cannot be a target of a destructuring assignment")
                .help(
                    "bind the values first, and assign each element by itself: `let (a, b) = ..; u[i] = a; v[i] = b;`",
                );
        }
        What::MoveClosure => {
            diagnostics
                .error(Code::MoveClosure, at, "a `move` closure inside a parallel loop cannot access fields")
                .note("it would take the loop's hold on them away from the next element")
                .help("remove `move`, or read the values before the closure");
        }
        _ => unreachable!("loops and variables are judged elsewhere"),
    }
}

/// The name behind `&`, `&mut` and `*`.
fn bare(text: &str) -> &str {
    match text.trim_start_matches(['&', '*', ' ']) {
        inner if inner.len() == text.len() => text.strip_prefix("mut ").map_or(text, bare),
        inner => bare(inner),
    }
}
