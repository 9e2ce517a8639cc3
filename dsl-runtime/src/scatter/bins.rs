//! The elements of a loop in the order of the tiles that they update: a stable counting sort of pieces of the loop.

use core::marker::PhantomData;
use core::sync::atomic::{AtomicU64, Ordering};

use super::tiles::Tiles;
use crate::axes::{Axes, MAX_AXES, all, per_axis};
use crate::launch::{Cell, Space, results_of_jobs, run_jobs};

/// Neighbouring elements of a loop: the number of the first, and how many.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub(crate) first: u32,
    pub(crate) len: u32,
}

/// Pieces in memory that several threads fill.
#[doc(hidden)]
#[derive(Debug, Default)]
pub(crate) struct PackedPiece(AtomicU64);

impl PackedPiece {
    fn set(&self, piece: Piece) {
        self.0.store(u64::from(piece.first) | u64::from(piece.len) << 32, Ordering::Relaxed);
    }

    #[inline(always)]
    pub(crate) fn get(&self) -> Piece {
        let bits = self.0.load(Ordering::Relaxed);
        Piece { first: bits as u32, len: (bits >> 32) as u32 }
    }
}

/// A piece whose elements have keys in one tile.
#[derive(Clone, Copy, Debug)]
struct Found {
    piece: Piece,
    tile: u32,
}

/// Logical coordinates of an element of a field.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Coordinates<X>(pub(crate) [i64; MAX_AXES], pub(crate) PhantomData<X>);

/// The box of a loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    /// The first of its elements, and the number of elements along each axis.
    first: [i64; MAX_AXES],
    extent: [u64; MAX_AXES],
    /// The axis along which runs lie.
    axis: usize,
    /// Elements in all.
    pub(crate) elements: usize,
}

impl Bounds {
    pub(crate) fn of<S: Space>(space: &S) -> Self {
        let (first, end) = space.bounds();
        let extent = per_axis(|a| if a < S::RANK { end[a].wrapping_sub(first[a]) as u64 } else { 1 });
        Self { first, extent, axis: S::AXIS, elements: space.elements() }
    }
}

/// Takes the keys of a loop's elements, in the order of the loop.
#[doc(hidden)]
#[derive(Debug)]
pub struct Sink {
    tiles: Tiles,
    bounds: Bounds,
    /// The tile of the last key: its first coordinates and extents.
    start: [i64; MAX_AXES],
    within: [u64; MAX_AXES],
    tile: u32,
    open: Option<Found>,
    found: Vec<Found>,
    wanted: Wanted,
}

/// What a sink makes of keys.
#[derive(Debug)]
pub(super) enum Wanted {
    /// Pieces of one tile.
    Pieces,
    /// The least and largest.
    Span(Span),
    /// The parts of a box that they lie in.
    Parts(Marks),
}

/// The least and largest keys.
pub(super) type Span = ([i64; MAX_AXES], [i64; MAX_AXES]);

/// The span of no key.
const NO_KEYS: Span = ([i64::MAX; MAX_AXES], [i64::MIN; MAX_AXES]);

/// Parts of a box, of which it has some hundred, and which of them keys lie in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Marks {
    span: Span,
    /// Parts along each axis.
    parts: usize,
    rank: usize,
    found: [u64; 16],
}

impl Marks {
    fn new(span: Span, rank: usize) -> Self {
        let parts = [1024, 32, 10, 5][rank.clamp(1, 4) - 1];
        Self { span, parts, rank, found: [0; 16] }
    }

    fn mark(&mut self, key: [i64; MAX_AXES]) {
        let (low, high) = self.span;
        let part = (0..self.rank).fold(0, |part, a| {
            let (along, extent) = (key[a].clamp(low[a], high[a]).abs_diff(low[a]), high[a].abs_diff(low[a]));
            // Keys may be any numbers, also such as no field has.
            part * self.parts + (u128::from(along) * self.parts as u128 / (u128::from(extent) + 1)) as usize
        });
        self.found[part / 64] |= 1 << (part % 64);
    }

    /// The share of the parts that keys lie in.
    fn share(&self) -> f64 {
        let found: u32 = self.found.iter().map(|bits| bits.count_ones()).sum();
        f64::from(found) / self.parts.pow(self.rank as u32) as f64
    }
}

impl Sink {
    pub(super) fn new(bounds: &Bounds, tiles: &Tiles, wanted: Wanted) -> Self {
        Self {
            tiles: *tiles,
            bounds: *bounds,
            start: [0; MAX_AXES],
            within: [0; MAX_AXES],
            tile: 0,
            open: None,
            found: Vec::new(),
            wanted,
        }
    }

    /// Takes the key of an element: where it updates. One without a key goes with the last.
    #[inline(always)]
    pub fn put<S: Space, X: Axes>(&mut self, cell: &Cell<'_, S>, key: Option<Coordinates<X>>) {
        if let Some(Coordinates(key, _)) = key
            && !self.holds::<X>(&key)
        {
            self.enter(key);
        }
        let at = cell.at();
        let along = (at[S::AXIS] - self.bounds.first[S::AXIS]) as u64;
        let number = if S::RANK == 1 { along as u32 } else { self.number(at) };
        match &mut self.open {
            Some(open)
                if open.tile == self.tile
                    && open.piece.first + open.piece.len == number
                    && (S::RANK == 1 || along != 0) =>
            {
                open.piece.len += 1;
            }
            _ => self.begin(number),
        }
    }

    #[inline(always)]
    fn holds<X: Axes>(&self, key: &[i64; MAX_AXES]) -> bool {
        all::<X>(
            #[inline(always)]
            |a| (key[a].wrapping_sub(self.start[a]) as u64) < self.within[a],
        )
    }

    fn enter(&mut self, key: [i64; MAX_AXES]) {
        match &mut self.wanted {
            Wanted::Pieces => {
                (self.tile, self.start) = self.tiles.find(key);
                self.within = self.tiles.extent().map(u64::from);
            }
            Wanted::Span((low, high)) => {
                for a in 0..MAX_AXES {
                    low[a] = low[a].min(key[a]);
                    high[a] = high[a].max(key[a]);
                }
            }
            Wanted::Parts(marks) => marks.mark(key),
        }
    }

    fn begin(&mut self, number: u32) {
        if matches!(self.wanted, Wanted::Pieces) {
            self.found.extend(self.open.replace(Found { piece: Piece { first: number, len: 1 }, tile: self.tile }));
        }
    }

    /// The number of an element: the loop's run axis is fastest.
    fn number(&self, at: [i64; MAX_AXES]) -> u32 {
        let Bounds { first, extent, axis, .. } = &self.bounds;
        let mut number = 0;
        for a in (0..MAX_AXES).filter(|a| a != axis).chain([*axis]) {
            number = number * extent[a] + (at[a] - first[a]) as u64;
        }
        number as u32
    }

    /// Whether pieces are so short that the loop's order has nothing to do with the tiles.
    pub(super) fn is_scattered(&self) -> bool {
        const SHORT: usize = 4;
        let elements: usize = self.found.iter().map(|found| found.piece.len as usize).sum();
        elements < self.found.len() * SHORT
    }

    /// Ends the list of pieces.
    fn close(&mut self) {
        self.found.extend(self.open.take());
    }
}

/// The pieces of a loop, tile by tile, and the tiles by colour.
#[derive(Debug)]
pub(crate) struct Bins {
    tiles: Tiles,
    pieces: Vec<PackedPiece>,
    jobs: Vec<Job>,
    /// Where the jobs of each colour end.
    colours: Vec<usize>,
}

/// A tile with elements.
#[derive(Clone, Copy, Debug)]
struct Job {
    tile: u32,
    first: usize,
    end: usize,
}

impl Bins {
    /// Sorts a loop: `keys` puts those of one of so many blocks into a sink.
    pub(super) fn new(
        bounds: &Bounds,
        tiles: &Tiles,
        threads: usize,
        blocks: usize,
        keys: &(dyn Fn(usize, &mut Sink) + Sync),
    ) -> Self {
        let lists = results_of_jobs(threads, blocks, &|block| {
            let mut sink = Sink::new(bounds, tiles, Wanted::Pieces);
            keys(block, &mut sink);
            sink.close();
            sink.found
        });
        Self::sorted(*tiles, threads, &lists)
    }

    fn sorted(tiles: Tiles, threads: usize, lists: &[Vec<Found>]) -> Self {
        let count = tiles.count() as usize;
        // Neighbouring lists go together: the order does not depend on how many do.
        let groups = threads.min(lists.len()).max(1);
        let group = |g: usize| lists[lists.len() * g / groups..lists.len() * (g + 1) / groups].iter().flatten();
        // From counts to where each group's pieces of each tile begin.
        let mut begins = results_of_jobs(threads, groups, &|g| {
            let mut counts = vec![0u32; count];
            group(g).for_each(|found| counts[found.tile as usize] += 1);
            counts
        });
        let mut by_colour: Vec<Vec<Job>> = vec![Vec::new(); tiles.colours()];
        let mut next = 0;
        for tile in 0..count {
            let first = next as usize;
            for counts in &mut begins {
                next += core::mem::replace(&mut counts[tile], next);
            }
            if next as usize > first {
                by_colour[tiles.colour(tile as u32)].push(Job { tile: tile as u32, first, end: next as usize });
            }
        }
        let pieces: Vec<PackedPiece> = (0..next).map(|_| PackedPiece::default()).collect();
        run_jobs(threads, groups, &|g| {
            let mut begins = begins[g].clone();
            for found in group(g) {
                let place = &mut begins[found.tile as usize];
                pieces[*place as usize].set(found.piece);
                *place += 1;
            }
        });
        let colours = by_colour.iter().scan(0, |end, jobs| {
            *end += jobs.len();
            Some(*end)
        });
        Self { tiles, pieces, colours: colours.collect(), jobs: by_colour.concat() }
    }

    pub(super) fn tiles(&self) -> &Tiles {
        &self.tiles
    }

    /// How many tiles have elements.
    pub(crate) fn jobs(&self) -> usize {
        self.jobs.len()
    }

    /// The tile of a number.
    pub(super) fn tile(&self, number: usize) -> u32 {
        self.jobs[number].tile
    }

    /// The numbers of the tiles of each colour.
    pub(super) fn colours(&self) -> impl Iterator<Item = core::ops::Range<usize>> + '_ {
        let first = core::iter::once(0).chain(self.colours.iter().copied());
        first.zip(&self.colours).map(|(first, &end)| first..end)
    }

    /// The pieces of the elements of a tile.
    pub(crate) fn pieces(&self, number: usize) -> &[PackedPiece] {
        let job = self.jobs[number];
        &self.pieces[job.first..job.end]
    }
}

/// About how many cells the keys of a loop lie among, between the least and largest; none where it has no keys. Between two keys of a sample
/// there may be more of the others.
pub(super) fn cells_around(
    bounds: &Bounds,
    tiles: &Tiles,
    rank: usize,
    blocks: usize,
    keys: &(dyn Fn(usize, &mut Sink) + Sync),
) -> Option<usize> {
    let span = span(bounds, tiles, 1, blocks, keys)?;
    let mut sink = Sink::new(bounds, tiles, Wanted::Parts(Marks::new(span, rank)));
    (0..blocks).for_each(|block| keys(block, &mut sink));
    let Wanted::Parts(marks) = sink.wanted else { return None };
    let extents = span.0.iter().zip(&span.1).take(rank).map(|(low, high)| high.abs_diff(*low) as f64 + 1.0);
    Some((extents.product::<f64>() * marks.share()) as usize)
}

/// The least and largest keys of a loop; none where it has none.
pub(super) fn span(
    bounds: &Bounds,
    tiles: &Tiles,
    threads: usize,
    blocks: usize,
    keys: &(dyn Fn(usize, &mut Sink) + Sync),
) -> Option<Span> {
    let spans = results_of_jobs(threads, blocks, &|block| {
        let mut sink = Sink::new(bounds, tiles, Wanted::Span(NO_KEYS));
        keys(block, &mut sink);
        match sink.wanted {
            Wanted::Span(span) => span,
            _ => NO_KEYS,
        }
    });
    let wider = |(low, high): ([i64; MAX_AXES], [i64; MAX_AXES]),
                 (lower, higher): ([i64; MAX_AXES], [i64; MAX_AXES])| {
        (core::array::from_fn(|a| low[a].min(lower[a])), core::array::from_fn(|a| high[a].max(higher[a])))
    };
    spans.into_iter().reduce(wider).filter(|(low, high)| low[0] <= high[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_found_whatever_the_keys_are() {
        let far = i64::MAX;
        for span in [([0; 4], [99; 4]), ([-far - 1; 4], [far; 4]), ([7; 4], [7; 4])] {
            for rank in 1..=4 {
                let mut marks = Marks::new(span, rank);
                for key in [span.0, span.1, [far; 4], [-far; 4]] {
                    marks.mark(key);
                }
                // Both ends, which of one cell are the same.
                let ends = if span.0 == span.1 { 1.0 } else { 2.0 };
                assert_eq!(marks.share() * (marks.parts as f64).powi(rank as i32), ends, "{span:?}, {rank} axes");
            }
        }
    }

    #[test]
    fn the_share_of_parts_is_that_of_where_keys_lie() {
        let mut marks = Marks::new(([0; 4], [1023; 4]), 2);
        (0..512).for_each(|i| (0..256).for_each(|j| marks.mark([i, j, 0, 0])));
        assert_eq!(marks.share(), 0.125);
    }
}
