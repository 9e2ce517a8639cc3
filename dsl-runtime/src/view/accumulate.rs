//! `Accumulate`: a path that the loop only accumulates into, at any index.

use core::cell::RefCell;
use core::marker::PhantomData;
use core::mem::size_of;

use super::lane::{Lane, Spot};
use super::probed::note;
use super::{Based, Site};
use crate::axes::{Axes, MAX_AXES};
use crate::element::{Element, component};
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::{Geometry, Layout};
use crate::number::{
    BitAnd, BitOr, BitXor, Bits, ComponentMul, Kept, Max, Min, Number, Operator, Product, Sum, Updated,
};
use crate::probe::{Access, Index};
use crate::record::{Path, Record};
use crate::scatter::{Late, Share, Window};

/// Accumulates into a path of a field at any index. No update is lost: the memory is this job's own, or every component
/// is updated atomically.
///
/// With `FAR` every update is a call: where it is not worth the code to do it in place.
#[doc(hidden)]
#[derive(Debug)]
pub struct Accumulate<'a, R, L, X, P, const FAR: bool = false> {
    lane: Lane<'a, R, L, X, P>,
    atomic: bool,
    /// The elements that this job updates, and what takes the updates of others.
    window: Window,
    late: Option<&'a RefCell<Late>>,
    slot: usize,
    /// Neither `Send` nor `Sync`: a job's private copy is its alone.
    owner: PhantomData<*mut ()>,
}

/// An update of an element that may not lie in the window: by value as a whole, so that it is in memory for the call alone.
struct Elsewhere<A, T> {
    view: A,
    at: [i64; MAX_AXES],
    value: T,
}

impl<R, L, X, P, const FAR: bool> Clone for Accumulate<'_, R, L, X, P, FAR> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X, P, const FAR: bool> Copy for Accumulate<'_, R, L, X, P, FAR> {}

macro_rules! operations {
    ($($name:ident $name_at:ident $operator:ident, $bound:ident, $doc:literal;)*) => {$(
        #[doc = $doc]
        ///
        /// # Panics
        /// Where the index lies outside of the shape.
        #[inline(always)]
        #[track_caller]
        pub fn $name(&self, index: impl IntoIndex<X>, value: P::Value)
        where
            <P::Value as Element>::Scalar: $bound,
        {
            self.apply_by::<$operator, _>(index, value);
        }

        #[doc = $doc]
        /// At `base + offset`, checked with the base where the offset lies in the base's box.
        ///
        /// # Panics
        /// Where the sum lies outside of the shape.
        #[inline(always)]
        #[track_caller]
        pub fn $name_at<const FILLED: bool>(&self, base: &Based<'_, L, X, FILLED>, offset: impl IntoIndex<X>, value: P::Value)
        where
            <P::Value as Element>::Scalar: $bound,
        {
            self.apply_at::<$operator, FILLED>(base, offset, value);
        }
    )*};
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>, const FAR: bool> Accumulate<'a, R, L, X, P, FAR>
where
    P::Value: Element,
{
    /// What a job accumulates into as the launch's schedule says.
    #[inline(always)]
    pub(super) fn new(
        handle: Handle<'a, R, L, X>,
        site: &'static Site,
        atomic: bool,
        share: Share<'a>,
        slot: usize,
    ) -> Self {
        const { assert!(P::MEMBER.is_some(), "an element is one member") }
        let Share { root, window, late } = share;
        Self { lane: Lane::new(handle.at(root), site), atomic, window, late, slot, owner: PhantomData }
    }

    /// All of a field.
    #[inline(always)]
    pub(super) fn whole(handle: Handle<'a, R, L, X>, site: &'static Site, atomic: bool) -> Self {
        let (root, window) = (handle.root, Window::whole(&handle.geometry));
        Self::new(handle, site, atomic, Share { root, window, late: None }, 0)
    }

    #[inline(always)]
    #[track_caller]
    fn apply_by<O: Operator<<P::Value as Element>::Scalar>, T: IntoIndex<X>>(&self, index: T, value: P::Value)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        let (at, geometry) = (index.coordinates(), &self.lane.handle().geometry);
        if FAR {
            return Self::elsewhere::<O>(Elsewhere { view: *self, at, value });
        }
        if !T::CHECKED && self.late.is_none() {
            return self.apply::<O>(geometry.place(at), value);
        }
        match self.window.within::<X>(at, geometry) {
            Some(place) => self.apply::<O>(place, value),
            None => {
                // Copies: what a call could reach would have to stay in memory, with all that it is a part of.
                Self::elsewhere::<O>(Elsewhere { view: *self, at, value });
            }
        }
    }

    #[inline(always)]
    #[track_caller]
    fn apply_at<O: Operator<<P::Value as Element>::Scalar>, const FILLED: bool>(
        &self,
        base: &Based<'_, L, X, FILLED>,
        offset: impl IntoIndex<X>,
        value: P::Value,
    ) where
        <P::Value as Element>::Scalar: Updated,
    {
        let offset = offset.coordinates();
        // A base for accumulation is made from where this job accumulates, as this view is.
        self.apply::<O>(self.lane.near_own(base, offset), value);
    }

    /// Updates an element that may not lie in the window.
    #[cold]
    #[inline(never)]
    #[track_caller]
    fn elsewhere<O: Operator<<P::Value as Element>::Scalar>>(update: Elsewhere<Self, P::Value>)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        let Elsewhere { view, at, value } = update;
        let place = view.lane.place_of(at);
        let Some(late) = view.late.filter(|_| view.window.within::<X>(at, &view.lane.handle().geometry).is_none())
        else {
            return view.apply::<O>(place, value);
        };
        // SAFETY: the function reads a value of this path, and is for the field of this slot.
        unsafe { late.borrow_mut().push(Self::apply_late::<O>, view.slot, place, value) };
    }

    /// Updates an element when no job runs any more.
    ///
    /// # Safety
    /// A field of these types lies at the root, its shape contains the place, nothing else reaches it, and `value` points to one of this path.
    unsafe fn apply_late<O: Operator<<P::Value as Element>::Scalar>>(
        root: *mut u8,
        geometry: &Geometry,
        place: [u32; MAX_AXES],
        value: *const u8,
    ) where
        <P::Value as Element>::Scalar: Updated,
    {
        static NOWHERE: Site = Site { kernel: "", field: "" };
        let handle = Handle::<R, L, X>::new(root, *geometry, None, true);
        // SAFETY: as the caller promises.
        let value = unsafe { value.cast::<P::Value>().read_unaligned() };
        Accumulate::<R, L, X, P>::whole(handle, &NOWHERE, false).apply::<O>(place, value);
    }

    #[inline(always)]
    fn apply<O: Operator<<P::Value as Element>::Scalar>>(&self, at: impl Spot<R, L, X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        let (start, step) = self.lane.address_mut(at);
        note::<R, L, X, P>(self.lane.handle(), self.lane.site(), || at.place(), Access::Accumulate, Index::Computed);
        if self.atomic {
            Self::apply_atomically::<O>(start, step, value);
            return;
        }
        // SAFETY: `at` lies within the shape, in the field itself on one thread, in this job's private copy, or in the window that this job
        // has to itself; nothing else touches the path there meanwhile.
        unsafe {
            let old = P::Value::gather(start, step);
            crate::number::zip::<O, P::Value>(old, value).scatter(start, step);
        }
    }

    #[cold]
    #[inline(never)]
    fn apply_atomically<O: Operator<<P::Value as Element>::Scalar>>(start: *mut u8, step: usize, value: P::Value)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        assert!(start.addr().is_multiple_of(size_of::<<P::Value as Element>::Scalar>()));
        for c in 0..P::Value::COMPONENTS {
            let by = component(&value, c);
            let to = start.wrapping_add(c * step).cast::<<P::Value as Element>::Scalar>();
            // SAFETY: a component of an element within the shape, aligned as asserted (components lie a multiple of
            // their size apart); in an atomic launch every update of the path is atomic.
            unsafe {
                Updated::update(
                    to,
                    #[inline(always)]
                    |old| O::apply(old, by),
                );
            }
        }
    }

    /// The same view, whose updates are calls: around bases that do not lie within what a job may reach. It is a copy, as what calls could
    /// reach would have to stay in memory.
    #[inline(always)]
    pub fn far(&self) -> Accumulate<'a, R, L, X, P, true> {
        let &Self { lane, atomic, window, late, slot, owner } = self;
        Accumulate { lane, atomic, window, late, slot, owner }
    }

    /// What changes nothing: an accumulation into a component fills the others with it.
    #[inline(always)]
    pub fn identity<O: Operator<<P::Value as Element>::Scalar>>(&self, _: O) -> P::Value {
        crate::number::identity::<O, P::Value>()
    }

    /// Accumulates into those components of an element that are not [`identity`](Self::identity).
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn part<O: Operator<<P::Value as Element>::Scalar>>(&self, _: O, index: impl IntoIndex<X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        self.apply_by::<Kept<O>, _>(index, value);
    }

    /// The same at `base + offset`.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn part_at<O: Operator<<P::Value as Element>::Scalar>, const FILLED: bool>(
        &self,
        _: O,
        base: &Based<'_, L, X, FILLED>,
        offset: impl IntoIndex<X>,
        value: P::Value,
    ) where
        <P::Value as Element>::Scalar: Updated,
    {
        self.apply_at::<Kept<O>, FILLED>(base, offset, value);
    }

    operations! {
        add add_at Sum, Number, "`+=`.";
        min min_at Min, Number, "`min_assign`.";
        max max_at Max, Number, "`max_assign`.";
        or or_at BitOr, Bits, "`|=`.";
        and and_at BitAnd, Bits, "`&=`.";
        xor xor_at BitXor, Bits, "`^=`.";
    }

    /// `-=`.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn sub(&self, index: impl IntoIndex<X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Number,
    {
        self.apply_by::<Sum, _>(index, negative(value));
    }

    /// `-=` at `base + offset`.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn sub_at<const FILLED: bool>(&self, base: &Based<'_, L, X, FILLED>, offset: impl IntoIndex<X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Number,
    {
        self.apply_at::<Sum, FILLED>(base, offset, negative(value));
    }

    /// `*=`, component by component.
    ///
    /// # Panics
    /// Where the index lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn mul<Rhs>(&self, index: impl IntoIndex<X>, by: Rhs)
    where
        P::Value: ComponentMul<Rhs>,
        <P::Value as Element>::Scalar: Number,
    {
        self.apply_by::<Product, _>(index, P::Value::factor(by));
    }

    /// `*=` at `base + offset`, component by component.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn mul_at<Rhs, const FILLED: bool>(&self, base: &Based<'_, L, X, FILLED>, offset: impl IntoIndex<X>, by: Rhs)
    where
        P::Value: ComponentMul<Rhs>,
        <P::Value as Element>::Scalar: Number,
    {
        self.apply_at::<Product, FILLED>(base, offset, P::Value::factor(by));
    }
}

/// `-value`, exactly: `a - b` and `a + -b` are the same bits.
#[doc(hidden)]
#[inline(always)]
pub fn negative<E: Element>(value: E) -> E
where
    E::Scalar: Number,
{
    // `-0.0 - x` is `-x` for floats, and integers wrap.
    E::combine(
        E::of_scalar(<E::Scalar as Number>::EMPTY_SUM),
        value,
        #[inline(always)]
        |zero, x| zero.minus(x),
    )
}
