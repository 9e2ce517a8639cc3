//! Loop heads, attributes, jumps and `unroll!`.

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Finding, Upon, What};

/// Reports a finding about a loop; `false` if it is about something else.
pub(super) fn report(finding: &Finding, diagnostics: &mut Diagnostics) -> bool {
    let at = &finding.spot.tokens;
    let text = finding.spot.text();
    match &finding.what {
        What::Head { upon } => head(finding, upon, diagnostics),
        What::InclusiveRange { start, end } => {
            let end = end.parse::<i64>().map_or_else(|_| format!("{end} + 1"), |end| (end + 1).to_string());
            diagnostics
                .error(Code::LoopRange, at, format!("a loop of the language runs over half-open ranges, not `{text}`"))
                .help(format!("write `{start}..{end}`"));
        }
        What::OpenRange => {
            diagnostics
                .error(Code::LoopRange, at, format!("the range `{text}` has no start or no end"))
                .help("write both: `0..n`");
        }
        What::RowHead => {
            diagnostics
                .error(Code::RowHead, at, format!("a loop over `{text}` is a serial one, inside of another"))
                .note("an outermost `for` is one parallel launch, and a list has one order")
                .help("loop over the lists, and over the entries of each inside; or write `#[serial]` before the loop");
        }
        What::MemberHead => {
            diagnostics
                .error(Code::LoopHead, at, format!("a loop runs over a field, not over its member `{text}`"))
                .help(format!("write `for .. in {}`", text.split('.').next().unwrap_or_default()));
        }
        What::OutermostUnroll => {
            diagnostics
                .error(Code::LoopHead, at, "`unroll!` is for loops inside a parallel loop")
                .note("an outermost `for` is one parallel launch")
                .help("loop over a range, `0..n`, or over `ndrange!(..)`; or write `#[serial]` before the loop");
        }
        What::Pattern => {
            diagnostics
                .error(
                    Code::LoopPattern,
                    at,
                    format!("the pattern of a parallel loop is a name or a tuple of names, not `{text}`"),
                )
                .note("the kernel must know which index is the iteration's own")
                .help("write `for p in ..` or `for (i, j) in ..`, and bind anything else with `let` inside");
        }
        What::RelaxedPlace => {
            diagnostics
                .error(Code::RelaxedPlace, at, "`#[relaxed]` goes on a parallel loop")
                .note("a serial loop, or one inside another loop, meets no other iteration: any access may stand in it")
                .help("remove it, or move it to the outermost `for`");
        }
        What::ScatterName { found } => {
            let message = match found.as_str() {
                "" => "`#[scatter]` needs the name of a schedule".to_owned(),
                other => format!("`{other}` is no schedule for accumulation"),
            };
            diagnostics
                .error(Code::ScatterAttribute, at, message)
                .help("write `#[scatter(Serial)]`, `#[scatter(Private)]`, `#[scatter(Colored)]`, `#[scatter(Atomic)]` or `#[scatter(Auto)]`");
        }
        What::ScatterOption { schedule } => {
            let error = diagnostics.error(
                Code::ScatterAttribute,
                at,
                format!("`{schedule}` takes no `{text}` in `#[scatter(..)]`"),
            );
            let note = match schedule.as_str() {
                "Colored" => "`key` says where an iteration accumulates, `reach` how far around there, each once",
                _ => "`key` and `reach` are for `Colored` alone, which sorts iterations by where they accumulate",
            };
            error.note(note).help("write `#[scatter(Colored, key = cell(points.x[p]), reach = 2)]`");
        }
        What::ScatterKey => {
            diagnostics
                .error(Code::ScatterAttribute, at, format!("a key only reads, and `{text}` does more"))
                .note("keys are found before the loop runs, each by itself: nothing may change meanwhile")
                .help("give the index alone, `key = cell(points.x[p])`, and leave the rest to the loop's body");
        }
        What::ScatterReach => {
            diagnostics
                .error(Code::ScatterAttribute, at, format!("`reach` is a whole number of cells, and `{text}` is none"))
                .note("tiles are cut before the loop runs: two of one colour must lie further apart than their updates reach")
                .help("write a literal: `reach = 2`");
        }
        What::ScatterPlace => {
            diagnostics
                .error(Code::ScatterAttribute, at, "`#[scatter(..)]` goes on a parallel loop")
                .note("a serial loop, or one inside another loop, adds in place and needs no schedule")
                .help("remove it, or move it to the outermost `for`");
        }
        What::Escape { how } => escape(finding, how, diagnostics),
        What::UnrollBound => {
            diagnostics
                .error(Code::UnrollForm, at, format!("`unroll!` needs integer literals, and `{text}` is none"))
                .note("the macro copies the body once for each value, and sees no values of constants")
                .help("write the number, or a plain `for` over the range");
        }
        What::UnrollPattern { ranges } => {
            let (count, cure) = match ranges {
                1 => ("one range".to_owned(), "one name".to_owned()),
                ranges => (format!("{ranges} ranges"), format!("a tuple of {ranges} names")),
            };
            diagnostics
                .error(Code::UnrollForm, at, format!("`unroll!` goes over {count}, which `{text}` does not fit"))
                .help(format!("write {cure}"));
        }
        What::UnrollEscape { how } => {
            diagnostics
                .error(Code::UnrollForm, at, format!("`{how}` cannot leave a loop over `unroll!(X, ..)`"))
                .note("how many axes there are is not known before the kernel is used, so that the body stands in a closure")
                .help("`continue` goes on to the next index; keep a flag to skip the rest, or name the axes: `unroll!(0..3, 0..3)`");
        }
        What::HeadArguments { name } => {
            let counts = !text.is_empty() && !text.contains(['.', '(', '[', '{']);
            let ranges = if counts { format!("0..{}", text.replace(", ", ", 0..")) } else { "0..3, 0..3".to_owned() };
            diagnostics
                .error(Code::HeadMacro, at, format!("`{name}!` takes ranges"))
                .help(format!("write `{name}!({ranges})`"));
        }
        What::HeadMacro { name } => {
            diagnostics
                .error(Code::HeadMacro, at, format!("`{name}!` can only be the head of a loop"))
                .help(format!("write `for (i, j) in {name}!(0..3, 0..3) {{ .. }}`"));
        }
        _ => return false,
    }
    true
}

fn head(finding: &Finding, upon: &Upon, diagnostics: &mut Diagnostics) {
    let at = &finding.spot.tokens;
    let text = finding.spot.text();
    let error = diagnostics.error(Code::LoopHead, at, format!("a parallel loop cannot run over `{text}`"));
    error.note(
        "each outermost `for` of a kernel is a parallel launch, and runs over a field, its `interior(width)`, `border(width)`, `checkerboard(colour)` or `colored(n, colour)`, a range `a..b` or `ndrange!(..)`",
    );
    match upon {
        Upon::Range => error.help("loop over the range itself and compute the index inside"),
        Upon::Part => error.help(
            "a part takes what stands in its parentheses, and a colour comes last: `u.interior(1).checkerboard(0)`",
        ),
        Upon::Field(name) => error.help(format!("to loop over the field, write `for .. in {name}`")),
        Upon::Name => error
            .help(format!("if it is a number, write `0..{text}`"))
            .help("if it is a field, write its parameter's type as `&Field<..>` or `&mut Field<..>`"),
        Upon::Other => error.help("to use each of some values, loop over a range and look them up inside: `ids[k]`"),
    };
    error.help("to run over any iterator on one thread, write `#[serial]` before the loop");
}

fn escape(finding: &Finding, how: &str, diagnostics: &mut Diagnostics) {
    let message = format!("`{how}` cannot leave a parallel loop");
    let error = diagnostics.error(Code::LoopEscape, &finding.spot.tokens, message);
    error.note("other threads are at other elements at that time");
    match how {
        "?" => error.help("deal with the error here, or note it in a variable (`failed |= true`) and test that after the loop"),
        ".await" => error.help("wait before or after the loop"),
        "continue" => error.help("`continue` without a label skips the rest of the element"),
        _ => error.help(
            "`continue` skips the rest of the element; to search, accumulate into a variable (`found.max_assign(..)`); or write `#[serial]` before the loop",
        ),
    };
}
