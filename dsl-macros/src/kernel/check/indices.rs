//! The number of places in an index, offsets against borders, and writes through `&Field`.

use std::collections::BTreeSet;

use syn::Ident;

use super::super::syntax::{bare, integer, name_of, parts};
use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Access, Boundary, Head, Kernel, Loop, Node, Place, Spot, Storage};
use crate::kernel::text::{text, type_text};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for found in &kernel.loops {
        variables(kernel, found, diagnostics);
    }
    let mut told = BTreeSet::new();
    for node in &kernel.nodes {
        let access = match node {
            Node::Access(access) => access,
            Node::Unchecked(access) => {
                member_of_member(kernel, access.field, &access.path, diagnostics);
                if access.value.is_some() && !kernel.fields[access.field].mutable && told.insert(access.field) {
                    shared_write(kernel, access.field, &access.spot, diagnostics);
                }
                continue;
            }
            _ => continue,
        };
        count(kernel, access, diagnostics);
        member_of_member(kernel, access.field, &access.path, diagnostics);
        if access.changes() && !kernel.fields[access.field].mutable && told.insert(access.field) {
            shared_write(kernel, access.field, &access.spot, diagnostics);
        }
        if let Some(number) = access.parallel {
            border(&kernel.loops[number], access, diagnostics);
        }
    }
}

fn axes(count: usize) -> String {
    if count == 1 { "1 axis".to_owned() } else { format!("{count} axes") }
}

/// An index for that many axes.
fn example(count: usize) -> &'static str {
    match count {
        0 => "()",
        1 => "i",
        2 => "(i, j)",
        3 => "(i, j, k)",
        _ => "(i, j, k, l)",
    }
}

/// The loop's variables against its space.
fn variables(kernel: &Kernel, found: &Loop, diagnostics: &mut Diagnostics) {
    let (what, rank) = match &found.head {
        Head::Ranges(ranges) if ranges.len() > 4 => {
            diagnostics
                .error(Code::LoopRange, &found.spot.tokens, "a parallel loop runs over four ranges at most")
                .help("loop over the first four, and over the others inside");
            return;
        }
        Head::Ranges(ranges) => ("the loop's head".to_owned(), Some(ranges.len())),
        head => match head.field() {
            Some(field) => (format!("`{}`", kernel.fields[field].name), kernel.fields[field].rank),
            None => return,
        },
    };
    let Some(rank) = rank else { return };
    if found.tuple && found.variables.len() != rank {
        let message = format!("{what} has {}, and the loop names {}", axes(rank), found.variables.len());
        diagnostics
            .error(Code::IndexCount, &found.spot.tokens, message)
            .help(format!("write `for {} in ..`", example(rank)));
    }
}

/// The places of an index against its field.
fn count(kernel: &Kernel, access: &Access, diagnostics: &mut Diagnostics) {
    let field = &kernel.fields[access.field];
    let Some(rank) = field.rank else { return };
    let own = access.parallel.map(|number| &kernel.loops[number]);
    let found = match (parts(&access.index), integer(&access.index), name_of(&access.index), own) {
        (Some(parts), ..) => parts.len(),
        (None, Some(_), ..) => 1,
        (None, None, Some(name), Some(own)) if !own.tuple && own.variables[0].as_ref() == Some(name) => {
            match own.rank {
                Some(rank) => rank,
                None => return,
            }
        }
        (None, None, Some(name), Some(own)) if own.tuple && own.variables.contains(&Some(name.clone())) => 1,
        _ => return,
    };
    // `[x]` and `(x,)` are read as indices, `()` is that of a field without axes.
    if found != rank {
        let (name, index) = (&field.name, text(bare(&access.index)));
        let error = diagnostics.error(
            Code::IndexCount,
            &access.target.tokens,
            format!("`{name}` has {}, and the index `{index}` names {found}", axes(rank)),
        );
        error.note(format!("the type of `{name}` is `{}`", type_text(&field.ty)));
        error.help(match field.storage {
            Storage::Slice => format!("write `{name}[{}]`", example(rank)),
            storage => format!(
                "write `{name}[{}]`; the third parameter of `{}` says its axes: `O` (none), `I` (the default), `Ij`, `Ijk`, `Ijkl`",
                example(rank),
                if storage == Storage::Member { "Member" } else { "Field" }
            ),
        });
    }
}

/// A member is named where the elements have none.
fn member_of_member(kernel: &Kernel, field: usize, path: &[Ident], diagnostics: &mut Diagnostics) {
    let field = &kernel.fields[field];
    let (Some(first), true) = (path.first(), field.storage.is_single()) else { return };
    let (name, ty) = (&field.name, type_text(&field.ty));
    let what = if field.storage == Storage::Slice { "a slice" } else { "a single member" };
    diagnostics
        .error(Code::MemberOfMember, first, format!("`{name}` is {what}, and has no member `{first}`"))
        .note(format!("the type of `{name}` is `{ty}`"))
        .help(format!("write `{name}[..]` for its elements, and `{name}[..].{first}` for a part of one; for whole records, take a `Field`"));
}

fn shared_write(kernel: &Kernel, field: usize, spot: &Spot, diagnostics: &mut Diagnostics) {
    let field = &kernel.fields[field];
    let (name, ty) = (&field.name, type_text(&field.ty));
    diagnostics
        .error(Code::SharedWrite, &spot.tokens, format!("`{name}` is written, and its parameter is `{ty}`"))
        .help(format!("write `{name}: {}`", ty.replacen('&', "&mut ", 1)));
}

/// Constant offsets against the border that the loop leaves out.
fn border(found: &Loop, access: &Access, diagnostics: &mut Diagnostics) {
    let (Some(width), Place::Offset(offset)) = (found.head.left_out(), &access.place) else { return };
    if !matches!(access.boundary, Boundary::Checked) {
        return;
    }
    let Some(width) = integer(width) else { return };
    let reach = offset.iter().map(|offset| offset.saturating_abs()).max().unwrap_or(0);
    if reach > width {
        let message = format!(
            "`{}` reaches {reach} cells away, and `interior({width})` leaves a border of {width}",
            access.target.text()
        );
        diagnostics.error(Code::InteriorOffset, &access.target.tokens, message).help(format!(
            "write `interior({reach})`; where this field is larger than the loop's, loop over an `ndrange!`"
        ));
    }
}
