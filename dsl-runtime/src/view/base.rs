//! A base index checked once for all constant offsets of a stencil.

use core::marker::PhantomData;

use super::Site;
use crate::axes::{Axes, MAX_AXES, all, per_axis};
use crate::index::inside;
use crate::layout::Geometry;

/// A base whose whole box of offsets lies within a field's indices.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Based<X> {
    /// The base's place; in wrapping arithmetic, since its own cell may lie below zero.
    base: [u32; MAX_AXES],
    low: [i32; MAX_AXES],
    high: [i32; MAX_AXES],
    /// The field that was checked. The macro uses a base for the field that it was made from alone.
    shape: [u32; MAX_AXES],
    origin: [i32; MAX_AXES],
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
        let wide = |offsets: [i64; N]| {
            let mut all = [0; MAX_AXES];
            all[..N].copy_from_slice(&offsets);
            all
        };
        Self::around(geometry, base, wide(low), wide(high))
    }

    /// The same with offsets for all axes that there could be.
    #[inline(always)]
    pub(super) fn around(
        geometry: &Geometry,
        base: [i64; MAX_AXES],
        low: [i64; MAX_AXES],
        high: [i64; MAX_AXES],
    ) -> Option<Self> {
        let (shape, origin) = (geometry.shape, geometry.origin);
        let fits = all::<X>(
            #[inline(always)]
            |a| {
                // `base` came from integers of at most 64 bits: extremes must not wrap around.
                let (first, last) = (base[a].saturating_add(low[a]), base[a].saturating_add(high[a]));
                let start = i64::from(origin[a]);
                (first >= start) & (last < start + i64::from(shape[a]))
            },
        );
        let narrow = |offsets: [i64; MAX_AXES]| {
            per_axis(
                #[inline(always)]
                |a| if a < X::RANK { offsets[a] as i32 } else { 0 },
            )
        };
        fits.then(
            #[inline(always)]
            || Self {
                base: geometry.place(base),
                low: narrow(low),
                high: narrow(high),
                shape,
                origin,
                axes: PhantomData,
            },
        )
    }

    /// `base + offset` where the offset lies in the box, which folds to nothing for unrolled offsets. Otherwise the sum
    /// is checked by itself.
    #[inline(always)]
    #[track_caller]
    pub(super) fn plus(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        let inside = all::<X>(
            #[inline(always)]
            |a| (offset[a] >= i64::from(self.low[a])) & (offset[a] <= i64::from(self.high[a])),
        );
        if !inside {
            return self.far(offset, site);
        }
        per_axis(
            #[inline(always)]
            |a| if a < X::RANK { self.base[a].wrapping_add(offset[a] as u32) } else { 0 },
        )
    }

    #[cold]
    #[inline(never)]
    #[track_caller]
    fn far(&self, offset: [i64; MAX_AXES], site: &'static Site) -> [u32; MAX_AXES] {
        let place = per_axis(|a| i64::from(self.base[a] as i32).saturating_add(offset[a]));
        inside::<X>(place, &self.shape).unwrap_or_else(|| {
            let at = per_axis(|a| place[a].saturating_add(i64::from(self.origin[a])));
            site.missed(&at[..X::RANK], &self.shape[..X::RANK], &self.origin[..X::RANK])
        })
    }
}
