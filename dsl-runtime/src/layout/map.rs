//! The address of a component: geometry is types, the record's facts are constants, both meet here.

use core::marker::PhantomData;

use super::node::order;
use super::place::{Spec, Streams, round_up};
use super::{Geometry, Inner, Layout, Place, flat};
use crate::axes::{Axes, MAX_AXES, PerAxis, sum};
use crate::field::memory::LINE;
use crate::record::{ElementList, MAX_MEMBERS, Record};

/// Where the records `R` lie in the layout `L` over `X`.
pub(crate) struct Map<R, L, X>(PhantomData<(R, L, X)>);

impl<R: Record, L: Layout<X>, X: Axes> Map<R, L, X> {
    // Tables stand behind references: a use then reads one entry, and copies nothing.
    pub(crate) const STREAMS: &'static Streams = &Streams::of(Self::SPEC, Self::PAD, R::Elements::MEMBERS, R::NAMES);
    const SPEC: Spec = <<L::Inner as Inner<X>>::Place as Place>::SPEC;
    const PAD: usize = <<L::Inner as Inner<X>>::Place as Place>::PAD;
    /// What the field's memory, and each run of a flat root, begins at a multiple of: a cache line, or what the layout asks for.
    pub(crate) const LINE: usize = if Self::PAD > LINE { Self::PAD } else { LINE };
    const EXTENT: &'static PerAxis = &<L::Inner as Inner<X>>::EXTENT;
    pub(crate) const FLAT: bool = flat::<L, X>();
    /// Cells of the innermost node (constant trees).
    const LEAF: usize = <L::Inner as Inner<X>>::LEAF;
    /// Bytes of the innermost node (constant trees).
    pub(crate) const LEAF_BYTES: usize =
        round_up(Self::STREAMS.bytes(Self::LEAF, Self::STREAMS.align), Self::STREAMS.align);
    /// Bytes of one of the root's cells (constant trees).
    pub(crate) const BLOCK_BYTES: usize =
        if Self::FLAT { 0 } else { <L::Inner as Inner<X>>::CELLS / Self::LEAF * Self::LEAF_BYTES };
    /// Where each member begins in the innermost node (constant trees).
    const STARTS: &'static [usize; MAX_MEMBERS] = &{
        let mut starts = [0; MAX_MEMBERS];
        let mut m = 0;
        while m < R::Elements::MEMBERS.len() {
            let seat = Self::STREAMS.seats[m];
            starts[m] = Self::STREAMS.start(seat.stream, Self::LEAF, Self::STREAMS.align) + seat.offset;
            m += 1;
        }
        starts
    };
    const STRIDES: &'static [usize; MAX_MEMBERS] = &{
        let mut strides = [0; MAX_MEMBERS];
        let mut m = 0;
        while m < R::Elements::MEMBERS.len() {
            strides[m] = Self::STREAMS.stride(m);
            m += 1;
        }
        strides
    };
    const COMPONENTS: &'static [usize; MAX_MEMBERS] = &{
        let mut components = [0; MAX_MEMBERS];
        let mut m = 0;
        while m < R::Elements::MEMBERS.len() {
            components[m] = Self::STREAMS.component(m, Self::LEAF, Self::STREAMS.align);
            m += 1;
        }
        components
    };

    /// The root's fastest axis, whose stride is 1 by construction: a constant.
    const FASTEST: usize = {
        let (axes, count) = order::<X>(L::ROOT);
        axes[count - 1]
    };

    /// The root's cells between neighbours along an axis.
    #[inline(always)]
    pub(crate) fn root_stride(geometry: &Geometry, axis: usize) -> usize {
        if axis == Self::FASTEST { 1 } else { geometry.stride[axis] }
    }

    /// All bytes of a field; `None` where they overflow.
    pub(crate) fn bytes(geometry: &Geometry) -> Option<usize> {
        let cells = geometry.cells as u128;
        let bytes = if Self::FLAT {
            let streams = Self::STREAMS;
            let run = |item: usize| (cells * item as u128).next_multiple_of(Self::LINE as u128);
            streams.streams[..streams.count].iter().map(|s| s.repeats as u128 * run(s.item)).sum()
        } else {
            cells * Self::BLOCK_BYTES as u128
        };
        usize::try_from(bytes).ok().filter(|&bytes| isize::try_from(bytes).is_ok())
    }

    /// Bytes between the values of member `m` of neighbouring cells of the innermost node.
    #[inline(always)]
    pub(crate) const fn stride(m: usize) -> usize {
        Self::STRIDES[m]
    }

    /// Where member `m` of a flat root, or of each innermost node, begins.
    #[inline(always)]
    pub(crate) fn start(geometry: &Geometry, m: usize) -> usize {
        if Self::FLAT {
            let seat = Self::STREAMS.seats[m];
            if Self::STREAMS.count == 1 {
                return seat.offset;
            }
            Self::flat_start(geometry.cells, seat.stream) + seat.offset
        } else {
            Self::STARTS[m]
        }
    }

    #[inline(always)]
    fn flat_start(cells: usize, stream: usize) -> usize {
        let streams = Self::STREAMS;
        let mut bytes = 0;
        // Written as a loop over a constant list: it unrolls, and is hoisted out of every loop over cells.
        for s in &streams.streams[..stream] {
            bytes += s.repeats * round_up(cells * s.item, Self::LINE);
        }
        bytes
    }

    /// Bytes between the components of member `m`.
    #[inline(always)]
    pub(crate) fn component(geometry: &Geometry, m: usize) -> usize {
        if Self::FLAT {
            let seat = Self::STREAMS.seats[m];
            if seat.split { round_up(geometry.cells * Self::STRIDES[m], Self::LINE) } else { seat.scalar }
        } else {
            Self::COMPONENTS[m]
        }
    }

    /// Bytes between the components of member `m` where they are a constant; else 0.
    pub(crate) const fn constant_component(m: usize) -> usize {
        let seat = Self::STREAMS.seats[m];
        if !seat.split {
            seat.scalar
        } else if Self::FLAT {
            0
        } else {
            Self::COMPONENTS[m]
        }
    }

    /// The offset of member `m` of the element at `at`, which lies within the shape.
    #[inline(always)]
    pub(crate) fn offset(geometry: &Geometry, m: usize, at: [u32; MAX_AXES]) -> usize {
        let start = Self::start(geometry, m);
        start.wrapping_add(sum::<X>(
            #[inline(always)]
            |a| Self::term(geometry, m, a, at[a]),
        ))
    }

    /// What coordinate `c` along `axis` adds to the offset of member `m`.
    #[inline(always)]
    pub(crate) fn term(geometry: &Geometry, m: usize, axis: usize, c: u32) -> usize {
        if Self::FLAT {
            (c as usize).wrapping_mul(Self::root_stride(geometry, axis)).wrapping_mul(Self::stride(m))
        } else {
            let extent = Self::EXTENT[axis] as u32;
            let (block, inner) = (c / extent, c % extent);
            (block as usize)
                .wrapping_mul(Self::root_stride(geometry, axis))
                .wrapping_mul(Self::BLOCK_BYTES)
                .wrapping_add(Self::inner(m, axis, inner as usize))
        }
    }

    /// What coordinate `c` within a block along `axis` adds to the offset of member `m` (constant trees).
    #[inline(always)]
    pub(crate) fn inner(m: usize, axis: usize, c: usize) -> usize {
        <L::Inner as Inner<X>>::term(axis, c, Self::LEAF_BYTES, Self::stride(m))
    }
}
