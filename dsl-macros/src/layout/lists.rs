//! The rules of `dynamic`.

use super::check::check_axes;
use super::model::{Axis, Branch, List, Size, Step};
use crate::diagnostics::{Code, Diagnostics};

/// The most entries that an index can count.
const MOST: u128 = (1 << 31) - 1;

/// Reports all that is wrong with a list, step `number` of its branch.
pub(super) fn check(list: &List, branch: &Branch, number: usize, errors: &mut Diagnostics) {
    check_axis(list, branch, number, errors);
    check_place(list, branch, number, errors);
    let most = check_count(list.most.as_ref(), "maximum", list, errors);
    if list.most.is_none() {
        errors
            .error(Code::WrongMaximum, &list.name, "`dynamic` does not say how many entries a list has at most")
            .note(
                "`append` to a list that has so many is an error, which tells a mistake from a larger and larger list",
            )
            .help(format!("write `dynamic({}, 64)`", letters(list)));
    }
    if let Some((at, chunk)) = &list.chunk {
        let chunk = check_count(Some(chunk), "chunk", list, errors);
        if let (Some(most), Some(chunk)) = (most, chunk)
            && chunk > most
        {
            errors
                .error(
                    Code::WrongMaximum,
                    at,
                    format!("chunks of {chunk} entries are larger than the list, which has {most} at most"),
                )
                .help("leave `chunk` out: a list is then one block, which is allocated with its first entry");
        }
    }
    if let Some(surplus) = &list.surplus {
        errors
            .error(Code::WrongArguments, surplus, "`dynamic` takes an axis, a maximum and perhaps `chunk = ..`")
            .help(format!("write `dynamic({0}, 1024)` or `dynamic({0}, 1024, chunk = 32)`", letters(list)));
    }
}

fn letters(list: &List) -> String {
    list.axes.as_ref().map_or_else(|| "j".to_owned(), |axes| axes.name.to_string())
}

/// One axis, which is no other node's.
fn check_axis(list: &List, branch: &Branch, number: usize, errors: &mut Diagnostics) {
    let Some(axes) = &list.axes else {
        errors
            .error(Code::WrongArguments, &list.name, "`dynamic` does not say along which axis its lists grow")
            .help("write `dynamic(j, 64)`");
        return;
    };
    check_axes(axes, errors);
    let [axis] = axes.axes[..] else {
        if axes.unknown.is_empty() {
            errors
                .error(Code::WrongList, &axes.name, "a list grows along one axis")
                .help("give the other axes to a node before it: `dense(ij).dynamic(k, 64)`");
        }
        return;
    };
    let others = branch.steps.iter().enumerate().filter(|&(other, _)| other != number);
    let names = |step: &Step| step.axes().is_some_and(|other| other.axes.contains(&axis));
    if let Some((_, other)) = others.into_iter().find(|(_, step)| names(step)) {
        let letter = axis.letter();
        errors
            .error(
                Code::WrongList,
                &axes.name,
                format!("axis `{letter}` is the list's own, and `{}` names it, too", other.name()),
            )
            .note("an entry's position in its list is its index along that axis")
            .help("give the list an axis that no other node names");
        return;
    }
    check_last(list, axis, &branch.steps[..number], errors);
}

/// An entry's index is that of its list, and its position behind it.
fn check_last(list: &List, axis: Axis, before: &[Step], errors: &mut Diagnostics) {
    let lists = before.iter().filter_map(Step::axes).flat_map(|list| &list.axes);
    let Some(highest) = lists.max().filter(|&&highest| highest > axis) else { return };
    let (letter, last) = (axis.letter(), highest.letter());
    errors
        .error(Code::WrongList, &list.name, format!("axis `{letter}` is the list's own, and `{last}` comes behind it"))
        .note("an entry's index is that of its list, and its position there comes last")
        .help(format!("name the axes so that the list's is the last: `dynamic({last}, ..)`"));
}

/// Entries are records: nothing stands below.
fn check_place(list: &List, branch: &Branch, number: usize, errors: &mut Diagnostics) {
    if let Some(next @ (Step::Node(_) | Step::List(_))) = branch.steps.get(number + 1) {
        errors
            .error(
                Code::WrongList,
                &list.name,
                format!("`{}` stands below `dynamic`, whose entries are records", next.name()),
            )
            .help("put `dynamic` right before the place");
    }
}

/// A number of entries: it, where it is a literal and right.
fn check_count(count: Option<&Size>, what: &str, list: &List, errors: &mut Diagnostics) -> Option<u128> {
    let right = format!("write `dynamic({}, 64)`, or a constant of type `usize`", letters(list));
    match count? {
        Size::Number(number @ 1..=MOST, _) => Some(*number),
        Size::Number(number, literal) => {
            errors
                .error(Code::WrongMaximum, literal, format!("the {what} of a list cannot be {number}"))
                .note("entries are counted by an `i32`, and there is at least one")
                .help(right);
            None
        }
        Size::Wrong(at, _) => {
            errors.error(Code::WrongMaximum, at, format!("this is no {what} of a list")).help(right);
            None
        }
        Size::Constant(_) => None,
    }
}
