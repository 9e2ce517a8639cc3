//! Copies of whole fields from layout to layout.

use core::any::TypeId;

use super::elements::Elements;
use super::parts::each_part;
use super::{Field, Handle, ShapeMismatch};
use crate::axes::{Axes, MAX_AXES};
use crate::layout::{Layout, Map};
use crate::record::{ElementList, Record, Whole};

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
        self.take_all(other, |at| at);
        Ok(())
    }

    /// Takes records, activity and background from another field; `there` gives the place here of one there.
    pub(super) fn take_all<M: Layout<X>>(
        &mut self,
        other: &Field<R, M, X>,
        there: impl Fn([u32; MAX_AXES]) -> [u32; MAX_AXES] + Sync,
    ) {
        let sparse = const { (Map::<R, L, X>::any_sparse(), Map::<R, M, X>::any_sparse()) };
        if TypeId::of::<L>() == TypeId::of::<M>() && !sparse.0 {
            // One layout and one shape lie in memory in one way.
            self.storage.dense_mut().copy_from_slice(other.storage.dense());
            return;
        }
        if sparse.0 {
            self.clear();
            if sparse.1 {
                self.set_background(other.background());
            }
        }
        let one = const { L::BRANCHES == 1 && M::BRANCHES == 1 };
        let members = if one { 0..1 } else { 0..R::Elements::MEMBERS.len() };
        for m in members {
            let (from, to) = (other.handle(), self.handle());
            // What is dense here takes inactive elements, too: they read as the background.
            let all = one && !sparse.0 || !one && !Map::<R, L, X>::is_sparse(m);
            let elements = match all {
                true => Elements::All(other.geometry.shape),
                false => Elements::of_member(&from, m),
            };
            each_part(elements.len(), |part| {
                for at in elements.part::<X>(part) {
                    if const { L::BRANCHES == 1 && M::BRANCHES == 1 } {
                        // SAFETY: elements lie within the shape, which both have; each part writes its own elements of this
                        // field, which `&mut self` keeps others from.
                        unsafe { to.write::<Whole>(there(at), from.read::<Whole>(at)) };
                        continue;
                    }
                    let spec = &R::Elements::MEMBERS[m];
                    let ((read, read_step), (write, write_step)) =
                        (from.component(m, at), to.component_mut(m, there(at)));
                    for c in 0..spec.components {
                        let (read, write) = (read.wrapping_add(c * read_step), write.wrapping_add(c * write_step));
                        // SAFETY: as above; a component has so many bytes in every layout.
                        unsafe { write.copy_from_nonoverlapping(read, spec.scalar) };
                    }
                }
            });
        }
    }

    /// A copy in another layout, with the same origin.
    ///
    /// # Panics
    /// Where the other layout cannot hold the shape.
    pub fn relayout<M: Layout<X>>(&self) -> Field<R, M, X> {
        let mut to = self.same_shape::<M>();
        let (from, geometry) = (self.geometry, to.geometry);
        to.take_all(self, |at| geometry.place(from.logical(at).map(i64::from)));
        to
    }

    /// A copy in another, sparse layout, in which those elements alone are active that differ from the background, bit by bit; and
    /// what becomes active with them.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut rows = Field::<f32, Aos>::new([64, 64]);
    /// rows.set([3, 5], 1.5);
    /// let sparse = rows.relayout_sparse::<Sparse<8>>();
    /// assert_eq!((sparse.active_len(), sparse.get([3, 5]), sparse.get([40, 5])), (64, 1.5, 0.0));
    /// assert_eq!(rows.relayout::<Sparse<8>>().active_len(), 64 * 64);
    /// ```
    ///
    /// # Panics
    /// Where the other layout cannot hold the shape.
    pub fn relayout_sparse<M: Layout<X>>(&self) -> Field<R, M, X> {
        let mut to = self.same_shape::<M>();
        to.set_background(self.background());
        let (from, handle) = (self.handle(), to.handle_mut());
        let differs = |m: usize, at: [u32; MAX_AXES]| {
            let (here, step) = from.component(m, at);
            let spec = &R::Elements::MEMBERS[m];
            (0..spec.components).any(|c| {
                // SAFETY: a component of an element within the shape; `&self` keeps writers away.
                let bytes = unsafe { core::slice::from_raw_parts(here.wrapping_add(c * step), spec.scalar) };
                if !Map::<R, L, X>::is_sparse(m) {
                    return bytes.iter().any(|&byte| byte != 0);
                }
                let (background, _) =
                    from.component_in(m, from.store(m).background, &Handle::<R, L, X>::split(m, at).1);
                // SAFETY: the same component of the background's block, which nothing writes.
                bytes != unsafe { core::slice::from_raw_parts(background.wrapping_add(c * step), spec.scalar) }
            })
        };
        let there = |at| handle.geometry.place(from.geometry.logical(at).map(i64::from));
        let elements = Elements::of::<Whole, R, L, X>(&from);
        each_part(elements.len(), |part| {
            for at in elements.part::<X>(part) {
                if (0..R::Elements::MEMBERS.len()).any(|m| differs(m, at)) {
                    // SAFETY: elements lie within the shape, which both have; each part writes its own elements of the new field.
                    unsafe { handle.write::<Whole>(there(at), from.read::<Whole>(at)) };
                }
            }
        });
        to
    }

    /// A new field in another layout with this one's shape and origin.
    fn same_shape<M: Layout<X>>(&self) -> Field<R, M, X> {
        let unbounded = (Map::<R, L, X>::is_unbounded(), Map::<R, M, X>::is_unbounded());
        if unbounded.1 {
            // Whatever bounds there are, its indices are among all.
            return Field::unbounded();
        }
        assert!(
            !unbounded.0,
            "`{}`: an unbounded field has no extents for a layout with bounds",
            core::any::type_name::<R>()
        );
        let extents = self.geometry.shape.map(|n| n as usize);
        let mut to = Field::<R, M, X>::with_extents(extents)
            .unwrap_or_else(|error| panic!("`{}`: {error}", core::any::type_name::<R>()));
        to.geometry.origin = self.geometry.origin;
        to
    }
}
