//! A list of neighbours for each particle, which holds for some steps.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope::{Readable, ShapeError};

use super::sorted::{Sorted, SortedCells};
use super::{Crowded, Options, Search, Walk};

/// Writes the list of every particle: how many there are, then which. Returns the length of the longest.
#[kernel]
pub fn fill<X: Spatial>(
    x: &Field<X::Vec<f32>, Soa>,
    starts: &Field<u32, Soa>,
    lists: &mut Field<u32, Aos, Ij>,
    cells: &Sorted<X>,
    squared: f32,
    most: i32,
) -> u32 {
    let mut longest = 0;
    for p in x {
        let own = x[p];
        let mut count = 0;
        cells.each(starts, p, own, |q| {
            if (x[q] - own).length_squared() < squared {
                count += 1;
                if count <= most {
                    lists[(p, count)] = q as u32;
                }
            }
        });
        lists[(p, 0)] = count as u32;
        longest.max_assign(count as u32);
    }
    longest
}

/// Stored lists of neighbours: of those nearer than the radius and a skin, so that they hold until a particle has moved by
/// half of the skin.
#[derive(Clone, Debug)]
pub struct NeighbourLists<X: Spatial> {
    cells: SortedCells<X>,
    lists: Field<u32, Aos, Ij>,
    squared: f32,
    most: usize,
}

/// Goes through a stored list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stored;

impl<X: Spatial> Walk<X> for Stored {
    type Axes = Ij;
    type Layout = Aos;

    #[inline(always)]
    fn each(&self, near: impl Readable<u32, Ij, Layout = Aos>, p: i32, _: X::Vec<f32>, mut visit: impl FnMut(i32)) {
        for n in 1..near.get((p, 0)) as i32 + 1 {
            visit(near.get((p, n)) as i32);
        }
    }
}

impl<X: Spatial> Search<X> for NeighbourLists<X> {
    type Walk = Stored;

    const SORTED: bool = true;
    const LASTS: bool = true;

    fn new(options: &Options<X>) -> Result<Self, ShapeError> {
        Ok(Self {
            cells: SortedCells::new(options)?,
            lists: Field::<u32, Aos>::try_new([options.particles, options.most + 1])?,
            squared: (options.radius + options.skin).powi(2),
            most: options.most,
        })
    }

    fn key(&self, x: X::Vec<f32>) -> u32 {
        self.cells.key(x)
    }

    fn update(&mut self, x: &Field<X::Vec<f32>, Soa>) -> Result<(), Crowded> {
        self.cells.update(x)?;
        let walk = self.cells.walk();
        let longest = fill::<X>(x, self.cells.near(), &mut self.lists, &walk, self.squared, self.most as i32);
        if longest as usize <= self.most {
            return Ok(());
        }
        let count = |p: usize| self.lists.get((p, 0)) as usize;
        let particle = (0..x.len()).max_by_key(|&p| (count(p), std::cmp::Reverse(p))).unwrap_or(0);
        Err(Crowded { particle, count: count(particle), most: self.most, in_cell: false })
    }

    fn near(&self) -> &Field<u32, Aos, Ij> {
        &self.lists
    }

    fn walk(&self) -> Stored {
        Stored
    }

    fn bytes(&self) -> usize {
        self.cells.bytes() + self.lists.bytes()
    }
}
