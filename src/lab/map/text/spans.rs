//! The bytes of elements, in the order in which they lie.

use std::ops::Range;

use allotrope::Standing;

use super::TextMap;
use super::branch::Branch;
use super::levels::Place;
use super::streams::Stream;
use crate::lab::map::Span;

/// What lies in one piece of memory of a branch.
struct Part<'a> {
    branch: &'a Branch,
    /// Where it begins in the piece.
    start: usize,
    /// Its cells.
    cells: usize,
    /// The number of the block that it is, if it is one.
    block: Option<usize>,
}

fn parts(map: &TextMap, piece: usize) -> Vec<Part<'_>> {
    let dense = usize::from(map.roots.iter().any(Option::is_some));
    if piece < dense {
        let roots = map.branches.iter().zip(&map.roots).filter_map(|(branch, root)| Some((branch, root.as_ref()?)));
        return roots
            .map(|(branch, (root, start))| Part {
                branch,
                start: *start,
                cells: root.cells() * branch.levels.cells(),
                block: None,
            })
            .collect();
    }
    let block = piece - dense;
    let branch = &map.branches[map.blocks[block].branch];
    vec![Part { branch, start: 0, cells: branch.levels.cells(), block: Some(block) }]
}

/// Where the runs of the first innermost node begin.
pub(super) fn starts(map: &TextMap, piece: usize) -> Vec<usize> {
    let parts = parts(map, piece).into_iter().filter(|part| part.cells > 0);
    parts
        .flat_map(|part| part.branch.runs(part.cells).map(move |(_, start)| part.start + start).collect::<Vec<_>>())
        .collect()
}

/// The spans of which a byte lies in a range.
pub(super) fn within(map: &TextMap, piece: usize, bytes: &Range<usize>) -> Vec<Span> {
    let mut spans = Vec::new();
    for part in parts(map, piece) {
        let node_cells = part.branch.node_cells(part.cells);
        let nodes = part.cells.checked_div(node_cells).unwrap_or(0);
        let node_bytes = part.branch.bytes(part.cells).unwrap_or(0).checked_div(nodes).unwrap_or(0);
        for node in overlap(bytes, part.start, node_bytes, nodes) {
            for (stream, start) in part.branch.runs(part.cells) {
                let start = part.start + node * node_bytes + start;
                for cell in overlap(bytes, start, stream.item, node_cells) {
                    let number = node * node_cells + cell;
                    span(map, &part, stream, number, node, start + cell * stream.item, &mut spans);
                }
            }
        }
    }
    spans.retain(|span| span.bytes.start.max(bytes.start) < span.bytes.end.min(bytes.end));
    spans
}

/// Which of `count` items of a size that lie one after another from `start` on have bytes in a range.
fn overlap(bytes: &Range<usize>, start: usize, item: usize, count: usize) -> Range<usize> {
    if item == 0 {
        return 0..0;
    }
    let from = bytes.start.saturating_sub(start) / item;
    let to = bytes.end.saturating_sub(start).div_ceil(item).min(count);
    from..to.max(from)
}

/// The spans of an item.
fn span(
    map: &TextMap,
    part: &Part<'_>,
    stream: &Stream,
    number: usize,
    node: usize,
    start: usize,
    spans: &mut Vec<Span>,
) {
    let block_cells = part.branch.levels.cells();
    let (root_cell, inner) = (number / block_cells, part.branch.levels.place(number % block_cells));
    let (first, active) = match part.block {
        Some(block) => (map.blocks[block].first, Some(&map.blocks[block].active)),
        None => (first(map, part.branch, root_cell), None),
    };
    let place: Place = std::array::from_fn(|axis| first[axis] + inner[axis]);
    let index: Vec<i32> = place[..map.shape.len()].iter().map(|&c| c as i32).collect();
    let sparse = part.branch.sparse.as_ref();
    let unbounded = sparse.is_some_and(|sparse| sparse.hash);
    let list = sparse.and_then(|sparse| sparse.list).map(|list| list.axis);
    let beyond = |(axis, &extent): (usize, &usize)| {
        // Without bounds there are the indices of an `i32`, as far as the one after is one, too; a list has an end all the same.
        let end = if unbounded && list != Some(axis) { i64::from(i32::MAX) } else { extent as i64 };
        place[axis] >= end
    };
    let standing = if map.shape.iter().enumerate().any(beyond) {
        Standing::Beyond
    } else {
        active.map_or(Standing::Active, |active| active.standing(number, sparse.map_or(0, |sparse| sparse.grain)))
    };
    for &(member, offset) in &stream.parts {
        let facts = &map.members[member];
        let components = stream.component.map_or(0..facts.components, |component| component..component + 1);
        let from = start + offset;
        let bytes = from..from + components.len() * facts.scalar_bytes;
        spans.push(Span { bytes, member, components, index: index.clone(), block: root_cell, node, standing });
    }
}

/// The first place of a cell of the root.
fn first(map: &TextMap, branch: &Branch, root_cell: usize) -> Place {
    let number = map.branches.iter().position(|other| std::ptr::eq(other, branch));
    let root = number.and_then(|number| map.roots[number].as_ref());
    let extent = branch.levels.extent();
    let at = root.map_or([0; 4], |(root, _)| super::levels::Levels(vec![root.clone()]).place(root_cell));
    std::array::from_fn(|axis| at[axis] * extent[axis])
}
