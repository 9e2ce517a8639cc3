//! Nested blocks: the number of a cell in the order of memory, and the cell of a number.

use super::layout::{Node, NodeKind};

/// Coordinates, a number an axis.
pub(super) type Place = [i64; 4];

/// A block of cells.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// Axes and sizes in the order of memory, the last fastest.
    axes: Vec<(usize, usize)>,
    /// Whether its cells lie in Z-order.
    curve: bool,
}

impl Level {
    pub(super) fn of(node: &Node) -> Option<Self> {
        Some(Self::new(&node.axes, node.sizes.as_ref()?, node.kind == NodeKind::Morton))
    }

    pub(super) fn new(axes: &[usize], sizes: &[usize], curve: bool) -> Self {
        Self { axes: axes.iter().copied().zip(sizes.iter().copied()).collect(), curve }
    }

    pub(super) fn cells(&self) -> usize {
        self.axes.iter().map(|&(_, size)| size).product()
    }

    /// Cells along an axis.
    fn along(&self, axis: usize) -> usize {
        self.axes.iter().find(|(named, _)| *named == axis).map_or(1, |&(_, size)| size)
    }

    /// The choices that lead to a cell, the first the slowest: an axis, a number of parts, and how many cells a part is.
    fn choices(&self) -> Vec<(usize, usize, usize)> {
        if !self.curve {
            return self.axes.iter().map(|&(axis, size)| (axis, size, 1)).collect();
        }
        let widest = self.axes.iter().map(|&(_, size)| size).max().unwrap_or(1);
        let mut halves = Vec::new();
        let mut width = widest / 2;
        while width > 0 {
            halves.extend(self.axes.iter().filter(|(_, size)| width < *size).map(|&(axis, _)| (axis, 2, width)));
            width /= 2;
        }
        halves
    }
}

/// Blocks in blocks, outermost first.
#[derive(Clone, Debug, Default)]
pub(super) struct Levels(pub(super) Vec<Level>);

impl Levels {
    /// Cells along each axis.
    pub(super) fn extent(&self) -> Place {
        std::array::from_fn(|axis| self.0.iter().map(|level| level.along(axis) as i64).product())
    }

    pub(super) fn cells(&self) -> usize {
        self.0.iter().map(Level::cells).product()
    }

    /// The number of the cell at a place, which is taken modulo the extent.
    pub(super) fn number(&self, place: &Place) -> usize {
        let (mut number, mut below) = (0, self.extent());
        for level in &self.0 {
            below = std::array::from_fn(|axis| below[axis] / level.along(axis) as i64);
            for (axis, parts, width) in level.choices() {
                let digit = place[axis].div_euclid(below[axis] * width as i64).rem_euclid(parts as i64);
                number = number * parts + digit as usize;
            }
        }
        number
    }

    /// The place of a cell.
    pub(super) fn place(&self, number: usize) -> Place {
        let (mut place, mut rest) = ([0; 4], number);
        let mut below: Place = [1; 4];
        for level in self.0.iter().rev() {
            for (axis, parts, width) in level.choices().into_iter().rev() {
                place[axis] += (rest % parts * width) as i64 * below[axis];
                rest /= parts;
            }
            below = std::array::from_fn(|axis| below[axis] * level.along(axis) as i64);
        }
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_places_are_inverse() {
        let levels = Levels(vec![
            Level::new(&[1, 0], &[3, 2], false),
            Level::new(&[0, 1], &[2, 4], true),
            Level::new(&[0], &[5], false),
        ]);
        assert_eq!((levels.extent(), levels.cells()), ([20, 12, 1, 1], 240));
        for number in 0..240 {
            assert_eq!(levels.number(&levels.place(number)), number);
        }
        assert_eq!(levels.number(&[-1, -1, 0, 0]), 239);
    }

    #[test]
    fn z_order_halves_the_longest_axis_first() {
        let curve = Levels(vec![Level::new(&[0, 1], &[2, 4], true)]);
        let places: Vec<_> = (0..8).map(|n| curve.place(n)).map(|[i, j, ..]| (i, j)).collect();
        assert_eq!(places, [(0, 0), (0, 1), (1, 0), (1, 1), (0, 2), (0, 3), (1, 2), (1, 3)]);
    }
}
