//! The run-time part of a layout: a field's extents and the root's strides.

use super::{Layout, node::order};
use crate::axes::{AXIS_NAMES, Axes, MAX_AXES, PerAxis, per_axis};
use crate::field::ShapeError;

/// A field's extents, where its indices begin, and how its root lies in memory.
///
/// Coordinates are of two kinds. Logical ones are what the user writes; they begin at the origin. Places begin at zero: addresses
/// are computed from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub struct Geometry {
    /// Elements along each axis; 1 beyond the rank.
    pub(crate) shape: [u32; MAX_AXES],
    /// The first index along each axis, 0 beyond the rank. It and the one after the last index are `i32`s.
    pub(crate) origin: [i32; MAX_AXES],
    /// The root's cells along each axis.
    pub(crate) blocks: PerAxis,
    /// The root's cells between neighbours along each axis.
    pub(crate) stride: PerAxis,
    /// The root's cells in all.
    pub(crate) cells: usize,
}

impl Geometry {
    /// The geometry of a field of so many elements.
    pub(crate) fn new<L: Layout<X>, X: Axes>(extents: PerAxis) -> Result<Self, ShapeError> {
        if L::BRANCHES > 1 {
            Self::new::<L::Rest, X>(extents)?;
        }
        let (axes, count) = const { order::<X>(L::CHAIN.root) };
        let block = const { L::CHAIN.root_extent() };
        let mut this = Self {
            shape: [1; MAX_AXES],
            origin: [0; MAX_AXES],
            blocks: [1; MAX_AXES],
            stride: [0; MAX_AXES],
            cells: 1,
        };
        for axis in 0..X::RANK {
            let extent = extents[axis];
            if i32::try_from(extent).is_err() {
                return Err(ShapeError::Extent { axis: AXIS_NAMES[axis], extent });
            }
            this.shape[axis] = extent as u32;
            if axes[..count].contains(&axis) {
                this.blocks[axis] = extent.div_ceil(block[axis]);
            } else if extent > block[axis] {
                return Err(ShapeError::Axis { axis: AXIS_NAMES[axis], extent, most: block[axis] });
            }
        }
        for &axis in axes[..count].iter().rev() {
            this.stride[axis] = this.cells;
            this.cells = this
                .cells
                .checked_mul(this.blocks[axis])
                .ok_or_else(|| ShapeError::TooLarge { shape: extents[..X::RANK].to_vec() })?;
        }
        Ok(this)
    }

    /// The geometry of a field without bounds: its indices are all from `i32::MIN` to before `i32::MAX`, but those of lists, which
    /// begin at zero.
    pub(crate) fn unbounded<L: Layout<X>, X: Axes>() -> Self {
        let list = L::CHAIN.tree.and_then(|tree| tree.list);
        let is_list = |axis: usize| list.is_some_and(|list| list.axis == axis);
        let extent = |axis: usize| match list {
            Some(list) if list.axis == axis => list.most as u32,
            _ if axis < X::RANK => u32::MAX,
            _ => 1,
        };
        Self {
            shape: per_axis(extent),
            origin: per_axis(|axis| if axis < X::RANK && !is_list(axis) { i32::MIN } else { 0 }),
            blocks: [1; MAX_AXES],
            stride: [0; MAX_AXES],
            cells: 0,
        }
    }

    /// The geometry of the branches behind the first in a field of this geometry.
    #[inline(always)]
    pub(crate) fn rest<L: Layout<X>, X: Axes>(&self) -> Self {
        let extent = const { &<L::Rest as Layout<X>>::CHAIN.root_extent() };
        let (axes, count) = const { order::<X>(<L::Rest as Layout<X>>::CHAIN.root) };
        let (shape, origin) = (self.shape, self.origin);
        let mut this = Self { shape, origin, blocks: [1; MAX_AXES], stride: [0; MAX_AXES], cells: 1 };
        for &axis in axes[..count].iter().rev() {
            this.blocks[axis] = (self.shape[axis] as usize).div_ceil(extent[axis]);
            this.stride[axis] = this.cells;
            // No overflow: the field was made with such branches.
            this.cells = this.cells.wrapping_mul(this.blocks[axis]);
        }
        this
    }

    /// The same with indices that begin at `origin`.
    pub(crate) fn with_origin<X: Axes>(mut self, origin: [i64; MAX_AXES]) -> Result<Self, ShapeError> {
        for axis in 0..X::RANK {
            let (first, extent) = (origin[axis], self.shape[axis]);
            let error = ShapeError::Origin { axis: AXIS_NAMES[axis], origin: first, extent: extent as usize };
            let narrow = i32::try_from(first).map_err(|_| error.clone())?;
            // The one after the last index is an `i32` as well: loops count up to it.
            narrow.checked_add_unsigned(extent).ok_or(error)?;
            self.origin[axis] = narrow;
        }
        Ok(self)
    }

    /// Elements in all.
    pub(crate) fn len(&self) -> usize {
        self.shape.iter().fold(1, |len: usize, &n| len.saturating_mul(n as usize))
    }

    /// The extents along the axes `X`.
    pub(crate) fn extents<X: Axes>(&self) -> X::Extents {
        X::extents(self.shape.map(|n| n as usize))
    }

    /// The logical coordinates of a place within the shape: they lie below the origin plus the extent, which is an `i32`.
    #[inline(always)]
    pub(crate) fn logical(&self, place: [u32; MAX_AXES]) -> [i32; MAX_AXES] {
        per_axis(
            #[inline(always)]
            |a| self.origin[a].wrapping_add_unsigned(place[a]),
        )
    }

    /// The place of logical coordinates that lie within the shape.
    #[inline(always)]
    pub(crate) fn place(&self, at: [i64; MAX_AXES]) -> [u32; MAX_AXES] {
        per_axis(
            #[inline(always)]
            |a| (at[a] as u32).wrapping_sub(self.origin[a] as u32),
        )
    }

    /// The origin where it is not zero, for messages.
    pub(crate) fn moved<X: Axes>(&self) -> Option<&[i32]> {
        let origin = &self.origin[..X::RANK];
        origin.iter().any(|&first| first != 0).then_some(origin)
    }
}
