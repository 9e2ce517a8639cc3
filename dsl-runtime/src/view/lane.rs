//! A path of a field by index, its member's start found once.

use core::marker::PhantomData;

use super::{Based, Site};
use crate::axes::{Axes, MAX_AXES, sum};
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::{Block, Geometry, Layout, Map};
use crate::record::{Path, Record};

/// Where the values of a path lie, by index.
pub(super) struct Lane<'a, R, L, X, P> {
    handle: Handle<'a, R, L, X>,
    site: &'static Site,
    /// The member's first component at the field's first element.
    start: *mut u8,
    /// What stands where there is no block (sparse branches).
    background: *mut u8,
    component: usize,
    path: PhantomData<P>,
}

/// Where an element of a field stands: by its place alone, or beside a base whose blocks are known.
pub(super) trait Spot<L: Layout<X>, X: Axes>: Copy {
    /// Its place.
    fn place(&self) -> [u32; MAX_AXES];
    /// Its block, where it is known.
    fn block(&self) -> Option<*mut u8>;
    /// Notes its block, which has been made since.
    fn learn(&self, block: *mut u8);
}
impl<L: Layout<X>, X: Axes> Spot<L, X> for [u32; MAX_AXES] {
    #[inline(always)]
    fn place(&self) -> [u32; MAX_AXES] {
        *self
    }
    #[inline(always)]
    fn block(&self) -> Option<*mut u8> {
        None
    }
    #[inline(always)]
    fn learn(&self, _: *mut u8) {}
}

/// A place at an offset from a base.
pub(super) struct Near<'b, L: Layout<X>, X: Axes> {
    base: &'b Based<'b, L, X>,
    /// Whether the blocks around the base are those of who asks.
    own: bool,
    offset: [i64; MAX_AXES],
    place: [u32; MAX_AXES],
}
impl<L: Layout<X>, X: Axes> Clone for Near<'_, L, X> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Layout<X>, X: Axes> Copy for Near<'_, L, X> {}
impl<L: Layout<X>, X: Axes> Spot<L, X> for Near<'_, L, X> {
    #[inline(always)]
    fn place(&self) -> [u32; MAX_AXES] {
        self.place
    }
    #[inline(always)]
    fn block(&self) -> Option<*mut u8> {
        if self.own { self.base.corner(self.offset) } else { None }
    }
    #[inline(always)]
    fn learn(&self, block: *mut u8) {
        if self.own {
            self.base.learn(self.offset, block);
        }
    }
}

impl<R, L, X, P> Clone for Lane<'_, R, L, X, P> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P> Copy for Lane<'_, R, L, X, P> {}

impl<R, L, X, P> core::fmt::Debug for Lane<'_, R, L, X, P> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "`{}`", self.site.field)
    }
}

// SAFETY: as for `Handle`: an address, whose use is justified by the view that holds it. A job's memory of blocks stays with the job: in a
// sparse field `L::Corners` stands for it, which is not `Send`.
unsafe impl<R, L: Layout<X>, X: Axes, P> Send for Lane<'_, R, L, X, P> where L::Corners: Send {}
// SAFETY: as above.
unsafe impl<R, L: Layout<X>, X: Axes, P> Sync for Lane<'_, R, L, X, P> where L::Corners: Sync {}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> Lane<'a, R, L, X, P> {
    const MEMBER: usize = match P::MEMBER {
        Some(m) => m,
        None => 0,
    };
    const COMPONENT: usize = Map::<R, L, X>::constant_component(Self::MEMBER);

    #[inline(always)]
    pub(super) fn new(handle: Handle<'a, R, L, X>, site: &'static Site) -> Self {
        let geometry = &handle.geometry;
        let (start, background) = if const { Map::<R, L, X>::is_sparse(Self::MEMBER) } {
            (core::ptr::null_mut(), handle.store(Self::MEMBER).background)
        } else {
            (handle.root.wrapping_add(Map::<R, L, X>::start(geometry, Self::MEMBER)), core::ptr::null_mut())
        };
        let component = if const { Self::COMPONENT == 0 } {
            Map::<R, L, X>::component(geometry, Self::MEMBER)
        } else {
            Self::COMPONENT
        };
        Self { handle, site, start, background, component, path: PhantomData }
    }

    #[inline(always)]
    pub(super) fn handle(&self) -> &Handle<'a, R, L, X> {
        &self.handle
    }

    pub(super) fn site(&self) -> &'static Site {
        self.site
    }

    /// The place of an index that lies within the shape.
    ///
    /// # Panics
    /// Where it does not.
    #[inline(always)]
    #[track_caller]
    pub(super) fn locate<T: IntoIndex<X>>(&self, index: T) -> [u32; MAX_AXES] {
        let at = index.coordinates();
        if const { T::CHECKED } { self.place_of(at) } else { self.handle.geometry.place(at) }
    }

    /// The place of logical coordinates that lie within the shape.
    ///
    /// # Panics
    /// Where they do not.
    #[inline(always)]
    #[track_caller]
    pub(super) fn place_of(&self, at: [i64; MAX_AXES]) -> [u32; MAX_AXES] {
        let geometry = &self.handle.geometry;
        let Some(place) = crate::index::within::<X>(at, geometry) else { self.site.out_of_range::<X>(at, geometry) };
        place
    }

    /// The place of `base + offset`, checked with the base where the offset lies in the base's box.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub(super) fn near<'b>(&self, base: &'b Based<'b, L, X>, offset: impl IntoIndex<X>) -> Near<'b, L, X> {
        let offset = offset.coordinates();
        Near { base, own: base.is_of(self.handle.root), offset, place: base.plus(offset, self.site) }
    }

    /// The same for a view with the base's own root, which need not be asked: the compiler would have to keep what is done otherwise.
    #[inline(always)]
    #[track_caller]
    pub(super) fn near_own<'b>(&self, base: &'b Based<'b, L, X>, offset: [i64; MAX_AXES]) -> Near<'b, L, X> {
        debug_assert!(base.is_of(self.handle.root), "a base of where this job accumulates");
        assert!(base.holds(offset), "an offset in the box of its base");
        Near { base, own: true, offset, place: base.plus_held(offset) }
    }

    /// The place that a boundary rule gives for an index.
    ///
    /// # Panics
    /// Where it gives none.
    #[inline(always)]
    #[track_caller]
    pub(super) fn locate_by(
        &self,
        index: impl IntoIndex<X>,
        rule: impl Fn([i64; MAX_AXES], &Geometry) -> Option<[u32; MAX_AXES]>,
    ) -> [u32; MAX_AXES] {
        let (at, geometry) = (index.coordinates(), &self.handle.geometry);
        let Some(place) = rule(at, geometry) else { self.site.out_of_range::<X>(at, geometry) };
        place
    }

    /// The place of an index, where it lies within the shape.
    #[inline(always)]
    pub(super) fn inside(&self, index: impl IntoIndex<X>) -> Option<[u32; MAX_AXES]> {
        crate::index::within::<X>(index.coordinates(), &self.handle.geometry)
    }

    /// The block of a spot in a sparse field, and its place in there; where there is no block, the background's.
    #[inline(always)]
    fn block(&self, spot: impl Spot<L, X>) -> (*mut u8, Block, [u32; MAX_AXES]) {
        let (block, inner) = Handle::<R, L, X>::split(Self::MEMBER, spot.place());
        let start = match spot.block() {
            Some(known) => known,
            None => self.handle.brick(Self::MEMBER, &block),
        };
        (start, block, inner)
    }

    /// The first component of the path's member, and the distance of its components: to be read.
    #[inline(always)]
    pub(super) fn address(&self, spot: impl Spot<L, X>) -> (*mut u8, usize) {
        if const { Map::<R, L, X>::is_sparse(Self::MEMBER) } {
            let (start, _, inner) = self.block(spot);
            return self.handle.component_in(Self::MEMBER, start, &inner);
        }
        self.address_in_memory(spot.place())
    }

    /// The same to be written: the element becomes active.
    #[inline(always)]
    pub(super) fn address_mut(&self, spot: impl Spot<L, X>) -> (*mut u8, usize) {
        if const { Map::<R, L, X>::is_sparse(Self::MEMBER) } {
            let (mut start, block, inner) = self.block(spot);
            if core::ptr::eq(start, self.background) {
                // Perhaps another of the job's views has made it meanwhile.
                start = self.handle.found_or_grown(Self::MEMBER, block);
                spot.learn(start);
            }
            self.handle.activate_in(Self::MEMBER, start, &block, &inner);
            return self.handle.component_in(Self::MEMBER, start, &inner);
        }
        self.address_in_memory(spot.place())
    }

    #[inline(always)]
    fn address_in_memory(&self, at: [u32; MAX_AXES]) -> (*mut u8, usize) {
        let offset = sum::<X>(
            #[inline(always)]
            |a| Map::<R, L, X>::term(&self.handle.geometry, Self::MEMBER, a, at[a]),
        );
        let component = if const { Self::COMPONENT == 0 } { self.component } else { Self::COMPONENT };
        (self.start.wrapping_add(offset), component)
    }

    /// Reads the path at an element.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody writes the path there meanwhile.
    #[inline(always)]
    pub(super) unsafe fn read(&self, spot: impl Spot<L, X>) -> P::Value {
        if const { P::MEMBER.is_none() } {
            // SAFETY: as the caller promises.
            return unsafe { self.handle.read::<P>(spot.place()) };
        }
        let address = self.address(spot);
        // SAFETY: the components of an element within the shape lie in the field's memory.
        unsafe {
            P::gather(
                #[inline(always)]
                |_| address,
            )
        }
    }
}
