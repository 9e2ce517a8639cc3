//! Fields: storage, and how the host reaches it.

mod copy;
mod elements;
mod error;
mod file;
mod finite;
mod handle;
mod host;
mod lists;
mod member;
pub(crate) mod memory;
mod memory_map;
mod order;
mod parallel;
pub(crate) mod parts;
mod reduce;
mod scan;
pub(crate) mod source;
mod sparse;
mod storage;

use core::fmt;
use core::marker::PhantomData;
use std::sync::Mutex;

pub(crate) use elements::active_places;
pub(crate) use error::Spans;
pub use error::{OutOfRange, ShapeError, ShapeMismatch};
pub use file::{FileError, FileFault};
pub use finite::NonFinite;
pub use handle::Handle;
pub use host::Records;
pub(crate) use host::out_of_range;
pub use lists::{Entries, EntryTuples, ListFull};
pub use member::{Member, MemberMut};
pub use memory_map::{Allocation, MapMember, MemoryMap, Span, Standing};
pub use order::{Permutation, PermutationError};
pub use parallel::ParallelRecords;
pub use scan::ScanOverflow;
pub use source::{AnyMember, AnyMemberMut, Source, SourceMut};

use crate::axes::{AXIS_NAMES, Axes, I, Shape};
use crate::index::IntoIndex;
use crate::layout::{Geometry, Layout, Map, Opens};
use crate::record::Record;
pub use storage::Storage;

/// Storage: records `R` in the layout `L` over the axes `X`.
///
/// A new field holds zeros. Values come and go in logical row-major order, whatever the layout.
///
/// ```
/// use allotrope::prelude::*;
/// let mut heat = Field::<f32, Blocked<8>>::new([64, 48]);
/// heat.set([3, 5], 1.5);
/// assert_eq!(heat.get([3, 5]), 1.5);
/// assert_eq!(heat.shape(), [64, 48]);
/// let same = heat.relayout::<Soa>();
/// assert_eq!(same.get([3, 5]), 1.5);
/// ```
pub struct Field<R, L, X = I> {
    storage: Storage,
    geometry: Geometry,
    /// Private copies of former launches, kept for the next one.
    spare: Mutex<Vec<Storage>>,
    marker: PhantomData<(R, L, X)>,
}

impl<R: Record, L> Field<R, L> {
    /// A field of so many elements an axis, full of zeros; a sparse one is empty. The axes follow from the number of extents; those of a
    /// layout with lists leave out the lists' axis.
    ///
    /// # Panics
    /// Where [`try_new`](Self::try_new) returns an error.
    pub fn new<S: Shape, K>(shape: S) -> Field<R, L, L::X>
    where
        L: Opens<S::X, K>,
    {
        Self::try_new(shape).unwrap_or_else(|error| panic!("`{}`: {error}", core::any::type_name::<R>()))
    }

    /// A field of so many elements an axis, full of zeros.
    ///
    /// # Errors
    /// Where an axis is longer than `i32::MAX`, the bytes overflow, or the system refuses the memory.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let error = Field::<f32, Aos>::try_new([1 << 40]).unwrap_err();
    /// assert!(error.to_string().starts_with("axis `i` has 1099511627776 elements"));
    /// ```
    pub fn try_new<S: Shape, K>(shape: S) -> Result<Field<R, L, L::X>, ShapeError>
    where
        L: Opens<S::X, K>,
    {
        Field::<R, L, L::X>::with_extents(L::extents(shape.per_axis())?)
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    pub(crate) fn with_extents(extents: crate::axes::PerAxis) -> Result<Self, ShapeError> {
        Map::<R, L, X>::complete();
        if Map::<R, L, X>::is_unbounded() {
            return Err(ShapeError::Unbounded);
        }
        let geometry = Geometry::new::<L, X>(extents)?;
        let shape = || extents[..X::RANK].to_vec();
        let bytes = Map::<R, L, X>::bytes(&geometry).ok_or_else(|| ShapeError::TooLarge { shape: shape() })?;
        let storage =
            Storage::new::<R, L, X>(&geometry).ok_or_else(|| ShapeError::OutOfMemory { shape: shape(), bytes })?;
        Ok(Self::with_storage(storage, geometry))
    }

    pub(crate) fn with_storage(storage: Storage, geometry: Geometry) -> Self {
        Self { storage, geometry, spare: Mutex::new(Vec::new()), marker: PhantomData }
    }

    /// This field with the same record everywhere: what a fresh field holds. Of a sparse field, inactive elements hold it, too, and those
    /// that become active.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let far = Field::<f32, Blocked<4>>::new([10, 6]).with_background(f32::INFINITY);
    /// assert_eq!(far.get([9, 5]), f32::INFINITY);
    /// ```
    #[must_use]
    pub fn with_background(mut self, record: R) -> Self {
        self.fill(record);
        self.set_background(record);
        self
    }

    /// This field with indices that begin at `origin` along each axis, below zero or anywhere: valid are `origin` to `origin + shape`,
    /// the latter excluded. A new field's begin at zero.
    ///
    /// The records stay in their places, and indices mean the same everywhere, on the host and in kernels: a loop over the field runs
    /// from the origin, `clamped` and `wrapped` lead to these indices, and kernels may index fields of different origins.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut force = Field::<f32, Blocked<8>>::new([128, 128]).with_origin([-64, -64]);
    /// force.set([-64, 63], 2.5);
    /// assert_eq!(force.get([-64, 63]), 2.5);
    /// let error = force.try_get([64, 0]).unwrap_err();
    /// let expected = "index [64, 0] is out of range of shape [128, 128], whose indices are -64..64, -64..64";
    /// assert_eq!(error.to_string(), expected);
    ///
    /// #[kernel]
    /// fn distance(from: &mut Field<f32, _, Ij>) {
    ///     for ij in from {
    ///         from[ij] = ij.as_vec2().length();
    ///     }
    /// }
    /// distance(&mut force);
    /// assert_eq!(force.get([-3, 4]), 5.0);
    /// ```
    ///
    /// # Panics
    /// Where [`try_with_origin`](Self::try_with_origin) returns an error.
    #[must_use]
    #[track_caller]
    pub fn with_origin(self, origin: impl IntoIndex<X>) -> Self {
        self.try_with_origin(origin).unwrap_or_else(|error| panic!("`{}`: {error}", core::any::type_name::<R>()))
    }

    /// As [`with_origin`](Self::with_origin), where the indices may reach beyond those of an `i32`.
    ///
    /// # Errors
    /// Where the origin is no `i32`, or `origin + shape` is none.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let error = Field::<f32, Aos>::new([128]).try_with_origin(i32::MAX - 100).unwrap_err();
    /// assert!(error.to_string().starts_with("the 128 indices of axis `i` from 2147483547 on reach beyond those of an `i32`"));
    /// ```
    pub fn try_with_origin(mut self, origin: impl IntoIndex<X>) -> Result<Self, ShapeError> {
        let origin = origin.coordinates();
        if Map::<R, L, X>::is_unbounded() {
            return Err(ShapeError::Unbounded);
        }
        if let Some(list) = Map::<R, L, X>::list().filter(|list| origin[list.axis] != 0) {
            return Err(ShapeError::List { axis: AXIS_NAMES[list.axis] });
        }
        self.geometry = self.geometry.with_origin::<X>(origin)?;
        Ok(self)
    }

    /// A handle for reading, while `self` is borrowed; or for writing, where the caller holds `&mut`.
    #[inline(always)]
    pub(crate) fn handle(&self) -> Handle<'_, R, L, X> {
        Handle::new(self.storage.start(), self.geometry, Some(&self.spare), false)
    }

    /// A handle for whatever `&mut` allows.
    #[inline(always)]
    pub(crate) fn handle_mut(&mut self) -> Handle<'_, R, L, X> {
        self.storage.settle();
        Handle::new(self.storage.start(), self.geometry, Some(&self.spare), true)
    }

    /// Elements along each axis.
    pub fn shape(&self) -> X::Extents {
        self.geometry.extents::<X>()
    }

    /// The first index along each axis: zero, or what [`with_origin`](Self::with_origin) has said.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// assert_eq!(Field::<f32, Aos>::new([4, 4]).with_origin((-2, 0)).origin(), ivec2(-2, 0));
    /// ```
    pub fn origin(&self) -> X::Index {
        X::index(self.geometry.origin)
    }

    /// Elements in all.
    pub fn len(&self) -> usize {
        self.geometry.len()
    }

    /// Whether there is no element.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bytes of memory that hold the elements, cells of partial blocks included.
    pub fn bytes(&self) -> usize {
        self.storage.bytes()
    }
}

impl<R: Record + fmt::Debug, L: Layout<X>, X: Axes> fmt::Debug for Field<R, L, X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Field<{}> of shape {:?} ", core::any::type_name::<R>(), self.shape())?;
        if let Some(origin) = self.geometry.moved::<X>() {
            write!(f, "from {origin:?} on ")?;
        }
        f.debug_list().entries(self.iter().take(16)).finish()?;
        if self.len() > 16 { write!(f, " and {} more", self.len() - 16) } else { Ok(()) }
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Clone for Field<R, L, X> {
    fn clone(&self) -> Self {
        let mut field = Self::with_storage(Storage::new_or_abort::<R, L, X>(&self.geometry), self.geometry);
        field.take_all(self, |at| at);
        field
    }
}
