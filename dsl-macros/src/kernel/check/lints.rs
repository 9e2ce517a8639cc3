//! Warnings: what compiles and is likely to be a mistake.

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Kernel, Suspicion};
use crate::kernel::text::type_text;

/// The bodies that `unroll!` may write out without a warning.
const MANY_BODIES: u64 = 256;

/// The bodies that it may write out at all: with more the compiler runs for minutes, or out of memory.
const MOST_BODIES: u64 = 65_536;

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for (place, suspicion) in kernel.suspicions.iter().enumerate() {
        match suspicion {
            Suspicion::Remainder { left, whole } => {
                let (left, whole_text) = (left.text(), whole.text());
                let bare = left.trim_start_matches('(').trim_end_matches(')');
                diagnostics
                    .warn(Code::NegativeRemainder, &whole.tokens, format!("`{whole_text}` is negative where `{bare}` is"))
                    .note("Rust's `%` has the sign of its left side: -1 % 5 is -1, not 4")
                    .help(format!(
                        "write `({bare}).rem_euclid(..)`, or read with `.wrapped(..)`, which takes indices modulo the extents"
                    ));
            }
            Suspicion::Unrolled { around, bodies, at } if *bodies > MOST_BODIES => {
                if *around <= MOST_BODIES {
                    diagnostics
                        .error(
                            Code::UnrollForm,
                            &at.tokens,
                            format!("the body of this loop would be written out {bodies} times, and can be {MOST_BODIES} times at most"),
                        )
                        .note("the compiler would run for minutes, or out of memory")
                        .help("write a plain `for` over the range");
                }
            }
            Suspicion::Unrolled { around, bodies, at } if *around <= MANY_BODIES && *bodies > MANY_BODIES => {
                diagnostics
                    .warn(Code::LargeUnroll, &at.tokens, format!("the body of this loop is written out {bodies} times"))
                    .note("it takes long to compile, and does not fit into the processor's caches of instructions")
                    .help("unroll the inner axes alone, and write a plain `for` for the outer ones");
            }
            Suspicion::Unrolled { .. } => {}
            Suspicion::Random { parallel, arguments, call } => {
                let first = kernel.suspicions[..place].iter().find_map(|earlier| match earlier {
                    Suspicion::Random { parallel: other, arguments: same, call }
                        if other == parallel && same.text() == arguments.text() =>
                    {
                        Some(call.line())
                    }
                    _ => None,
                });
                if let Some(line) = first {
                    diagnostics
                        .warn(
                            Code::EqualRandom,
                            &call.tokens,
                            format!("`{}` gives the same number as the call in line {line}", call.text()),
                        )
                        .note("a random number is a function of its seed and its key")
                        .help("number the draws in the key: `random(seed, (p, 0))`, `random(seed, (p, 1))`");
                }
            }
        }
    }
    only_read(kernel, diagnostics);
}

/// Fields taken by `&mut` of which no element is changed.
fn only_read(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for (number, field) in kernel.fields.iter().enumerate() {
        let mut accesses = kernel.accesses().filter(|access| access.field == number).peekable();
        if !field.mutable || kernel.handed_on.contains(&number) || accesses.peek().is_none() {
            continue;
        }
        let changed =
            kernel.loops.iter().flat_map(|found| &found.topology).any(|t| t.field == number && t.call.changes());
        if !changed && accesses.all(|access| !access.changes()) {
            let name = &field.name;
            diagnostics
                .warn(Code::OnlyRead, name, format!("the kernel only reads `{name}`, and takes it by `&mut`"))
                .note("callers must then hold the field alone, for nothing")
                .help(format!(
                    "write `{name}: {}`, or change an element: a value that is read is a copy",
                    type_text(&field.ty).replacen("&mut ", "&", 1)
                ));
        }
    }
}
