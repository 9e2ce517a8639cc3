//! Particles in the order of their cells, and where each cell begins.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{Readable, ShapeError};

use super::cells::Cells;
use super::{Crowded, Options, Search, Walk};

/// How many particles each cell has.
#[kernel]
pub fn count<X: Spatial>(x: &Field<X::Vec<f32>, Soa>, counts: &mut Field<u32, Soa>, cells: &Cells<X>) {
    for p in x {
        counts[cells.number(cells.cell(x[p]))] += 1;
    }
}

/// Puts zeros into a field.
#[kernel]
pub fn empty(counts: &mut Field<u32, Soa>) {
    for cell in counts {
        counts[cell] = 0;
    }
}

/// Sorted cells: particles lie in memory in the order of their cells, and a field tells where each cell begins.
#[derive(Clone, Debug)]
pub struct SortedCells<X: Spatial> {
    cells: Cells<X>,
    /// Where each cell begins, and behind the last where it ends.
    starts: Field<u32, Soa>,
}

/// Goes through sorted cells: all cells of a row at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sorted<X: Spatial> {
    cells: Cells<X>,
}

impl<X: Spatial> Walk<X> for Sorted<X> {
    type Axes = I;
    type Layout = Soa;

    #[inline(always)]
    fn each(&self, near: impl Readable<u32, I, Layout = Soa>, _: i32, x: X::Vec<f32>, mut visit: impl FnMut(i32)) {
        self.cells.rows(
            x,
            #[inline(always)]
            |first, last| {
                for q in near.get(first)..near.get(last + 1) {
                    visit(q as i32);
                }
            },
        );
    }
}

impl<X: Spatial> Search<X> for SortedCells<X> {
    type Walk = Sorted<X>;

    const SORTED: bool = true;
    const LASTS: bool = false;

    fn new(options: &Options<X>) -> Result<Self, ShapeError> {
        let cells = Cells::new(options);
        Ok(Self { cells, starts: Field::<u32, Soa>::try_new([cells.len() + 1])? })
    }

    fn key(&self, x: X::Vec<f32>) -> u32 {
        self.cells.number(self.cells.cell(x)) as u32
    }

    fn update(&mut self, x: &Field<X::Vec<f32>, Soa>) -> Result<(), Crowded> {
        empty(&mut self.starts);
        count::<X>(x, &mut self.starts, &self.cells);
        self.starts.exclusive_scan();
        Ok(())
    }

    fn near(&self) -> &Field<u32, Soa> {
        &self.starts
    }

    fn walk(&self) -> Sorted<X> {
        Sorted { cells: self.cells }
    }

    fn bytes(&self) -> usize {
        self.starts.bytes()
    }
}
