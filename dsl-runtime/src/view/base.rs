//! A base index checked once for all constant offsets of a stencil.

use core::marker::PhantomData;

use crate::axes::{Axes, MAX_AXES, all};
use crate::layout::Geometry;

/// A base whose whole box of offsets lies within a shape.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Based<X> {
    /// The base; in wrapping arithmetic, since its own cell may lie below zero.
    base: [u32; MAX_AXES],
    low: [i32; MAX_AXES],
    high: [i32; MAX_AXES],
    /// The shape that was checked: another field's is checked anew.
    shape: [u32; MAX_AXES],
    axes: PhantomData<X>,
}

impl<X: Axes> Based<X> {
    #[inline(always)]
    pub(super) fn new<const N: usize>(
        geometry: &Geometry,
        base: [i64; MAX_AXES],
        low: [i64; N],
        high: [i64; N],
    ) -> Option<Self> {
        assert!(N == X::RANK);
        let shape = geometry.shape;
        let fits = all::<X>(
            #[inline(always)]
            |a| {
                // `base` came from integers of at most 64 bits: extremes must not wrap around.
                let (first, last) = (base[a].saturating_add(low[a]), base[a].saturating_add(high[a]));
                (first >= 0) & (last < i64::from(shape[a]))
            },
        );
        let per_axis = |offsets: [i64; N]| {
            core::array::from_fn(
                #[inline(always)]
                |a| if a < N { offsets[a] as i32 } else { 0 },
            )
        };
        fits.then(
            #[inline(always)]
            || Self { base: base.map(|b| b as u32), low: per_axis(low), high: per_axis(high), shape, axes: PhantomData },
        )
    }

    /// `base + offset` where the offset lies in the box and the field has the shape that was checked: both fold to
    /// constants for unrolled offsets. Otherwise the sum is checked by itself.
    #[inline(always)]
    pub(super) fn within(&self, geometry: &Geometry, offset: [i64; MAX_AXES]) -> Option<[u32; MAX_AXES]> {
        let inside = all::<X>(
            #[inline(always)]
            |a| (offset[a] >= i64::from(self.low[a])) & (offset[a] <= i64::from(self.high[a])),
        );
        let same = all::<X>(
            #[inline(always)]
            |a| geometry.shape[a] == self.shape[a],
        );
        if inside && same {
            let mut at = [0; MAX_AXES];
            for (a, c) in at.iter_mut().enumerate().take(X::RANK) {
                *c = self.base[a].wrapping_add(offset[a] as u32);
            }
            Some(at)
        } else {
            crate::index::within::<X>(self.plus(offset), &geometry.shape)
        }
    }

    /// `base + offset`.
    #[inline(always)]
    pub(super) fn plus(&self, offset: [i64; MAX_AXES]) -> [i64; MAX_AXES] {
        core::array::from_fn(
            #[inline(always)]
            |a| i64::from(self.base[a] as i32).saturating_add(offset[a]),
        )
    }
}
