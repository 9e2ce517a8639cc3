//! What can be wrong with a field's extents or an index.

use core::fmt;

use crate::axes::{Axes, MAX_AXES};
use crate::index::IntoIndex;
use crate::layout::Geometry;

/// Why a field of a shape cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ShapeError {
    /// An axis has more elements than an `i32` counts.
    Extent {
        /// Its name.
        axis: &'static str,
        /// Its extent.
        extent: usize,
    },
    /// The layout's root does not name an axis, whose extent then is at most what the inner nodes hold.
    Axis {
        /// Its name.
        axis: &'static str,
        /// Its extent.
        extent: usize,
        /// What the inner nodes hold.
        most: usize,
    },
    /// The indices along an axis are not all `i32`s, or the one after the last is none.
    Origin {
        /// Its name.
        axis: &'static str,
        /// The first index.
        origin: i64,
        /// Its extent.
        extent: usize,
    },
    /// The layout's outermost node is `hash`: its fields have no extents.
    Unbounded,
    /// A list's entries are counted from zero.
    List {
        /// Its axis.
        axis: &'static str,
    },
    /// As many extents were given as the field has axes, one of which is counted by the entries of lists.
    ListExtent {
        /// Its axis.
        axis: &'static str,
    },
    /// The field's bytes overflow the address space.
    TooLarge {
        /// The extents.
        shape: Vec<usize>,
    },
    /// The system refuses the memory.
    OutOfMemory {
        /// The extents.
        shape: Vec<usize>,
        /// The bytes asked for.
        bytes: usize,
    },
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Extent { axis, extent } => {
                write!(f, "axis `{axis}` has {extent} elements, more than the {} that an index counts", i32::MAX)
            }
            Self::Axis { axis, extent, most } => write!(
                f,
                "axis `{axis}` has {extent} elements, but the layout holds {most} along it: name `{axis}` in its outermost node"
            ),
            Self::Origin { axis, origin, extent } => write!(
                f,
                "the {extent} indices of axis `{axis}` from {origin} on reach beyond those of an `i32`, {} to {}",
                i32::MIN,
                i32::MAX - 1
            ),
            Self::Unbounded => f.write_str(
                "a layout whose outermost node is `hash` takes no extents: write `Field::<R, L, X>::unbounded()`",
            ),
            Self::List { axis } => write!(f, "the entries of lists, along axis `{axis}`, are counted from zero"),
            Self::ListExtent { axis } => {
                write!(f, "axis `{axis}` is that of lists, whose maximum the layout gives: leave it out of the extents")
            }
            Self::TooLarge { shape } => write!(f, "a field of shape {shape:?} does not fit in the address space"),
            Self::OutOfMemory { shape, bytes } => {
                write!(f, "a field of shape {shape:?} needs {bytes} bytes, which the system refuses")
            }
        }
    }
}

impl std::error::Error for ShapeError {}

/// Two fields of different shapes where one is wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShapeMismatch {
    /// The extents of the field that was to take the records.
    pub shape: Vec<usize>,
    /// The extents of the field that has them.
    pub other: Vec<usize>,
}

impl fmt::Display for ShapeMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a field of shape {:?} cannot take the records of one of shape {:?}", self.shape, self.other)
    }
}

impl std::error::Error for ShapeMismatch {}

/// An index that lies outside of a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutOfRange {
    /// The index.
    pub index: Vec<i64>,
    /// The field's extents.
    pub shape: Vec<usize>,
    /// The field's first index.
    pub origin: Vec<i32>,
}

impl OutOfRange {
    /// That an index lies outside of a field of this geometry.
    pub(crate) fn new<X: Axes>(index: impl IntoIndex<X>, geometry: &Geometry) -> Self {
        Self::at::<X>(index.coordinates(), geometry)
    }

    /// That coordinates lie outside of a field of this geometry.
    pub(crate) fn at<X: Axes>(at: [i64; MAX_AXES], geometry: &Geometry) -> Self {
        Self {
            index: at[..X::RANK].to_vec(),
            shape: geometry.extents::<X>().as_ref().to_vec(),
            origin: geometry.origin[..X::RANK].to_vec(),
        }
    }
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "index {:?} is out of range of shape {:?}", self.index, self.shape)?;
        if self.origin.iter().any(|&first| first != 0) {
            let extents = self.shape.iter().map(|&extent| extent as i64);
            write!(f, ", whose indices are {}", Spans(self.origin.iter().copied().zip(extents)))?;
        }
        Ok(())
    }
}

/// The indices along each axis, from first indices and extents: `-64..64, -64..64`.
pub(crate) struct Spans<T>(pub(crate) T);

impl<T: Iterator<Item = (i32, i64)> + Clone> fmt::Display for Spans<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (axis, (first, extent)) in self.0.clone().enumerate() {
            let before = if axis == 0 { "" } else { ", " };
            write!(f, "{before}{first}..{}", i64::from(first) + extent)?;
        }
        Ok(())
    }
}

impl std::error::Error for OutOfRange {}
