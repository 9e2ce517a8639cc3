//! Tiles of a field: boxes of equal extents, in colours such that no two tiles of a colour are neighbours.

use super::share::Window;
use crate::axes::MAX_AXES;
use crate::layout::Geometry;

/// The least cells of a tile along each axis, by the number of axes.
const LEAST: [u32; MAX_AXES] = [512, 16, 8, 8];
/// Elements of a loop that are worth a tile.
const WORTH: usize = 128;
/// So many tiles keep all threads busy: tiles are cut along the first axis, and along others where these are fewer.
const ENOUGH: u64 = 64;
/// Blocks longer than so many of the least extents do not shape tiles.
const LONG: u32 = 4;

/// The tiles of a box of a field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tiles {
    rank: usize,
    /// The first logical coordinates of the first tile.
    first: [i64; MAX_AXES],
    extent: [u32; MAX_AXES],
    pub(super) counts: [u32; MAX_AXES],
    /// What the updates of an element reach, as seen from its key.
    low: [i64; MAX_AXES],
    high: [i64; MAX_AXES],
}

impl Tiles {
    /// The tiles of a field for a loop of so many elements, whose updates lie from `low` to `high` around their keys, which lie in
    /// `keys`, first and last, where that is known.
    pub(super) fn new(
        rank: usize,
        geometry: &Geometry,
        block: [u32; MAX_AXES],
        elements: usize,
        (low, high): ([i64; MAX_AXES], [i64; MAX_AXES]),
        keys: Option<([i64; MAX_AXES], [i64; MAX_AXES])>,
    ) -> Self {
        let mut this = Self {
            rank,
            first: [0; MAX_AXES],
            extent: [1; MAX_AXES],
            counts: [1; MAX_AXES],
            low: [0; 4],
            high: [0; 4],
        };
        let mut spans = [(0, 1); MAX_AXES];
        for a in 0..rank {
            let (start, shape) = (i64::from(geometry.origin[a]), i64::from(geometry.shape[a]));
            (this.low[a], this.high[a]) = (low[a].min(high[a]), high[a].max(low[a]));
            let reach = (this.high[a] - this.low[a]).clamp(0, shape) as u32;
            let least = LEAST[rank - 1].max(reach);
            let block = if block[a] <= LEAST[rank - 1] * LONG { block[a] } else { 1 };
            this.extent[a] = least.next_multiple_of(block);
            // Tiles begin where blocks do.
            let of_key = |at: i64| at.saturating_sub(start).clamp(0, (shape - 1).max(0));
            let (from, to) = keys.map_or((0, shape), |(from, to)| (of_key(from[a]), of_key(to[a]) + 1));
            let from = from / i64::from(this.extent[a]) * i64::from(this.extent[a]);
            spans[a] = (start + from, to - from);
        }
        // Slices across the first axis follow the order of most memory, and two colours are enough for them.
        let least = this.extent;
        let whole = |a: usize| (spans[a].1 as u64).div_ceil(least[a].into()).clamp(1, u32::MAX.into()) as u32;
        (1..rank).for_each(|a| this.extent[a] = least[a].saturating_mul(whole(a)));
        this.first = spans.map(|(first, _)| first);
        (0..rank).for_each(|a| this.count_along(a, spans[a].1));
        let worth = |this: &Self| this.count().saturating_mul(WORTH as u64) <= elements as u64;
        for a in 1..rank {
            while this.count() < ENOUGH && this.extent[a] > least[a] {
                this.extent[a] = (this.extent[a] / least[a]).div_ceil(2) * least[a];
                this.count_along(a, spans[a].1);
            }
        }
        while this.count() > ENOUGH && this.counts[0] > 1 && !worth(&this) {
            this.extent[0] = this.extent[0].saturating_mul(2);
            this.count_along(0, spans[0].1);
        }
        this
    }

    fn count_along(&mut self, axis: usize, span: i64) {
        self.counts[axis] = (span as u64).div_ceil(self.extent[axis].into()).max(1) as u32;
    }

    /// How many there are.
    pub(super) fn count(&self) -> u64 {
        self.counts.iter().fold(1, |count: u64, &n| count.saturating_mul(n.into()))
    }

    /// The number of the tile that a key lies in, or is nearest to; its first coordinates, and its extent.
    pub(super) fn find(&self, key: [i64; MAX_AXES]) -> (u32, [i64; MAX_AXES]) {
        let (mut number, mut start) = (0, [0; MAX_AXES]);
        for a in 0..self.rank {
            let extent = i64::from(self.extent[a]);
            let n = (key[a].saturating_sub(self.first[a]).max(0) / extent).min(i64::from(self.counts[a]) - 1);
            number = number * self.counts[a] + n as u32;
            start[a] = self.first[a] + n * extent;
        }
        (number, start)
    }

    /// Cells of a tile along each axis.
    pub(super) fn extent(&self) -> [u32; MAX_AXES] {
        self.extent
    }

    fn coordinates(&self, number: u32) -> [u32; MAX_AXES] {
        let (mut rest, mut at) = (number, [0; MAX_AXES]);
        for a in (0..self.rank).rev() {
            at[a] = rest % self.counts[a];
            rest /= self.counts[a];
        }
        at
    }

    /// How many colours there are.
    pub(super) fn colours(&self) -> usize {
        1 << self.rank
    }

    /// The colour of a tile.
    pub(super) fn colour(&self, number: u32) -> usize {
        let at = self.coordinates(number);
        (0..self.rank).fold(0, |colour, a| colour * 2 + (at[a] % 2) as usize)
    }

    /// What the elements of a tile may reach in a field: more than they do, as far as no other tile of the colour may.
    ///
    /// Along an axis, tile `t` of extent `e` has `first + t e + low - s .. first + (t + 1) e + high + s`. The next of its colour begins at
    /// `first + (t + 2) e + low - s`, which is no less, as `high - low + 2 s <= e`.
    pub(super) fn window(&self, number: u32, geometry: &Geometry) -> Window {
        let tile = self.coordinates(number);
        let (mut low, mut end) = ([0; MAX_AXES], [1; MAX_AXES]);
        for a in 0..self.rank {
            let extent = i64::from(self.extent[a]);
            let slack = (extent - (self.high[a] - self.low[a])).max(0) / 2;
            let start = self.first[a] + i64::from(tile[a]) * extent;
            (low[a], end[a]) = (start + self.low[a] - slack, start + extent + self.high[a] + slack);
        }
        Window::between(geometry, low, end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axes::{Axes, I, Ij, Ijk};
    use crate::layout::Aos;

    /// All tiles of fields of one shape: windows of a colour are disjoint, and what keys of a tile reach lies in its window.
    fn windows_of_a_colour_are_disjoint<X: Axes>(shape: [usize; MAX_AXES], origin: i64, elements: usize, reach: i64) {
        let axes = |a: usize| a < X::RANK;
        let first = core::array::from_fn(|a| if axes(a) { origin } else { 0 });
        let geometry = Geometry::new::<Aos, X>(shape).and_then(|g| g.with_origin::<X>(first)).expect("a geometry");
        for (low, high) in
            [([0; MAX_AXES], [0; MAX_AXES]), ([-reach; MAX_AXES], [reach; MAX_AXES]), ([0; 4], [reach; 4])]
        {
            for block in [1, 3, 8] {
                let tiles = Tiles::new(X::RANK, &geometry, [block; MAX_AXES], elements, (low, high), None);
                let count = tiles.count() as u32;
                let inside = |number: u32, at: [i64; MAX_AXES]| {
                    tiles.window(number, &geometry).within::<X>(at, &geometry).is_some()
                };
                let mut at = first;
                let mut step = 0;
                // Every cell has at most one tile of each colour whose window holds it.
                while at[0] < first[0] + shape[0] as i64 {
                    let (home, start) = tiles.find(at);
                    for axis in (0..X::RANK).filter(|&a| tiles.counts[a] > 1) {
                        assert!(
                            (0..i64::from(tiles.extent[axis])).contains(&(at[axis] - start[axis])),
                            "{at:?} in {start:?}"
                        );
                    }
                    let far = |of: [i64; MAX_AXES]| -> [i64; MAX_AXES] {
                        core::array::from_fn(|a| {
                            let last = first[a] + shape[a] as i64 - 1;
                            if axes(a) { (at[a] + of[a]).clamp(first[a], last) } else { 0 }
                        })
                    };
                    assert!(inside(home, far(low)) && inside(home, far(high)), "{at:?} reaches {low:?} to {high:?}");
                    let holders: Vec<usize> = (0..count).filter(|&t| inside(t, at)).map(|t| tiles.colour(t)).collect();
                    for colour in 0..tiles.colours() {
                        assert!(holders.iter().filter(|&&held| held == colour).count() <= 1, "{at:?}: {holders:?}");
                    }
                    // Some cells, in every part of the field.
                    step += 1;
                    for axis in (0..X::RANK).rev() {
                        at[axis] += if axis + 1 == X::RANK { 1 + (step % 3) as i64 } else { 1 };
                        if axis == 0 || at[axis] < first[axis] + shape[axis] as i64 {
                            break;
                        }
                        at[axis] = first[axis];
                    }
                }
            }
        }
    }

    #[test]
    fn tiles_of_a_colour_never_meet() {
        for reach in [0, 1, 3, 40] {
            windows_of_a_colour_are_disjoint::<I>([5000, 1, 1, 1], -7, 1 << 20, reach);
            windows_of_a_colour_are_disjoint::<Ij>([70, 90, 1, 1], 0, 1 << 20, reach);
            windows_of_a_colour_are_disjoint::<Ij>([9, 200, 1, 1], -100, 100, reach);
            // More tiles along the second axis than so few elements are worth.
            windows_of_a_colour_are_disjoint::<Ij>([9, 1904, 1, 1], 0, 100, reach);
            windows_of_a_colour_are_disjoint::<Ijk>([20, 30, 25, 1], 3, 1 << 20, reach);
        }
    }

    #[test]
    fn tiles_are_cut_where_the_keys_are() {
        let geometry = Geometry::new::<Aos, Ij>([1 << 20, 1 << 20, 1, 1]).expect("a geometry");
        let (keys, reach) = (([1000, 5000, 0, 0], [1900, 5900, 0, 0]), ([0; MAX_AXES], [2; MAX_AXES]));
        let tiles = |keys| Tiles::new(2, &geometry, [8; MAX_AXES], 1 << 20, reach, keys);
        let (all, found) = (tiles(None), tiles(Some(keys)));
        assert!(found.count() >= 57 && found.extent[0] == 16, "{found:?}");
        let between = |tiles: &Tiles| tiles.find([1900, 5900, 0, 0]).0.abs_diff(tiles.find([1000, 5000, 0, 0]).0);
        assert!(between(&all) < between(&found), "few of {all:?} hold keys");
        assert_eq!(found.find([1000, 5000, 0, 0]).0, 0);
    }
}
