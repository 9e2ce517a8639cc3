//! A path of a field by index, its member's start found once.

use core::marker::PhantomData;

use super::probed::note;
use super::{Based, Site};
use crate::axes::{Axes, MAX_AXES, PerAxis, for_axes};
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::{Block, Geometry, Layout, Map};
use crate::probe::{Access, Index};
use crate::record::{Path, Record};

/// Where the values of a path lie, by index.
pub(super) struct Lane<'a, R, L, X, P> {
    handle: Handle<'a, R, L, X>,
    site: &'static Site,
    /// The member's first component at the field's first element; in a sparse branch at a block's, which begins at address zero.
    start: *mut u8,
    /// Bytes between neighbours of the root along each axis, where they are no constants (dense branches).
    stride: PerAxis,
    /// What stands where there is no block (sparse branches).
    background: *mut u8,
    component: usize,
    path: PhantomData<P>,
}

/// Where an element of a field stands: by its place alone, or beside a base whose blocks are known.
pub(super) trait Spot<R: Record, L: Layout<X>, X: Axes>: Copy {
    /// Its place.
    fn place(&self) -> [u32; MAX_AXES];
    /// The address of a member of a sparse branch, in the background where there is no block.
    fn address<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> *mut u8;
    /// The same in a block, which is made where there is none, and the block.
    fn address_mut<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> (*mut u8, *mut u8);
}
impl<R: Record, L: Layout<X>, X: Axes> Spot<R, L, X> for [u32; MAX_AXES] {
    #[inline(always)]
    fn place(&self) -> [u32; MAX_AXES] {
        *self
    }
    #[inline(always)]
    fn address<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> *mut u8 {
        lane.address_in_block(lane.brick(*self), *self)
    }
    #[inline(always)]
    fn address_mut<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> (*mut u8, *mut u8) {
        let mut brick = lane.brick(*self);
        if core::ptr::eq(brick, lane.background) {
            // Perhaps another of the job's views has made it meanwhile.
            brick = lane.grown(*self);
        }
        (lane.address_in_block(brick, *self), brick)
    }
}

/// A place at an offset from a base.
pub(super) struct Near<'b, L: Layout<X>, X: Axes, const FILLED: bool> {
    base: &'b Based<'b, L, X, FILLED>,
    /// Whether the blocks around the base are known, and those of who asks, and the offset lies in the base's box.
    own: bool,
    offset: [i64; MAX_AXES],
    place: [u32; MAX_AXES],
}
impl<L: Layout<X>, X: Axes, const FILLED: bool> Clone for Near<'_, L, X, FILLED> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Layout<X>, X: Axes, const FILLED: bool> Copy for Near<'_, L, X, FILLED> {}
impl<R: Record, L: Layout<X>, X: Axes, const FILLED: bool> Spot<R, L, X> for Near<'_, L, X, FILLED> {
    #[inline(always)]
    fn place(&self) -> [u32; MAX_AXES] {
        self.place
    }
    #[inline(always)]
    fn address<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> *mut u8 {
        if const { !Based::<L, X, FILLED>::CORNERED } {
            return Spot::<R, L, X>::address(&self.place, lane);
        }
        if !self.own {
            return lane.address_in_block(lane.found(self.place), self.place);
        }
        if const { Lane::<R, L, X, P>::IS_EVEN } {
            return lane.address_beside(self.base, self.offset);
        }
        lane.address_in_block(self.base.corner(self.offset), self.place)
    }
    #[inline(always)]
    fn address_mut<P: Path<R>>(&self, lane: &Lane<'_, R, L, X, P>) -> (*mut u8, *mut u8) {
        if const { !Based::<L, X, FILLED>::CORNERED } {
            return Spot::<R, L, X>::address_mut(&self.place, lane);
        }
        if self.own && const { Based::<L, X, FILLED>::THERE && Lane::<R, L, X, P>::IS_EVEN } {
            return (lane.address_beside(self.base, self.offset), self.base.corner(self.offset));
        }
        let mut brick = if self.own { self.base.corner(self.offset) } else { lane.background };
        if core::ptr::eq(brick, lane.background) {
            brick = lane.grown(self.place);
            if self.own {
                self.base.learn(self.offset, brick);
            }
        }
        (lane.address_in_block(brick, self.place), brick)
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
    const SPARSE: bool = Map::<R, L, X>::is_sparse(Self::MEMBER);
    /// Elements that a block of the member's branch spans along each axis.
    const EXTENT: PerAxis = Map::<R, L, X>::chain(Self::MEMBER).extent;
    /// Bytes of a cell of the root.
    const CELL: usize = if Map::<R, L, X>::chain(Self::MEMBER).is_flat() {
        Map::<R, L, X>::stride(Self::MEMBER)
    } else {
        Map::<R, L, X>::block_bytes(Self::MEMBER)
    };
    /// The axis along which the root's cells follow one another.
    const FASTEST: usize = Map::<R, L, X>::fastest(Self::MEMBER);
    /// Bytes between neighbours in a block along each axis; 0 where they lie at various distances.
    const STEP: PerAxis = Map::<R, L, X>::steps(Self::MEMBER);
    /// Whether neighbours in a block lie at equal distances along each axis.
    const IS_EVEN: bool = {
        let mut axis = 0;
        while axis < X::RANK && (Self::EXTENT[axis] == 1 || Self::STEP[axis] > 0) {
            axis += 1;
        }
        axis == X::RANK
    };
    /// How much earlier an element lies in each block around a base than it would if the first went on.
    const BACK: [usize; 8] = {
        let (mut back, mut corner) = ([0; 8], 0);
        while corner < 8 {
            let mut axis = 0;
            while axis < 3 {
                back[corner] += (corner >> axis & 1) * Self::EXTENT[axis] * Self::STEP[axis];
                axis += 1;
            }
            corner += 1;
        }
        back
    };
    /// Whether blocks know which of their cells are active.
    const ACTIVATES: bool =
        Self::SPARSE && (Map::<R, L, X>::grain(Self::MEMBER) > 0 || Map::<R, L, X>::list().is_some());

    #[inline(always)]
    pub(super) fn new(handle: Handle<'a, R, L, X>, site: &'static Site) -> Self {
        let geometry = &handle.geometry;
        let start = Map::<R, L, X>::start(geometry, Self::MEMBER);
        let mut stride = [0; MAX_AXES];
        let (start, background) = if const { Self::SPARSE } {
            (core::ptr::without_provenance_mut(start), handle.store(Self::MEMBER).background)
        } else {
            for_axes!(X, A => {
                stride[A] = Map::<R, L, X>::root_stride(geometry, Self::MEMBER, A).wrapping_mul(Self::CELL);
            });
            (handle.root.wrapping_add(start), core::ptr::null_mut())
        };
        let component = if const { Self::COMPONENT == 0 } {
            Map::<R, L, X>::component(geometry, Self::MEMBER)
        } else {
            Self::COMPONENT
        };
        Self { handle, site, start, stride, background, component, path: PhantomData }
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
    pub(super) fn near<'b, const FILLED: bool>(
        &self,
        base: &'b Based<'b, L, X, FILLED>,
        offset: impl IntoIndex<X>,
    ) -> Near<'b, L, X, FILLED> {
        let offset = offset.coordinates();
        // Folds to nothing for unrolled offsets.
        if base.holds(offset) {
            let own = base.is_known() && base.is_of(self.handle.root);
            return Near { base, own, offset, place: base.plus_held(offset) };
        }
        Near { base, own: false, offset, place: base.far(offset, self.site) }
    }

    /// The same for a view with the base's own root, which need not be asked: the compiler would have to keep what is done otherwise.
    #[inline(always)]
    #[track_caller]
    pub(super) fn near_own<'b, const FILLED: bool>(
        &self,
        base: &'b Based<'b, L, X, FILLED>,
        offset: [i64; MAX_AXES],
    ) -> Near<'b, L, X, FILLED> {
        debug_assert!(base.is_of(self.handle.root), "a base of where this job accumulates");
        assert!(base.holds(offset), "an offset in the box of its base");
        Near { base, own: base.is_known(), offset, place: base.plus_held(offset) }
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

    /// The block of an element of a sparse branch.
    #[inline(always)]
    fn block_of(&self, place: [u32; MAX_AXES]) -> Block {
        let mut block = [0; MAX_AXES];
        for_axes!(X, A => block[A] = place[A] / const { Self::EXTENT[A] as u32 });
        block
    }

    /// A block; the background's where there is none.
    #[inline(always)]
    fn brick(&self, place: [u32; MAX_AXES]) -> *mut u8 {
        self.handle.brick(Self::MEMBER, &self.block_of(place))
    }

    /// The same, where it is not worth the code to look it up in place.
    #[inline(always)]
    fn found(&self, place: [u32; MAX_AXES]) -> *mut u8 {
        // Copies: what a call could reach would have to stay in memory, with all that it is a part of.
        self.handle.found(Self::MEMBER, self.block_of(place))
    }

    /// The same, made where there is none.
    #[inline(always)]
    fn grown(&self, place: [u32; MAX_AXES]) -> *mut u8 {
        self.handle.found_or_grown(Self::MEMBER, self.block_of(place))
    }

    /// The first component of the path's member, and the distance of its components: to be read.
    #[inline(always)]
    pub(super) fn address(&self, spot: impl Spot<R, L, X>) -> (*mut u8, usize) {
        if const { Self::SPARSE } {
            return (spot.address(self), self.component());
        }
        (self.address_in_memory(spot.place()), self.component())
    }

    /// The same to be written: the element becomes active.
    #[inline(always)]
    pub(super) fn address_mut(&self, spot: impl Spot<R, L, X>) -> (*mut u8, usize) {
        if const { Self::SPARSE } {
            let (address, brick) = spot.address_mut(self);
            if const { Self::ACTIVATES } {
                let (block, inner) = Handle::<R, L, X>::split(Self::MEMBER, spot.place());
                self.handle.activate_in(Self::MEMBER, brick, &block, &inner);
            }
            return (address, self.component());
        }
        (self.address_in_memory(spot.place()), self.component())
    }

    #[inline(always)]
    fn component(&self) -> usize {
        if const { Self::COMPONENT == 0 } { self.component } else { Self::COMPONENT }
    }

    #[inline(always)]
    fn address_in_memory(&self, place: [u32; MAX_AXES]) -> *mut u8 {
        let mut address = self.start;
        for_axes!(X, A => {
            // Divisions are made in 32 bits, which vectorise.
            let cell = if const { Self::EXTENT[A] > 1 } { place[A] / const { Self::EXTENT[A] as u32 } } else { place[A] };
            let stride = if const { A == Self::FASTEST } { Self::CELL } else { self.stride[A] };
            address = address.wrapping_add((cell as usize).wrapping_mul(stride));
            if const { Self::EXTENT[A] > 1 } {
                address = address.wrapping_add(Self::step::<A>(place[A]));
            }
        });
        address
    }

    #[inline(always)]
    fn address_in_block(&self, brick: *mut u8, place: [u32; MAX_AXES]) -> *mut u8 {
        let mut address = brick.wrapping_add(self.start.addr());
        for_axes!(X, A => {
            if const { Self::EXTENT[A] > 1 } {
                address = address.wrapping_add(Self::step::<A>(place[A]));
            }
        });
        address
    }

    /// The address at an offset in the box of a base whose blocks are known.
    #[inline(always)]
    fn address_beside<const FILLED: bool>(&self, base: &Based<'_, L, X, FILLED>, offset: [i64; MAX_AXES]) -> *mut u8 {
        base.address(offset, const { &Self::STEP }, const { &Self::BACK }).wrapping_add(self.start.addr())
    }

    /// What a coordinate adds to an address within its block.
    #[inline(always)]
    fn step<const A: usize>(c: u32) -> usize {
        let inner = (c % const { Self::EXTENT[A] as u32 }) as usize;
        if const { Self::STEP[A] > 0 } {
            inner.wrapping_mul(const { Self::STEP[A] })
        } else {
            Map::<R, L, X>::inner(Self::MEMBER, A, inner)
        }
    }

    /// Reads the path at an element, which the kernel has found by such an index.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody writes the path there meanwhile.
    #[inline(always)]
    pub(super) unsafe fn read(&self, spot: impl Spot<R, L, X>, index: Index) -> P::Value {
        note::<R, L, X, P>(&self.handle, self.site, || spot.place(), Access::Read, index);
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
