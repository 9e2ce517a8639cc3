//! Lists of particles for the cells that hold any, found by hashing.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{Readable, ShapeError};

use super::cells::cell_side;
use super::listed::crowded;
use super::{Crowded, Options, Search, Walk};

/// Lists of up to [`MOST_IN_CELL`](super::MOST_IN_CELL) particles, one a cell that holds any; a plane is the layer 0.
pub(super) type Lists = layout!(hash(ijk).dynamic(l, 128).aos);

/// Cells without bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hashed {
    inv_side: f32,
}

impl Hashed {
    /// The cell of a place.
    #[inline(always)]
    pub fn cell<X: Spatial>(&self, x: X::Vec<f32>) -> IVec3 {
        let along = |axis: usize| (x[axis] * self.inv_side).floor() as i32;
        ivec3(along(0), along(1), if X::RANK > 2 { along(2) } else { 0 })
    }
}

/// Puts every particle into the list of its cell. Returns how many found it full.
#[kernel]
pub fn bin<X: Spatial>(x: &Field<X::Vec<f32>, Soa>, lists: &mut Field<u32, Lists, Ijkl>, cells: &Hashed) -> u32 {
    let mut full = 0;
    lists.clear();
    for p in x {
        full += u32::from(lists.try_append(cells.cell::<X>(x[p]), p as u32).is_none());
    }
    full
}

/// Cells found by hashing, with a `dynamic` list of particles each: there are as many as hold particles, wherever these
/// are. Particles may lie in memory in any order.
#[derive(Clone, Debug)]
pub struct HashedCells<X: Spatial> {
    cells: Hashed,
    lists: Field<u32, Lists, Ijkl>,
    axes: std::marker::PhantomData<X>,
}

impl<X: Spatial> Walk<X> for Hashed {
    type Axes = Ijkl;
    type Layout = Lists;

    #[inline(always)]
    fn each(&self, near: impl Readable<u32, Ijkl, Layout = Lists>, _: i32, x: X::Vec<f32>, mut visit: impl FnMut(i32)) {
        let cell = self.cell::<X>(x);
        let depth = i32::from(X::RANK > 2);
        for i in cell.x - 1..cell.x + 2 {
            for j in cell.y - 1..cell.y + 2 {
                for k in cell.z - depth..cell.z + depth + 1 {
                    for entry in 0..near.row_len((i, j, k)) as i32 {
                        visit(near.get((i, j, k, entry)) as i32);
                    }
                }
            }
        }
    }
}

impl<X: Spatial> Search<X> for HashedCells<X> {
    type Walk = Hashed;

    const SORTED: bool = false;
    const LASTS: bool = false;

    fn new(options: &Options<X>) -> Result<Self, ShapeError> {
        let cells = Hashed { inv_side: cell_side(options).recip() };
        Ok(Self { cells, lists: Field::unbounded(), axes: std::marker::PhantomData })
    }

    fn key(&self, x: X::Vec<f32>) -> u32 {
        // The 10 lowest bits along each axis, one row after another.
        let cell = self.cells.cell::<X>(x) & 1023;
        ((cell.x << 20) | (cell.y << 10) | cell.z) as u32
    }

    fn update(&mut self, x: &Field<X::Vec<f32>, Soa>) -> Result<(), Crowded> {
        match bin::<X>(x, &mut self.lists, &self.cells) {
            0 => Ok(()),
            _ => Err(crowded::<X, _>(x, |x| self.cells.cell::<X>(x).to_array())),
        }
    }

    fn near(&self) -> &Field<u32, Lists, Ijkl> {
        &self.lists
    }

    fn walk(&self) -> Hashed {
        self.cells
    }

    fn bytes(&self) -> usize {
        self.lists.bytes()
    }
}
