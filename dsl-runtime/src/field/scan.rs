//! Running sums: where each of many lists begins in one long list.

use core::fmt;

use super::elements::Elements;
use super::parts::{PART, each_part};
use super::{Field, MemberMut};
use crate::axes::I;
use crate::element::{Element, Scalar};
use crate::layout::Layout;
use crate::number::Number;
use crate::record::{Path, Record};

/// A running sum that its type cannot hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScanOverflow {
    /// The element whose value makes the sum too large or too small.
    pub index: usize,
    /// The type of the sum.
    pub scalar: &'static str,
}

impl fmt::Display for ScanOverflow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the sum up to element {} overflows `{}`", self.index, self.scalar)
    }
}

impl std::error::Error for ScanOverflow {}

impl<R: Record, L: Layout<I>, P: Path<R>> MemberMut<'_, R, L, I, P>
where
    P::Value: Element + Number,
{
    /// Replaces every value by the sum of those before it, in parallel, and returns the sum of all: see
    /// [`Field::exclusive_scan`].
    ///
    /// # Panics
    /// Where a sum of integers overflows.
    #[track_caller]
    pub fn exclusive_scan(&mut self) -> P::Value {
        self.try_exclusive_scan()
            .unwrap_or_else(|error| panic!("`exclusive_scan` of `{}`: {error}", core::any::type_name::<R>()))
    }

    /// Replaces every value by the sum of those before it, in parallel, and returns the sum of all: see
    /// [`Field::exclusive_scan`].
    ///
    /// # Errors
    /// Where a sum of integers overflows; the values then stay as they were.
    pub fn try_exclusive_scan(&mut self) -> Result<P::Value, ScanOverflow> {
        let handle = self.handle();
        let elements = Elements::of::<P, R, L, I>(handle);
        let len = elements.len();
        // Not `EMPTY_SUM`, which is -0.0 for floats.
        let zero = P::Value::EMPTY_PRODUCT.minus(P::Value::EMPTY_PRODUCT);
        let values = |part| {
            // SAFETY: elements lie within the shape; this member is ours alone, and nobody writes it while it is read.
            elements.part::<I>(part).map(|at| unsafe { handle.read::<P>(at) })
        };

        let sums = each_part(len, |part| values(part).fold(zero, Number::plus));
        let mut total = zero;
        let mut before = Vec::with_capacity(sums.len());
        for sum in sums {
            before.push(total);
            total = total.plus(sum);
        }
        // Sums so far wrapped around. The first overflow is found for certain, since all sums before it are exact.
        if <P::Value as Element>::Scalar::KIND.is_integer() {
            let overflows = each_part(len, |part| {
                let (first, mut sum) = (part.start, before[part.start / PART]);
                for (n, value) in values(part).enumerate() {
                    match sum.checked_plus(value) {
                        Some(next) => sum = next,
                        None => return Some(first + n),
                    }
                }
                None
            });
            if let Some(index) = overflows.into_iter().flatten().next() {
                return Err(ScanOverflow { index, scalar: core::any::type_name::<P::Value>() });
            }
        }
        each_part(len, |part| {
            // What is before the part and what is in it are summed apart, as for the sum of all: sums of numbers that
            // are not negative then never fall from one part to the next.
            let (start, mut sum) = (before[part.start / PART], zero);
            for at in elements.part::<I>(part) {
                // SAFETY: elements lie within the shape; this member is ours alone, and each part has its own places.
                let value = unsafe { handle.read::<P>(at) };
                // SAFETY: as above.
                unsafe { handle.write::<P>(at, start.plus(sum)) };
                sum = sum.plus(value);
            }
        });
        Ok(total)
    }
}

impl<E: Element + Number, L: Layout<I>> Field<E, L, I> {
    /// Replaces every value by the sum of those before it, in parallel, and returns the sum of all.
    ///
    /// So counts become the places where each one's entries begin in a list of all. The order is fixed: sums of floats
    /// have the same bits for any number of threads and any layout.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut counts = Field::<u32, Aos>::new([4]);
    /// counts.copy_from_slice(&[3, 0, 2, 5]);
    /// assert_eq!(counts.exclusive_scan(), 10);
    /// assert_eq!(counts.to_vec(), [0, 3, 3, 5]);
    /// ```
    ///
    /// # Panics
    /// Where a sum of integers overflows.
    #[track_caller]
    pub fn exclusive_scan(&mut self) -> E {
        self.members_mut().0.exclusive_scan()
    }

    /// Replaces every value by the sum of those before it, in parallel, and returns the sum of all.
    ///
    /// # Errors
    /// Where a sum of integers overflows; the field then stays as it was.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut counts = Field::<u8, Aos>::new([3]);
    /// counts.copy_from_slice(&[200, 55, 1]);
    /// let error = counts.try_exclusive_scan().unwrap_err();
    /// assert_eq!(error.to_string(), "the sum up to element 2 overflows `u8`");
    /// assert_eq!(counts.to_vec(), [200, 55, 1]);
    /// ```
    pub fn try_exclusive_scan(&mut self) -> Result<E, ScanOverflow> {
        self.members_mut().0.try_exclusive_scan()
    }
}
