//! Variables of the top level in a parallel loop.

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Assigned, Finding, What};

/// Reports a finding about a variable; `false` if it is about something else.
pub(super) fn report(finding: &Finding, diagnostics: &mut Diagnostics) -> bool {
    let at = &finding.spot.tokens;
    let text = finding.spot.text();
    match &finding.what {
        What::OuterAssigned { name, how } => match how {
            Assigned::Plain => {
                diagnostics
                    .error(Code::OuterAssigned, at, format!("`{name}` is assigned by all iterations of a parallel loop"))
                    .note("which of them comes last depends on the threads")
                    .help(format!("bind a variable inside the loop with `let`, or accumulate: `{name} += ..`, `{name}.max_assign(..)`"));
            }
            Assigned::Operator(op) => {
                diagnostics
                    .error(
                        Code::OuterAssigned,
                        at,
                        format!("`{}` cannot accumulate into `{name}` in a parallel loop", op.text()),
                    )
                    .note("its result depends on the order of the iterations")
                    .help("use one of `+=`, `-=`, `*=`, `min_assign`, `max_assign`, `&=`, `|=`, `^=`");
            }
            Assigned::Reference => {
                diagnostics
                    .error(
                        Code::OuterAssigned,
                        at,
                        format!("`{text}` changes what `{name}` refers to from a parallel loop"),
                    )
                    .note("all iterations would share it")
                    .help("accumulate into a local variable of the kernel, and assign that after the loop");
            }
        },
        What::ReductionRead { name } => {
            diagnostics
                .error(Code::ReductionRead, at, format!("`{name}` is read in the loop that accumulates into it"))
                .note("there is only a part of the result, and which part depends on the threads")
                .help(format!("read `{name}` after the loop; within it, keep what you need in a variable of its own"));
        }
        What::ReductionParts { name, line } => {
            diagnostics
                .error(
                    Code::ReductionPart,
                    at,
                    format!("`{text}` accumulates into more or less of a tuple than another accumulation of the loop"),
                )
                .note(format!(
                    "the other one into `{name}` stands in line {line}; each entry of a tuple is a reduction of its own"
                ))
                .help("accumulate into entries alone, or into the whole alone");
        }
        What::ReductionGroups { name, op, first, line } => {
            let (op, first) = (op.text(), first.text());
            diagnostics
                .error(
                    Code::ReductionOperators,
                    at,
                    format!("`{op}` and `{first}` accumulate into `{name}` in one loop"),
                )
                .note(format!(
                    "`{first}` stands in line {line}; the result of both depends on the order of the iterations"
                ))
                .help("use two variables, or two loops");
        }
        _ => return false,
    }
    true
}
