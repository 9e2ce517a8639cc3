//! The run-time part of a layout: a field's extents and the root's strides.

use super::{Layout, node::order};
use crate::axes::{AXIS_NAMES, Axes, MAX_AXES, PerAxis};
use crate::field::ShapeError;

/// A field's extents, and how its root lies in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Geometry {
    /// Elements along each axis; 1 beyond the rank.
    pub(crate) shape: [u32; MAX_AXES],
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
        let block = const { L::CHAIN.extent };
        let mut this = Self { shape: [1; MAX_AXES], blocks: [1; MAX_AXES], stride: [0; MAX_AXES], cells: 1 };
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

    /// The geometry of the branches behind the first in a field of this geometry.
    #[inline(always)]
    pub(crate) fn rest<L: Layout<X>, X: Axes>(&self) -> Self {
        let chain = const { &<L::Rest as Layout<X>>::CHAIN };
        let (axes, count) = const { order::<X>(<L::Rest as Layout<X>>::CHAIN.root) };
        let mut this = Self { shape: self.shape, blocks: [1; MAX_AXES], stride: [0; MAX_AXES], cells: 1 };
        for &axis in axes[..count].iter().rev() {
            this.blocks[axis] = (self.shape[axis] as usize).div_ceil(chain.extent[axis]);
            this.stride[axis] = this.cells;
            // No overflow: the field was made with such branches.
            this.cells = this.cells.wrapping_mul(this.blocks[axis]);
        }
        this
    }

    /// Elements in all.
    pub(crate) fn len(&self) -> usize {
        self.shape.iter().map(|&n| n as usize).product()
    }

    /// The extents along the axes `X`.
    pub(crate) fn extents<X: Axes>(&self) -> X::Extents {
        X::extents(self.shape.map(|n| n as usize))
    }
}
