//! The rules of lists, of padding, and of groups of members.

use super::layout::{Chain, List, Placed};
use super::nodes::{AXES, TOO_MANY, axes};
use super::scan::Text;
use super::syntax::{Argument, Value, Word};
use crate::lab::errors::LabError;

/// The most bytes that starts are aligned to.
const WIDEST_PAD: u128 = 4096;

pub(super) fn list(text: Text<'_>, word: &Word<'_>, chain: &Chain) -> Result<List, LabError> {
    let (axes, at) = axes(text, word, "dynamic(j, 64)")?;
    let [axis] = axes[..] else {
        return Err(text.error(&at, "a list grows along one axis; write `dynamic(j, 64)`"));
    };
    let letter = AXES[axis];
    if chain.nodes.iter().any(|node| node.axes.contains(&axis)) {
        return Err(text.error(
            &at,
            format!(
                "axis `{letter}` is the list's own, and another node names it, too; give the list an axis of its own"
            ),
        ));
    }
    let (mut most, mut chunk) = (None, None);
    let right = format!("write `dynamic({letter}, 1024)` or `dynamic({letter}, 1024, chunk = 32)`");
    for argument in word.arguments.iter().flatten().skip(1) {
        let (slot, value) = match &argument.value {
            Value::Named("chunk", value) => (&mut chunk, &**value),
            _ if most.is_none() && chunk.is_none() => (&mut most, argument),
            _ => {
                return Err(text.error(
                    &argument.at,
                    format!("`dynamic` takes an axis, a maximum and perhaps `chunk = ..`; {right}"),
                ));
            }
        };
        match value.value {
            Value::Number(number @ 1..TOO_MANY) => *slot = Some((number as usize, argument.at.clone())),
            _ => {
                return Err(text.error(&argument.at, format!("a list has from 1 to {} entries; {right}", TOO_MANY - 1)));
            }
        }
    }
    let Some((most, _)) = most else {
        return Err(
            text.error(&word.at, format!("`dynamic` does not say how many entries a list has at most; {right}"))
        );
    };
    match chunk {
        Some((chunk, at)) if chunk > most => Err(text.error(
            &at,
            format!("chunks of {chunk} entries are larger than the list, which has {most} at most; leave `chunk` out"),
        )),
        chunk => Ok(List { axis, most, chunk: chunk.map_or(most, |(chunk, _)| chunk) }),
    }
}

pub(super) fn pad(text: Text<'_>, word: &Word<'_>, chain: &Chain) -> Result<usize, LabError> {
    let right = "write a power of two up to 4096, a cache line say: `.pad(64)`";
    if chain.pad.is_some() {
        return Err(text.error(&word.at, "`pad` stands twice; leave one out"));
    }
    match word.arguments.as_deref() {
        Some([Argument { value: Value::Number(bytes), .. }]) if bytes.is_power_of_two() && *bytes <= WIDEST_PAD => {
            Ok(*bytes as usize)
        }
        Some([first, ..]) => Err(text.error(&first.at, format!("starts cannot be aligned to this; {right}"))),
        _ => Err(text.error(&word.at, format!("`pad` does not say to how many bytes; {right}"))),
    }
}

pub(super) fn groups(text: Text<'_>, word: &Word<'_>) -> Result<Vec<Vec<Placed>>, LabError> {
    let arguments = word.arguments.as_deref().unwrap_or_default();
    if arguments.is_empty() {
        return Err(text
            .error(&word.at, "`place` has no groups of members; write `.place([v, m])`, or `.aos` for all together"));
    }
    arguments.iter().map(|argument| group(text, argument)).collect()
}

fn group(text: Text<'_>, argument: &Argument<'_>) -> Result<Vec<Placed>, LabError> {
    let right = "a group is a list of members in brackets: `[v, split(c)]`";
    let Value::List(entries) = &argument.value else {
        return Err(text.error(&argument.at, format!("this is no group; {right}")));
    };
    if entries.is_empty() {
        return Err(text.error(&argument.at, "the group has no members; name one in it, or leave the group out"));
    }
    let placed = |entry: &Argument<'_>| match &entry.value {
        Value::Name(name) => Ok(Placed { name: (*name).into(), split: false, at: entry.at.clone() }),
        Value::Call("split", inner) => match inner.as_slice() {
            [Argument { value: Value::Name(name), at }] => {
                Ok(Placed { name: (*name).into(), split: true, at: at.clone() })
            }
            _ => Err(text.error(&entry.at, format!("`split` takes one member; {right}"))),
        },
        _ => Err(text.error(&entry.at, format!("this is no member; {right}"))),
    };
    entries.iter().map(placed).collect()
}
