//! Copies of whole fields from layout to layout.

use core::any::TypeId;

use super::host::Places;
use super::parts::each_part;
use super::{Field, ShapeMismatch};
use crate::axes::Axes;
use crate::layout::Layout;
use crate::record::{Record, Whole};

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// Takes all records from a field of the same shape, whatever its layout.
    ///
    /// The shape alone counts, not the origins: the first record becomes the first, and this field keeps its own origin.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut rows = Field::<f32, Aos>::new([2, 3]);
    /// rows.copy_from_slice(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    /// let mut tiles = Field::<f32, Blocked<2>>::new([2, 3]);
    /// tiles.copy_from(&rows);
    /// assert_eq!(tiles.to_vec(), rows.to_vec());
    /// ```
    ///
    /// # Panics
    /// Where the shapes differ.
    #[track_caller]
    pub fn copy_from<M: Layout<X>>(&mut self, other: &Field<R, M, X>) {
        self.try_copy_from(other)
            .unwrap_or_else(|error| panic!("`Field<{}, ..>`: {error}", core::any::type_name::<R>()));
    }

    /// Takes all records from a field of the same shape, whatever its layout and its origin.
    ///
    /// # Errors
    /// Where the shapes differ; the field stays as it was.
    pub fn try_copy_from<M: Layout<X>>(&mut self, other: &Field<R, M, X>) -> Result<(), ShapeMismatch> {
        let shape = self.geometry.shape;
        if shape != other.geometry.shape {
            let shapes = (self.shape().as_ref().to_vec(), other.shape().as_ref().to_vec());
            return Err(ShapeMismatch { shape: shapes.0, other: shapes.1 });
        }
        if TypeId::of::<L>() == TypeId::of::<M>() {
            // One layout and one shape lie in memory in one way.
            self.memory.as_mut_slice().copy_from_slice(other.memory.as_slice());
            return Ok(());
        }
        let (from, to) = (other.handle(), self.handle());
        each_part(self.len(), |part| {
            for at in Places::<X>::part(shape, part) {
                // SAFETY: places lie within the shape, which both have; each part writes its own places of this field,
                // which `&mut self` keeps others from.
                unsafe { to.write::<Whole>(at, from.read::<Whole>(at)) };
            }
        });
        Ok(())
    }

    /// A copy in another layout, with the same origin.
    ///
    /// # Panics
    /// Where the other layout cannot hold the shape.
    pub fn relayout<M: Layout<X>>(&self) -> Field<R, M, X> {
        let extents = self.geometry.shape.map(|n| n as usize);
        let mut to = Field::<R, M, X>::with_extents(extents)
            .unwrap_or_else(|error| panic!("`{}`: {error}", core::any::type_name::<R>()));
        to.geometry.origin = self.geometry.origin;
        to.copy_from(self);
        to
    }
}
