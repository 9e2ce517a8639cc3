//! The blocks of a sparse layout that are there, and what of them is active.

use std::collections::{BTreeMap, BTreeSet};

use allotrope::Standing;

use super::branch::{Branch, Sparse};
use super::levels::Place;
use super::scan::Text;
use crate::lab::errors::LabError;

/// The most blocks that are made.
const MOST: usize = 1 << 18;

/// A block of a sparse branch.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) branch: usize,
    pub(super) first: Place,
    pub(super) active: Active,
}

/// What of a block is active.
#[derive(Clone, Debug)]
pub(super) enum Active {
    Whole,
    /// The cells of these bits.
    Bits(BTreeSet<usize>),
    /// So many entries of a list.
    Entries(usize),
}

impl Active {
    pub(super) fn standing(&self, cell: usize, grain: usize) -> Standing {
        let active = match self {
            Self::Whole => true,
            Self::Bits(bits) => bits.contains(&(cell / grain.max(1))),
            Self::Entries(entries) => cell < *entries,
        };
        if active { Standing::Active } else { Standing::Inactive }
    }
}

/// The blocks of a sparse branch by their places in its tree: the root's cell, the cell of the nodes below it, and the place in a list.
struct Tree<'a> {
    number: usize,
    branch: &'a Branch,
    sparse: &'a Sparse,
    blocks: BTreeMap<(Vec<i64>, usize, i64), Block>,
}

/// The blocks of a sparse branch in which these places lie, in the order of its tree.
pub(super) fn of(
    layout: &str,
    number: usize,
    branch: &Branch,
    shape: &[usize],
    places: &[Place],
) -> Result<Vec<Block>, LabError> {
    let Some(sparse) = &branch.sparse else { return Ok(Vec::new()) };
    let mut tree = Tree { number, branch, sparse, blocks: BTreeMap::new() };
    let filled = if sparse.own { tree.fill(shape) } else { Some(()) };
    if filled.and_then(|()| places.iter().try_for_each(|place| tree.activate(place))).is_none() {
        let text = Text { what: "layout", text: layout };
        let message = format!(
            "there are more than the {MOST} blocks that can be told; write a smaller shape, or have less active"
        );
        return Err(text.error(&(0..layout.len()), message));
    }
    Ok(tree.blocks.into_values().collect())
}

impl Tree<'_> {
    /// Makes the root's own blocks, which are there from the start; `None` where they are too many.
    fn fill(&mut self, shape: &[usize]) -> Option<()> {
        let extent = self.branch.levels.extent();
        let counts: Vec<usize> = shape.iter().zip(extent).map(|(n, extent)| n.div_ceil(extent as usize)).collect();
        let count = counts.iter().try_fold(1usize, |count, &along| count.checked_mul(along))?;
        if count > MOST {
            return None;
        }
        for mut n in 0..count {
            let mut first = [0; 4];
            for (axis, &along) in counts.iter().enumerate() {
                first[axis] = (n % along) as i64 * extent[axis];
                n /= along;
            }
            self.note(first, Active::Bits(BTreeSet::new()))?;
        }
        Some(())
    }

    /// Makes the element at a place active; `None` where blocks are too many.
    fn activate(&mut self, place: &Place) -> Option<()> {
        let extent = self.branch.levels.extent();
        let first: Place = std::array::from_fn(|a| place[a].div_euclid(extent[a]) * extent[a]);
        let Some(list) = self.sparse.list else {
            let bit = self.branch.levels.number(place).checked_div(self.sparse.grain);
            return self.note(first, bit.map_or(Active::Whole, |bit| Active::Bits(BTreeSet::from([bit]))));
        };
        // The entries before it are there, too.
        let (place, chunk) = (place[list.axis], list.chunk as i64);
        (0..=place / chunk).try_for_each(|n| {
            let mut first = first;
            first[list.axis] = n * chunk;
            self.note(first, Active::Entries((place + 1 - n * chunk).min(chunk) as usize))
        })
    }

    fn note(&mut self, first: Place, active: Active) -> Option<()> {
        let Self { number, branch, sparse, .. } = *self;
        let (extent, root) = (branch.levels.extent(), branch.root_extent());
        let cell: Vec<i64> = branch.root.iter().map(|&a| first[a].div_euclid(root[a])).collect();
        let list = sparse.list.map(|list| list.axis);
        let above = std::array::from_fn(|a| if list == Some(a) { 0 } else { first[a].div_euclid(extent[a]) });
        let key = (cell, sparse.upper.number(&above), list.map_or(0, |axis| first[axis]));
        let block = self.blocks.entry(key).or_insert_with(|| Block { branch: number, first, active: active.clone() });
        match (&mut block.active, active) {
            (Active::Bits(bits), Active::Bits(more)) => bits.extend(more),
            (Active::Entries(entries), Active::Entries(more)) => *entries = more.max(*entries),
            _ => {}
        }
        (self.blocks.len() <= MOST).then_some(())
    }
}
