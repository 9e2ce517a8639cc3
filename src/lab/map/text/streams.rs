//! Members under a place: which lie together, and how far apart.

use super::layout::{Chain, Layout, Place};
use super::scan::{Text, nearest};
use crate::lab::errors::LabError;
use crate::lab::map::Member;

/// A run in an innermost node: an item a cell.
#[derive(Clone, Debug)]
pub(super) struct Stream {
    /// The members, and where each begins in an item.
    pub(super) parts: Vec<(usize, usize)>,
    /// Which component it holds, where the member's lie apart.
    pub(super) component: Option<usize>,
    /// Bytes of an item.
    pub(super) item: usize,
}

/// The runs of each branch of a layout, in order.
pub(super) fn of(text: &str, layout: &Layout, members: &[Member]) -> Result<Vec<Vec<Stream>>, LabError> {
    let text = Text { what: "layout", text };
    let mut placed = vec![false; members.len()];
    let streams: Vec<_> =
        layout.branches.iter().map(|chain| branch(text, chain, members, &mut placed)).collect::<Result<_, _>>()?;
    let last = &layout.branches[layout.branches.len() - 1].at;
    if let Some(left) = placed.iter().position(|placed| !placed) {
        let name = &members[left].name;
        return Err(text.error(last, format!("`.place(..)` leaves out the member `{name}`; add it to a group")));
    }
    Ok(streams)
}

fn branch(text: Text<'_>, chain: &Chain, members: &[Member], placed: &mut [bool]) -> Result<Vec<Stream>, LabError> {
    let all = 0..members.len();
    let Some(Place::Groups(groups)) = &chain.place else {
        placed.fill(true);
        return Ok(match chain.place {
            Some(Place::Soa) => all.map(|member| together(&[member], members, 1)).collect(),
            Some(Place::Split) => all.flat_map(|member| apart(member, members)).collect(),
            _ => vec![together(&all.collect::<Vec<_>>(), members, chain.pad.unwrap_or(1))],
        });
    };
    let mut streams = Vec::new();
    for group in groups {
        let (mut whole, mut split) = (Vec::new(), Vec::new());
        for entry in group {
            let below = format!("{}.", entry.name);
            let named = |member: &Member| member.name == entry.name || member.name.starts_with(&below);
            let mut found = all.clone().filter(|&member| named(&members[member])).peekable();
            if found.peek().is_none() {
                return Err(text.error(&entry.at, unknown(&entry.name, members)));
            }
            for member in found {
                if std::mem::replace(&mut placed[member], true) {
                    let name = &members[member].name;
                    return Err(
                        text.error(&entry.at, format!("the member `{name}` is placed twice; name it in one group"))
                    );
                }
                if entry.split { &mut split } else { &mut whole }.push(member);
            }
        }
        if !whole.is_empty() {
            streams.push(together(&whole, members, 1));
        }
        streams.extend(split.into_iter().flat_map(|member| apart(member, members)));
    }
    Ok(streams)
}

fn unknown(name: &str, members: &[Member]) -> String {
    let names = members.iter().map(|member| member.name.as_str());
    match nearest(name, names.clone()) {
        _ if members[0].name.is_empty() => {
            format!(
                "the record is a bare element without a member `{name}`; write `.aos`, or `.split` for components apart"
            )
        }
        Some(near) => format!("the record has no member `{name}`; did you mean `{near}`?"),
        None => format!("the record has no member `{name}`; it has `{}`", names.collect::<Vec<_>>().join("`, `")),
    }
}

/// Members interleaved, rounded up to the widest scalar and to the padding of records.
fn together(list: &[usize], members: &[Member], pad: usize) -> Stream {
    let (mut item, mut widest, mut parts) = (0, 1, Vec::new());
    for &member in list {
        parts.push((member, item));
        item += members[member].bytes();
        widest = widest.max(members[member].scalar_bytes);
    }
    Stream { parts, component: None, item: item.next_multiple_of(widest).next_multiple_of(pad) }
}

/// A run for each component.
fn apart(member: usize, members: &[Member]) -> impl Iterator<Item = Stream> {
    let Member { components, scalar_bytes: item, .. } = members[member];
    (0..components).map(move |component| Stream { parts: vec![(member, 0)], component: Some(component), item })
}
