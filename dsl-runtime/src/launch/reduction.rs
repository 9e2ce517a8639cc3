//! Reductions: many partial results in a fixed order over fixed blocks.

use core::marker::PhantomData;
use core::mem::MaybeUninit;

use super::run::Cell;
use super::{Run, Space};
use crate::element::Element;
use crate::number::{ComponentMul, Number, Operator, Product, Sum, identity, zip};
use crate::view::negative;

/// The longest strip of a run whose contributions are buffered.
pub(crate) const STRIP: usize = LANES;

/// Partial results a block: contribution `k` of a strip goes to lane `k % LANES`, whatever the instruction set.
const LANES: usize = 64;

/// The operator and type of a reduction.
#[doc(hidden)]
#[derive(Debug)]
pub struct Reduction<O, T>(PhantomData<fn() -> (O, T)>);

impl<O, T> Clone for Reduction<O, T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<O, T> Copy for Reduction<O, T> {}

/// The reduction of a variable.
#[doc(hidden)]
#[inline(always)]
pub fn reduction<O: Operator<T::Scalar>, T: Element>(_: O, _: &T) -> Reduction<O, T> {
    Reduction(PhantomData)
}

impl<O: Operator<T::Scalar>, T: Element> Reduction<O, T> {
    /// What contributes nothing.
    #[inline(always)]
    pub fn identity(self) -> T {
        identity::<O, T>()
    }

    /// Adds a contribution to an element's own.
    #[inline(always)]
    pub fn apply(self, to: &mut T, value: T) {
        *to = zip::<O, T>(*to, value);
    }

    /// Adds a contribution to a component or an entry of a block's result.
    #[inline(always)]
    pub fn apply_part<P: Element>(self, to: &mut P, value: P)
    where
        O: Operator<P::Scalar>,
    {
        *to = zip::<O, P>(*to, value);
    }

    /// The partial result of a block.
    #[inline(always)]
    pub fn partial(self) -> Partial<O, T> {
        Partial { lanes: [self.identity(); LANES], operator: PhantomData }
    }

    /// A buffer for a strip's contributions.
    #[inline(always)]
    pub fn strip(self) -> Strip<T> {
        Strip { values: [const { MaybeUninit::uninit() }; STRIP] }
    }

    /// Adds a block's result to the variable.
    #[inline(always)]
    pub fn combine(self, to: &mut T, total: T) {
        *to = zip::<O, T>(*to, total);
    }
}

impl<T: Element> Reduction<Sum, T>
where
    T::Scalar: Number,
{
    /// Subtracts a contribution from an element's own.
    #[inline(always)]
    pub fn subtract(self, to: &mut T, value: T) {
        self.apply(to, negative(value));
    }

    /// Subtracts a contribution from a component or an entry of a block's result.
    #[inline(always)]
    pub fn subtract_part<P: Element<Scalar: Number>>(self, to: &mut P, value: P) {
        *to = zip::<Sum, P>(*to, negative(value));
    }
}

impl<T: Element> Reduction<Product, T>
where
    T::Scalar: Number,
{
    /// Multiplies an element's own contribution.
    #[inline(always)]
    pub fn multiply<Rhs>(self, to: &mut T, by: Rhs)
    where
        T: ComponentMul<Rhs>,
    {
        self.apply(to, T::factor(by));
    }

    /// Multiplies a component or an entry of a block's result.
    #[inline(always)]
    pub fn multiply_part<P: ComponentMul<Rhs, Scalar: Number>, Rhs>(self, to: &mut P, by: Rhs) {
        *to = zip::<Product, P>(*to, P::factor(by));
    }
}

/// The partial result of a block.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Partial<O, T> {
    lanes: [T; LANES],
    operator: PhantomData<fn() -> O>,
}

/// The contributions of a strip's elements.
#[doc(hidden)]
#[derive(Debug)]
pub struct Strip<T> {
    values: [MaybeUninit<T>; STRIP],
}

impl<T: Element> Strip<T> {
    /// Puts an element's contribution.
    #[inline(always)]
    pub fn put<S: Space>(&mut self, cell: &Cell<'_, S>, value: T) {
        self.values[cell.slot].write(value);
    }
}

impl<O: Operator<T::Scalar>, T: Element> Partial<O, T> {
    /// Adds the contributions of a strip, each of whose elements has put one.
    #[inline(always)]
    pub fn absorb<S: Space>(&mut self, strip: &Strip<T>, run: &Run<'_, S>) {
        // SAFETY: the macro's expansion puts a contribution for each element of the strip before it comes here.
        let value = |slot: usize| unsafe { strip.values[slot].assume_init() };
        let full = run.len - run.len % LANES;
        let mut start = 0;
        while start < full {
            for l in 0..LANES {
                self.lanes[l] = zip::<O, T>(self.lanes[l], value(start + l));
            }
            start += LANES;
        }
        for l in 0..run.len - full {
            self.lanes[l] = zip::<O, T>(self.lanes[l], value(full + l));
        }
    }

    /// The result of all lanes, folded in halves.
    #[inline(always)]
    pub fn total(mut self) -> T {
        let mut half = LANES / 2;
        while half > 0 {
            for l in 0..half {
                self.lanes[l] = zip::<O, T>(self.lanes[l], self.lanes[l + half]);
            }
            half /= 2;
        }
        self.lanes[0]
    }
}
