//! Fields: storage, and how the host reaches it.

mod copy;
mod error;
mod file;
mod finite;
mod host;
mod member;
pub(crate) mod memory;
mod order;
mod parallel;
mod parts;
mod reduce;
mod scan;
pub(crate) mod source;

use core::fmt;
use core::marker::PhantomData;
use std::sync::Mutex;

pub(crate) use error::Spans;
pub use error::{OutOfRange, ShapeError, ShapeMismatch};
pub use file::{FileError, FileFault};
pub use finite::NonFinite;
pub use host::Records;
pub(crate) use host::out_of_range;
pub use member::{Member, MemberMut};
pub use order::{Permutation, PermutationError};
pub use parallel::ParallelRecords;
pub use scan::ScanOverflow;
pub use source::{AnyMember, AnyMemberMut, Source, SourceMut};

use crate::axes::{Axes, I, MAX_AXES, Shape};
use crate::index::{IntoIndex, within};
use crate::layout::{Geometry, Layout, Map};
use crate::record::{Path, Record};
use memory::Memory;

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
    memory: Memory,
    geometry: Geometry,
    /// Private copies of former launches, kept for the next one.
    spare: Mutex<Vec<Memory>>,
    marker: PhantomData<(R, L, X)>,
}

/// A field's address and geometry, which views copy. What may be done through it is its maker's promise.
#[doc(hidden)]
pub struct Handle<'a, R, L, X> {
    pub(crate) root: *mut u8,
    pub(crate) geometry: Geometry,
    /// Where private copies of the field are kept between launches; nowhere for memory that is no field's.
    pub(crate) spare: Option<&'a Mutex<Vec<Memory>>>,
    marker: PhantomData<(R, L, X)>,
}

impl<R, L, X> Clone for Handle<'_, R, L, X> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<R, L, X> Copy for Handle<'_, R, L, X> {}

// SAFETY: a handle is an address; every read or write through it is justified where it is made, by the borrow of the
// field (host views) or by the launch's rules (kernel views).
unsafe impl<R, L, X> Send for Handle<'_, R, L, X> {}
// SAFETY: as above.
unsafe impl<R, L, X> Sync for Handle<'_, R, L, X> {}

impl<R, L, X> Handle<'_, R, L, X> {
    /// A handle for the elements of a slice.
    #[inline]
    pub(crate) fn of_slice(root: *mut u8, geometry: Geometry) -> Self {
        Self { root, geometry, spare: None, marker: PhantomData }
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Handle<'_, R, L, X> {
    /// The same geometry at another address, where as many bytes lie.
    #[inline(always)]
    pub(crate) fn at(self, root: *mut u8) -> Self {
        Self { root, ..self }
    }

    /// A member's first component at an element, and the distance of its components.
    #[inline(always)]
    pub(crate) fn component(&self, m: usize, at: [u32; MAX_AXES]) -> (*mut u8, usize) {
        let offset = Map::<R, L, X>::offset(&self.geometry, m, at);
        (self.root.wrapping_add(offset), Map::<R, L, X>::component(&self.geometry, m))
    }

    /// Reads a path at an element.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody writes it meanwhile.
    #[inline(always)]
    pub(crate) unsafe fn read<P: Path<R>>(&self, at: [u32; MAX_AXES]) -> P::Value {
        // SAFETY: components of elements within the shape lie in the field's memory, which holds values of their types.
        unsafe {
            P::gather(
                #[inline(always)]
                |m| self.component(m, at),
            )
        }
    }

    /// Writes a path at an element.
    ///
    /// # Safety
    /// The element lies within the shape, and nobody reads or writes it meanwhile.
    #[inline(always)]
    pub(crate) unsafe fn write<P: Path<R>>(&self, at: [u32; MAX_AXES], value: P::Value) {
        // SAFETY: as for `read`, and the caller has the element to itself.
        unsafe {
            P::scatter(
                value,
                #[inline(always)]
                |m| self.component(m, at),
            )
        }
    }

    /// Whether an index lies within the shape.
    #[inline(always)]
    pub(crate) fn locate(&self, index: impl IntoIndex<X>) -> Option<[u32; MAX_AXES]> {
        within::<X>(index.coordinates(), &self.geometry)
    }
}

impl<R: Record, L> Field<R, L> {
    /// A field of so many elements an axis, full of zeros. The axes follow from the number of extents.
    ///
    /// # Panics
    /// Where [`try_new`](Self::try_new) returns an error.
    pub fn new<S: Shape>(shape: S) -> Field<R, L, S::X>
    where
        L: Layout<S::X>,
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
    pub fn try_new<S: Shape>(shape: S) -> Result<Field<R, L, S::X>, ShapeError>
    where
        L: Layout<S::X>,
    {
        Field::<R, L, S::X>::with_extents(shape.per_axis())
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    pub(crate) fn with_extents(extents: crate::axes::PerAxis) -> Result<Self, ShapeError> {
        Map::<R, L, X>::complete();
        let geometry = Geometry::new::<L, X>(extents)?;
        let shape = || extents[..X::RANK].to_vec();
        let bytes = Map::<R, L, X>::bytes(&geometry).ok_or_else(|| ShapeError::TooLarge { shape: shape() })?;
        let memory = Memory::zeroed(bytes, Map::<R, L, X>::LINE)
            .ok_or_else(|| ShapeError::OutOfMemory { shape: shape(), bytes })?;
        Ok(Self { memory, geometry, spare: Mutex::new(Vec::new()), marker: PhantomData })
    }

    /// This field with the same record everywhere: what a fresh field holds.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let far = Field::<f32, Blocked<4>>::new([10, 6]).with_background(f32::INFINITY);
    /// assert_eq!(far.get([9, 5]), f32::INFINITY);
    /// ```
    #[must_use]
    pub fn with_background(mut self, record: R) -> Self {
        self.fill(record);
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
        self.geometry = self.geometry.with_origin::<X>(origin.coordinates())?;
        Ok(self)
    }

    /// A handle for reading, while `self` is borrowed; or for writing, where the caller holds `&mut`.
    #[inline(always)]
    pub(crate) fn handle(&self) -> Handle<'_, R, L, X> {
        Handle { root: self.memory.start(), geometry: self.geometry, spare: Some(&self.spare), marker: PhantomData }
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
        self.memory.bytes()
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
        let mut memory = Memory::zeroed_or_abort(self.memory.bytes(), Map::<R, L, X>::LINE);
        memory.as_mut_slice().copy_from_slice(self.memory.as_slice());
        Self { memory, geometry: self.geometry, spare: Mutex::new(Vec::new()), marker: PhantomData }
    }
}
