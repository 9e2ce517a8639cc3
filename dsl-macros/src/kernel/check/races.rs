//! Races: what two iterations of a parallel loop may not do to one element.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::access::{Across, Clash, Use, Why, across, clashes};
use crate::kernel::model::{Access, Head, Kernel, Loop, Op, Place};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for (number, found) in kernel.loops.iter().enumerate() {
        // What an index means is unknown where the head is wrong, or names more or fewer axes than there are.
        if matches!(found.head, Head::Invalid) || miscounted(kernel, found) {
            continue;
        }
        let clashes = clashes(kernel, number);
        if let Some(clash) = clashes.first().filter(|_| is_serial(kernel, found)) {
            outermost(kernel, found, clash, diagnostics);
            continue;
        }
        for clash in &clashes {
            report(kernel, number, clash, diagnostics);
        }
    }
}

/// Whether a loop names more or fewer variables than its field has axes, which is told elsewhere.
fn miscounted(kernel: &Kernel, found: &Loop) -> bool {
    let rank = found.head.field().and_then(|field| kernel.fields[field].rank);
    found.tuple && rank.is_some_and(|rank| rank != found.variables.len())
}

/// Whether a loop was meant to take its turns one after another: a range whose variable is in no index, around other loops.
fn is_serial(kernel: &Kernel, found: &Loop) -> bool {
    let own = |node: &usize| !matches!(kernel.access(*node).place, Place::Computed);
    matches!(found.head, Head::Ranges(_)) && !found.inner.is_empty() && !found.accesses.iter().any(own)
}

fn outermost(kernel: &Kernel, found: &Loop, clash: &Clash, diagnostics: &mut Diagnostics) {
    let access = kernel.access(clash.access);
    let changed = if access.changes() { access } else { kernel.access(clash.other) };
    let (head, text, line) = (found.spot.text(), changed.target.text(), changed.spot.line());
    let inner = found.inner.first().map(|inner| inner.spot.text()).unwrap_or_default();
    diagnostics
        .error(Code::OutermostLoop, &found.spot.tokens, format!("`{head}` is the outermost loop, and so the parallel one"))
        .note(format!("its turns would run at the same time, and `{text}` in line {line} would be changed by all of them"))
        .help(format!(
            "to run `{inner}` in parallel, turn after turn, write `#[ordered]` before the loop: the `for` loops in its body are then launches"
        ))
        .help("to run everything on one thread, write `#[serial]` before the loop");
}

/// `field.path`.
fn name(kernel: &Kernel, access: &Access) -> String {
    let path: String = access.path.iter().map(|member| format!(".{member}")).collect();
    format!("{}{path}", kernel.fields[access.field].name)
}

/// What an access does, and where: the other half of a clash.
fn other_half(other: &Access) -> String {
    let done = match other.usage() {
        Use::Read => "is read",
        Use::Write => "is written",
        Use::Update(_, Some(_)) => "is accumulated into",
        Use::Update(_, None) => "is changed",
        Use::Exchange => "returns its old value",
    };
    format!("`{}` {done} in line {}", other.target.text(), other.spot.line())
}

/// A member is handed to a function that may read it at any index, and the loop changes it.
fn handed_on(kernel: &Kernel, lent: &Access, other: &Access, diagnostics: &mut Diagnostics) {
    let (text, changed) = (lent.target.text(), name(kernel, other));
    diagnostics
        .error(
            Code::HandedOn,
            &lent.target.tokens,
            format!("`{text}` cannot be handed to a function in a parallel loop that changes `{changed}`"),
        )
        .note(format!("{}, and the function may read it at any index", other_half(other)))
        .help(format!("read the values first and hand those on: `{text}[..]`; or write to another field"));
}

fn report(kernel: &Kernel, number: usize, clash: &Clash, diagnostics: &mut Diagnostics) {
    let found = &kernel.loops[number];
    let (access, other) = (kernel.access(clash.access), kernel.access(clash.other));
    let (member, target) = (name(kernel, access), access.target.text());
    if let Some((lent, other)) = [(access, other), (other, access)].into_iter().find(|(lent, _)| lent.is_lent()) {
        return handed_on(kernel, lent, other, diagnostics);
    }
    match clash.why {
        Why::Scatter => scatter(found, access, diagnostics),
        Why::OperatorScatter => operator(access, diagnostics),
        Why::Stencil => stencil(kernel, number, clash, diagnostics),
        Why::ReadBesideAccumulation => {
            let message = if access.changes() {
                format!("`{target}` is accumulated into in a parallel loop that reads `{}`", name(kernel, other))
            } else {
                format!("`{target}` is read in a parallel loop that accumulates into `{}`", name(kernel, other))
            };
            diagnostics
                .error(Code::AccumulateBesideRead, &access.spot.tokens, message)
                .note(format!(
                    "{}: what is read would be a part of the result, and which part depends on the threads",
                    other_half(other)
                ))
                .help("read it in a loop of its own before or after this one, or accumulate into another member");
        }
        Why::WriteBesideAccumulation => {
            diagnostics
                .error(
                    Code::AccumulateBesideWrite,
                    &access.spot.tokens,
                    format!(
                        "`{target}` is changed in a parallel loop that changes `{}` in another way",
                        name(kernel, other)
                    ),
                )
                .note(format!("{}: which of the two comes first depends on the threads", other_half(other)))
                .help("write the start value in a loop of its own, and accumulate in the next");
        }
        Why::Groups => groups(access, other, &member, diagnostics),
        Why::OldValue => {
            diagnostics
                .error(
                    Code::OldValueBeside,
                    &access.spot.tokens,
                    format!("`{target}` is used in a parallel loop that takes old values of `{}`", name(kernel, other)),
                )
                .note(format!("{}: what this access meets would depend on the threads", other_half(other)))
                .help("take what it returns: `fetch_add(0)` reads; or use the values in a loop of its own, before or after")
                .help("or write `#[relaxed]` before the loop, where any order will do");
        }
        Why::RelaxedOperator => {
            let Use::Update(op, _) = access.usage() else { return };
            let op = op.text();
            let error = diagnostics.error(
                Code::OperatorScatter,
                &access.spot.tokens,
                format!("`{op}` is no accumulation, and other iterations change `{target}`"),
            );
            error.note("between reading and writing the element, what another iteration does to it would be lost");
            if op == "/=" {
                error.help(format!("multiply by the inverse: `{target} *= 1.0 / ..`"));
            }
            error.help("accumulate with one of `+=`, `-=`, `*=`, `min_assign`, `max_assign`, `&=`, `|=`, `^=`, which stay one step");
        }
        Why::Places => {
            diagnostics
                .error(Code::OwnPlaces, &access.spot.tokens, format!("`{target}` and `{}` have the loop's variables in different places", other.target.text()))
                .note(format!("{}: two iterations could meet in one element", other_half(other)))
                .help("use one order of the variables for all accesses to a member that the loop writes; or make two loops of it, or write to another field");
        }
    }
}

fn stencil(kernel: &Kernel, number: usize, clash: &Clash, diagnostics: &mut Diagnostics) {
    let (access, other) = (kernel.access(clash.access), kernel.access(clash.other));
    let error = diagnostics.error(
        Code::InPlaceStencil,
        &access.spot.tokens,
        format!("`{}` is read in a parallel loop that writes `{}`", access.target.text(), name(kernel, other)),
    );
    error.note(format!(
        "{}, by every iteration at its own index: whether this read comes before or after depends on the threads",
        other_half(other)
    ));
    match across(kernel, number, access) {
        Across::NoCheckerboard => {}
        Across::NotConstant => {
            error.note("reads of the other colour are at the own index plus constants with an odd sum, such as `(i + 1, j)`; of any other index nobody knows the colour");
        }
        Across::Even => {
            error.note("the constants in this index have an even sum, so that the element is of the loop's own colour");
        }
        Across::Steps => {
            error
                .note("an index that lies outside is moved back to the edge: after more than one step it may be of the loop's own colour")
                .help("clamp after single steps along one axis, such as `(i + 1, j)`, or give a value for what lies outside: `or`");
        }
        Across::Elsewhere => {
            let field = &kernel.fields[access.field].name;
            error
                .note(format!("the loop may be larger than `{field}`: an index that is moved back into it may be of the loop's own colour"))
                .help(format!("loop over a colour of `{field}` itself"));
        }
        Across::Yes => {
            error.note("reads of the other colour stand beside writes at the own index with the variables in their order, and no others");
        }
    }
    error.help("read from one field and write to another, and swap the two between calls");
    let over = kernel.loops[number].head.field() == Some(access.field);
    let odd = matches!(&access.place, Place::Offset(offset) if offset.iter().map(|o| o & 1).sum::<i32>() % 2 == 1);
    if over && odd && across(kernel, number, access) == Across::NoCheckerboard {
        let field = &kernel.fields[access.field].name;
        error.help(format!(
            "or relax in place, one colour after the other: loop over `{field}.checkerboard(0)` and then `{field}.checkerboard(1)`"
        ));
    }
    error.help("or write `#[serial]` before the loop to run it on one thread");
}

fn scatter(found: &Loop, access: &Access, diagnostics: &mut Diagnostics) {
    let target = access.target.text();
    let variables: Vec<String> = found.variables.iter().flatten().map(ToString::to_string).collect();
    let own = if found.tuple { format!("({})", variables.join(", ")) } else { variables.join("") };
    let error = diagnostics.error(
        Code::PlainScatter,
        &access.spot.tokens,
        format!("`{target}` is written in a parallel loop, at an index that is not the iteration's own"),
    );
    match &access.place {
        Place::Offset(_) => {
            error
                .note(format!("it is the own element of another iteration; the own index is `{own}`"))
                .help("write at the own index, and move the indices that are read instead");
        }
        _ => {
            error.note(format!(
                "{}, and which comes last depends on the threads; the own index is `{own}`",
                meeting(found, access)
            ));
            if only_variables(found, access) {
                error.help(format!("index by `{own}` as it stands, whatever its type: what is made of it may be the same for two iterations"));
            }
            error
                .help("turn the loop round so that it gathers: loop over the field that is written, and compute where to read")
                .help("to add up what meets in one element, accumulate: `+=`, `min_assign`, `max_assign`, `|=`")
                .help("where any of the values will do, write `#[relaxed]` before the loop")
                .help("or write `#[serial]` before the loop to run it on one thread");
        }
    }
}

/// Whether an index is made of the loop's variables alone, by casts or by taking their components: `(ij.x, ij.y)`, `i as i32`.
fn only_variables(found: &Loop, access: &Access) -> bool {
    fn plain(tokens: TokenStream) -> bool {
        tokens.into_iter().all(|token| match token {
            TokenTree::Ident(_) => true,
            TokenTree::Punct(punct) => matches!(punct.as_char(), '.' | ','),
            TokenTree::Group(group) => plain(group.stream()),
            TokenTree::Literal(_) => false,
        })
    }
    let known = |name: &Ident| {
        let word = name.to_string();
        found.variables.contains(&Some(name.clone()))
            || ["as", "x", "y", "z", "w", "usize", "isize"].contains(&word.as_str())
            || word.strip_prefix(['i', 'u']).is_some_and(|bits| ["8", "16", "32", "64", "128"].contains(&bits))
    };
    let index = access.index.to_token_stream();
    let names = identifiers(index.clone());
    let all = found.variables.iter().flatten().all(|variable| names.contains(variable));
    all && !names.is_empty() && plain(index) && names.iter().all(known)
}

/// Which iterations write one element.
fn meeting(found: &Loop, access: &Access) -> String {
    let mentioned = identifiers(access.index.to_token_stream());
    let missing: Vec<String> = found
        .variables
        .iter()
        .flatten()
        .filter(|name| !mentioned.contains(name))
        .map(|name| format!("`{name}`"))
        .collect();
    if mentioned.is_empty() {
        "all iterations write this one element".to_owned()
    } else if !missing.is_empty() && missing.len() < found.variables.len() {
        format!("iterations that differ in {} alone write one element", missing.join(" and "))
    } else {
        "several iterations may write one element".to_owned()
    }
}

/// All names in tokens.
fn identifiers(tokens: TokenStream) -> Vec<Ident> {
    let names = tokens.into_iter().map(|token| match token {
        TokenTree::Ident(name) => vec![name],
        TokenTree::Group(group) => identifiers(group.stream()),
        TokenTree::Punct(_) | TokenTree::Literal(_) => Vec::new(),
    });
    names.flatten().collect()
}

fn operator(access: &Access, diagnostics: &mut Diagnostics) {
    let Use::Update(op, _) = access.usage() else { return };
    let (target, op_text) = (access.target.text(), op.text());
    let error = diagnostics.error(
        Code::OperatorScatter,
        &access.spot.tokens,
        format!("`{op_text}` is no accumulation, and `{target}` is not the iteration's own element"),
    );
    error.note("its result would depend on the order of the threads");
    if op == Op::Div {
        error.help(format!("multiply by the inverse: `{target} *= 1.0 / ..`"));
    }
    error.help("accumulate with one of `+=`, `-=`, `*=`, `min_assign`, `max_assign`, `&=`, `|=`, `^=`");
}

fn groups(access: &Access, other: &Access, member: &str, diagnostics: &mut Diagnostics) {
    let text = |usage| match usage {
        Use::Update(op, _) => op.text(),
        Use::Read | Use::Write | Use::Exchange => "=",
    };
    let (op, first) = (text(access.usage()), text(other.usage()));
    diagnostics
        .error(Code::MixedOperators, &access.spot.tokens, format!("`{op}` and `{first}` accumulate into `{member}` in one loop"))
        .note(format!("{}: the result of both would depend on the order of the threads", other_half(other)))
        .help("use one group of operators for a member in a loop (`+=` with `-=`; each other by itself): write two loops, or two members");
}
