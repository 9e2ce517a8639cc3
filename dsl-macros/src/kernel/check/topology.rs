//! What a loop may do to the activity of a field, and ask of it.

use std::collections::BTreeSet;

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::access::clashes;
use crate::kernel::model::{Access, Call, Kernel, Loop, Node, Place, Slot, Topology};
use crate::kernel::text::type_text;

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    shared(kernel, diagnostics);
    for (number, found) in kernel.loops.iter().enumerate() {
        appends(kernel, found, diagnostics);
        reads(kernel, number, diagnostics);
    }
}

/// Changes through `&Field`.
fn shared(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    let mut told = BTreeSet::new();
    for node in &kernel.nodes {
        let Node::Topology(topology) = node else { continue };
        let field = &kernel.fields[topology.field];
        if !topology.call.changes() || field.mutable || !told.insert(topology.field) {
            continue;
        }
        let (name, ty) = (&field.name, type_text(&field.ty));
        diagnostics
            .error(
                Code::SharedWrite,
                &topology.spot.tokens,
                format!("`{name}.{}` changes `{name}`, and its parameter is `{ty}`", topology.method),
            )
            .help(format!("write `{name}: {}`", ty.replacen('&', "&mut ", 1)));
    }
}

/// Where the loop's variables stand in an index over so many places; nothing where some stand in none.
fn variables(found: &Loop, place: &Place) -> Option<Vec<Option<usize>>> {
    match place {
        Place::Own => Some((0..found.rank?).map(Some).collect()),
        Place::Places(slots) => Some(
            slots
                .iter()
                .map(|slot| match slot {
                    Slot::Variable(number) => Some(*number),
                    Slot::Free => None,
                })
                .collect(),
        ),
        Place::Offset(_) | Place::Computed => None,
    }
}

/// Whether an access is at an entry of the list that an iteration appends to, which is its alone. The entries' axis is the last.
fn is_own_row(found: &Loop, append: &Topology, access: &Access) -> bool {
    let (Some(list), Some(mut entry)) = (variables(found, &append.place), variables(found, &access.place)) else {
        return false;
    };
    entry.pop() == Some(None) && entry == list
}

/// Entries that are being appended are nobody else's.
fn appends(kernel: &Kernel, found: &Loop, diagnostics: &mut Diagnostics) {
    let mut told = BTreeSet::new();
    for append in found.topology.iter().filter(|topology| topology.call == Call::Append) {
        let accesses = found.accesses.iter().map(|&node| kernel.access(node));
        for access in accesses.filter(|access| access.field == append.field) {
            let at_home = found.head.field() == Some(append.field) && matches!(access.place, Place::Own);
            if at_home || is_own_row(found, append, access) || !told.insert(append.field) {
                continue;
            }
            let what = if access.changes() { "changed" } else { "read" };
            let own = if found.head.field() == Some(append.field) {
                "the loop's own elements, which were there when it began,"
            } else {
                "the entries of the iteration's own list"
            };
            diagnostics
                .error(
                    Code::AppendBeside,
                    &access.target.tokens,
                    format!(
                        "`{}` is {what} at an index that other iterations may be appending at, in line {}",
                        kernel.fields[append.field].name,
                        append.spot.line()
                    ),
                )
                .note(format!("beside `{}`, {own} are all that can be accessed", append.spot.text()))
                .help("append in one loop, and go through the entries in the next");
        }
    }
}

/// Whether the loop makes elements of a field active that its iterations do not run over: those of the branch of a member, where one is
/// named.
fn activates(kernel: &Kernel, found: &Loop, asked: &Topology) -> bool {
    let field = asked.field;
    let concerns = |path: &[syn::Ident]| {
        let shorter = path.len().min(asked.path.len());
        path[..shorter] == asked.path[..shorter]
    };
    let home = found.head.field() == Some(field);
    let by_access = found.accesses.iter().map(|&node| kernel.access(node)).any(|access| {
        access.field == field
            && concerns(&access.path)
            && access.changes()
            && !(home && matches!(access.place, Place::Own))
    });
    by_access
        || found
            .topology
            .iter()
            .any(|topology| topology.field == field && concerns(&topology.path) && topology.call.activates())
}

/// What is active cannot be told while others change it.
fn reads(kernel: &Kernel, number: usize, diagnostics: &mut Diagnostics) {
    let found = &kernel.loops[number];
    // A race between the turns of an outer loop is told as what it is.
    let races = found.topology.iter().any(|asked| asked.call == Call::All) && !clashes(kernel, number).is_empty();
    let mut told = BTreeSet::new();
    for asked in &found.topology {
        let own = matches!(asked.place, Place::Own | Place::Places(_)) && asked.call != Call::All;
        let told_already = asked.call == Call::All && races;
        if asked.call.changes() || own || told_already || !activates(kernel, found, asked) || !told.insert(asked.field)
        {
            continue;
        }
        let name = &kernel.fields[asked.field].name;
        let message = match asked.call {
            Call::All => {
                format!("`{}` runs over `{name}` while the loop makes elements of it active", asked.spot.text())
            }
            _ => format!(
                "`{}` asks for what other iterations change: the loop makes elements of `{name}` active",
                asked.spot.text()
            ),
        };
        diagnostics
            .error(Code::ActivityBeside, &asked.spot.tokens, message)
            .note("a write, an accumulation, `activate` and `append` make elements active; what is so at another index depends on who comes first")
            .help("ask in one loop and change in the next; at the iteration's own index, both may be done");
    }
}
