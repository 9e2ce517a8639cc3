//! `Accumulate`: a path that the loop only accumulates into, at any index.

use core::marker::PhantomData;
use core::mem::size_of;

use super::lane::{Lane, Near, Spot};
use super::{Based, Site};
use crate::axes::{Axes, MAX_AXES};
use crate::element::{Element, component};
use crate::field::Handle;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::number::{
    BitAnd, BitOr, BitXor, Bits, ComponentMul, Kept, Max, Min, Number, Operator, Product, Sum, Updated,
};
use crate::record::{Path, Record};

/// Accumulates into a path of a field at any index. No update is lost: the memory is this job's own, or every component
/// is updated atomically.
#[doc(hidden)]
#[derive(Debug)]
pub struct Accumulate<'a, R, L, X, P> {
    lane: Lane<'a, R, L, X, P>,
    atomic: bool,
    /// Neither `Send` nor `Sync`: a job's private copy is its alone.
    owner: PhantomData<*mut ()>,
}

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
            self.apply::<$operator>(self.locate(index), value);
        }

        #[doc = $doc]
        /// At `base + offset`, checked with the base where the offset lies in the base's box.
        ///
        /// # Panics
        /// Where the sum lies outside of the shape.
        #[inline(always)]
        #[track_caller]
        pub fn $name_at(&self, base: &Based<'_, L, X>, offset: impl IntoIndex<X>, value: P::Value)
        where
            <P::Value as Element>::Scalar: $bound,
        {
            self.apply::<$operator>(self.locate_at(base, offset), value);
        }
    )*};
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>> Accumulate<'a, R, L, X, P>
where
    P::Value: Element,
{
    #[inline(always)]
    pub(crate) fn new(handle: Handle<'a, R, L, X>, site: &'static Site, atomic: bool) -> Self {
        const { assert!(P::MEMBER.is_some(), "an element is one member") }
        Self { lane: Lane::new(handle, site), atomic, owner: PhantomData }
    }

    #[inline(always)]
    #[track_caller]
    fn locate(&self, index: impl IntoIndex<X>) -> [u32; MAX_AXES] {
        self.lane.locate(index)
    }

    #[inline(always)]
    #[track_caller]
    fn locate_at<'b>(&self, base: &'b Based<'b, L, X>, offset: impl IntoIndex<X>) -> Near<'b, L, X> {
        // A base for accumulation is made from where this job accumulates, as this view is.
        self.lane.near_own(base, offset)
    }

    #[inline(always)]
    fn apply<O: Operator<<P::Value as Element>::Scalar>>(&self, at: impl Spot<L, X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Updated,
    {
        let (start, step) = self.lane.address_mut(at);
        if self.atomic {
            self.apply_atomically::<O>(start, step, value);
            return;
        }
        // SAFETY: `at` lies within the shape, in the field itself on one thread or in this job's private copy; nothing
        // else touches the path during the launch.
        unsafe {
            let old = P::Value::gather(start, step);
            crate::number::zip::<O, P::Value>(old, value).scatter(start, step);
        }
    }

    #[cold]
    #[inline(never)]
    fn apply_atomically<O: Operator<<P::Value as Element>::Scalar>>(&self, start: *mut u8, step: usize, value: P::Value)
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
        self.apply::<Kept<O>>(self.locate(index), value);
    }

    /// The same at `base + offset`.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn part_at<O: Operator<<P::Value as Element>::Scalar>>(
        &self,
        _: O,
        base: &Based<'_, L, X>,
        offset: impl IntoIndex<X>,
        value: P::Value,
    ) where
        <P::Value as Element>::Scalar: Updated,
    {
        self.apply::<Kept<O>>(self.locate_at(base, offset), value);
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
        self.apply::<Sum>(self.locate(index), negative(value));
    }

    /// `-=` at `base + offset`.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn sub_at(&self, base: &Based<'_, L, X>, offset: impl IntoIndex<X>, value: P::Value)
    where
        <P::Value as Element>::Scalar: Number,
    {
        self.apply::<Sum>(self.locate_at(base, offset), negative(value));
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
        self.apply::<Product>(self.locate(index), P::Value::factor(by));
    }

    /// `*=` at `base + offset`, component by component.
    ///
    /// # Panics
    /// Where the sum lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn mul_at<Rhs>(&self, base: &Based<'_, L, X>, offset: impl IntoIndex<X>, by: Rhs)
    where
        P::Value: ComponentMul<Rhs>,
        <P::Value as Element>::Scalar: Number,
    {
        self.apply::<Product>(self.locate_at(base, offset), P::Value::factor(by));
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
