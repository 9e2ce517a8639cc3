//! A list of particles for each cell.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{Readable, ShapeError};

use super::cells::Cells;
use super::{Crowded, MOST_IN_CELL, Options, Search, Walk};

/// Lists of up to [`MOST_IN_CELL`] particles, one a cell.
pub(super) type Lists = layout!(dense(i).dynamic(j, 128).aos);

/// Puts every particle into the list of its cell. Returns how many found it full.
#[kernel]
pub fn bin<X: Spatial>(x: &Field<X::Vec<f32>, Soa>, lists: &mut Field<u32, Lists, Ij>, cells: &Cells<X>) -> u32 {
    let mut full = 0;
    lists.clear();
    for p in x {
        let cell = cells.number(cells.cell(x[p]));
        full += u32::from(lists.try_append(cell, p as u32).is_none());
    }
    full
}

/// Cells with a `dynamic` list of particles each. Particles may lie in memory in any order.
#[derive(Clone, Debug)]
pub struct CellLists<X: Spatial> {
    cells: Cells<X>,
    lists: Field<u32, Lists, Ij>,
}

/// Goes through the lists of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listed<X: Spatial> {
    cells: Cells<X>,
}

impl<X: Spatial> Walk<X> for Listed<X> {
    type Axes = Ij;
    type Layout = Lists;

    #[inline(always)]
    fn each(&self, near: impl Readable<u32, Ij, Layout = Lists>, _: i32, x: X::Vec<f32>, mut visit: impl FnMut(i32)) {
        self.cells.rows(
            x,
            #[inline(always)]
            |first, last| {
                for cell in first..last + 1 {
                    for entry in 0..near.row_len(cell) {
                        visit(near.get((cell, entry)) as i32);
                    }
                }
            },
        );
    }
}

impl<X: Spatial> Search<X> for CellLists<X> {
    type Walk = Listed<X>;

    const SORTED: bool = false;
    const LASTS: bool = false;

    fn new(options: &Options<X>) -> Result<Self, ShapeError> {
        let cells = Cells::new(options);
        Ok(Self { cells, lists: Field::<u32, Lists>::try_new([cells.len()])? })
    }

    fn key(&self, x: X::Vec<f32>) -> u32 {
        self.cells.number(self.cells.cell(x)) as u32
    }

    fn update(&mut self, x: &Field<X::Vec<f32>, Soa>) -> Result<(), Crowded> {
        match bin::<X>(x, &mut self.lists, &self.cells) {
            0 => Ok(()),
            _ => Err(crowded::<X, _>(x, |x| self.key(x))),
        }
    }

    fn near(&self) -> &Field<u32, Lists, Ij> {
        &self.lists
    }

    fn walk(&self) -> Listed<X> {
        Listed { cells: self.cells }
    }

    fn bytes(&self) -> usize {
        self.lists.bytes()
    }
}

/// The fullest cell, and the first particle in it.
pub(super) fn crowded<X: Spatial, K: Ord>(x: &Field<X::Vec<f32>, Soa>, key: impl Fn(X::Vec<f32>) -> K) -> Crowded {
    let mut keys: Vec<(K, usize)> = x.iter().enumerate().map(|(p, x)| (key(x), p)).collect();
    keys.sort_unstable();
    let fullest = keys.chunk_by(|a, b| a.0 == b.0).max_by_key(|cell| cell.len()).unwrap_or(&[]);
    let particle = fullest.first().map_or(0, |&(_, p)| p);
    Crowded { particle, count: fullest.len(), most: MOST_IN_CELL, in_cell: true }
}
