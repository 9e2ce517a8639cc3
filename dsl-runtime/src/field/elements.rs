//! The elements that hold values of their own.

use core::ops::Range;

use super::Handle;
use super::host::Places;
use crate::axes::{Axes, MAX_AXES, per_axis};
use crate::layout::node::nth_cell;
use crate::layout::{Chain, Layout, Map};
use crate::record::{ElementList, Path, Record};
use crate::store::active::{ActiveList, next_bit};

/// The elements that hold values of their own, in logical row-major order: all of a dense field, the active ones of a sparse one.
#[derive(Clone, Debug)]
pub(crate) enum Elements {
    /// All within the shape.
    All([u32; MAX_AXES]),
    /// Those at these places.
    Active(Vec<[u32; MAX_AXES]>),
}

impl Elements {
    /// Those of what a path names: active in any of its branches, all where one is dense.
    pub(crate) fn of<P: Path<R>, R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'_, R, L, X>) -> Self {
        let mut members = P::OFFSET..P::OFFSET + <P::Value as Record>::Elements::MEMBERS.len();
        if !members.clone().all(Map::<R, L, X>::is_sparse) || members.is_empty() {
            return Self::All(handle.geometry.shape);
        }
        let first = members.next().unwrap_or(P::OFFSET);
        let mut known = vec![Map::<R, L, X>::branch(first)];
        let mut places = active_places(handle, first);
        for m in members {
            let branch = Map::<R, L, X>::branch(m);
            if !known.contains(&branch) {
                known.push(branch);
                places.extend(active_places(handle, m));
            }
        }
        // Places of one branch are told once each.
        crate::index::sort(&mut places);
        places.dedup();
        Self::Active(places)
    }

    /// Those of one member.
    pub(crate) fn of_member<R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'_, R, L, X>, m: usize) -> Self {
        if !Map::<R, L, X>::is_sparse(m) {
            return Self::All(handle.geometry.shape);
        }
        let mut places = active_places(handle, m);
        crate::index::sort(&mut places);
        Self::Active(places)
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        match self {
            Self::All(shape) => shape.iter().fold(1, |len: usize, &n| len.saturating_mul(n as usize)),
            Self::Active(places) => places.len(),
        }
    }

    /// Those whose numbers lie in a range.
    pub(crate) fn part<X: Axes>(&self, part: Range<usize>) -> impl Iterator<Item = [u32; MAX_AXES]> + '_ {
        let (all, active) = match self {
            Self::All(shape) => (Some(Places::<X>::part(*shape, part)), None),
            Self::Active(places) => (None, Some(places[part].iter().copied())),
        };
        all.into_iter().flatten().chain(active.into_iter().flatten())
    }

    /// The element of a number.
    #[inline]
    pub(crate) fn nth<X: Axes>(&self, n: usize) -> [u32; MAX_AXES] {
        match self {
            Self::All(_) if X::RANK == 1 => [n as u32, 0, 0, 0],
            Self::All(shape) => Places::<X>::numbered(*shape, n),
            Self::Active(places) => places[n],
        }
    }

    /// All of them.
    pub(crate) fn all<X: Axes>(&self) -> impl Iterator<Item = [u32; MAX_AXES]> + '_ {
        self.part::<X>(0..self.len())
    }
}

/// The places of the active elements of a member's sparse branch, in memory order.
pub(crate) fn active_places<R: Record, L: Layout<X>, X: Axes>(
    handle: &Handle<'_, R, L, X>,
    m: usize,
) -> Vec<[u32; MAX_AXES]> {
    if const { !Map::<R, L, X>::any_sparse() } {
        return Vec::new();
    }
    let (chain, grain) = (Map::<R, L, X>::chain(m), Map::<R, L, X>::grain(m));
    places_in::<X>(&handle.actives(m), chain, grain, Map::<R, L, X>::list().is_some(), &handle.geometry.shape)
}

/// The same, compiled once for all layouts.
fn places_in<X: Axes>(
    list: &ActiveList,
    chain: &Chain,
    grain: usize,
    is_list: bool,
    shape: &[u32; MAX_AXES],
) -> Vec<[u32; MAX_AXES]> {
    let mut places = Vec::with_capacity(list.work());
    for (n, brick) in list.bricks.iter().enumerate() {
        // Of a list, as many entries as are held; else all cells, or those whose bits are set.
        let (cells, bits) = match is_list {
            true => (list.ends[n] - list.start(n), &[][..]),
            false => (chain.cells, list.bits(n)),
        };
        let mut cell = 0;
        while cell < cells {
            if let Some(bit) = cell.checked_div(grain) {
                cell = cell.max(next_bit(bits, bit, chain.bits(), true) * grain);
                if cell >= cells {
                    break;
                }
            }
            let inner = nth_cell::<X>(chain.digits, chain.extent, chain.cells, cell);
            let place = per_axis(|a| {
                if a < X::RANK { u64::from(brick.block[a]) * chain.extent[a] as u64 + inner[a] as u64 } else { 0 }
            });
            // Cells beyond the shape are not reachable.
            if (0..X::RANK).all(|a| place[a] < u64::from(shape[a])) {
                places.push(place.map(|c| c as u32));
            }
            cell += 1;
        }
    }
    places
}
