//! What can be wrong with a field's file.

use core::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::field::ShapeError;

/// Why a field cannot be saved to a file or loaded from one. It names the file.
#[derive(Debug)]
pub struct FileError {
    path: PathBuf,
    fault: FileFault,
}

impl FileError {
    pub(super) fn new(path: &Path, fault: FileFault) -> Self {
        Self { path: path.to_owned(), fault }
    }
    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }
    /// What is wrong with it.
    pub fn fault(&self) -> &FileFault {
        &self.fault
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` {}", self.path.display(), self.fault)
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.fault {
            FileFault::Write(error) | FileFault::Read(error) => Some(error),
            FileFault::Memory(error) => Some(error),
            _ => None,
        }
    }
}

/// What is wrong with a field's file.
#[derive(Debug)]
#[non_exhaustive]
pub enum FileFault {
    /// The system does not let it be written.
    Write(io::Error),
    /// The system does not let it be read.
    Read(io::Error),
    /// It is no archive: something else, or cut off.
    Archive {
        /// What its reader says.
        why: String,
    },
    /// A part of it is damaged, or not what its name says.
    Entry {
        /// The part's name.
        entry: String,
        /// What is wrong with it.
        why: String,
    },
    /// It was written in a way that this version does not know.
    Format {
        /// The part that describes it.
        entry: String,
        /// How that begins.
        found: String,
    },
    /// The record has a member that it does not hold.
    Missing {
        /// The array that is not there.
        entry: String,
    },
    /// It holds an array that the record has no member for.
    Unknown {
        /// The array.
        entry: String,
    },
    /// An array is of other numbers than its member.
    Scalar {
        /// The array.
        entry: String,
        /// What it holds, in NumPy's words.
        found: String,
        /// What the member holds, in NumPy's words.
        expected: &'static str,
    },
    /// An array has another shape than the field.
    Shape {
        /// The array.
        entry: String,
        /// The extents that it has.
        found: Vec<u64>,
        /// The extents that it must have: the field's, and for members of several components their number.
        expected: Vec<u64>,
    },
    /// A value is none of its type: a `bool` other than 0 and 1, an integer that is no variant of an enum.
    Value {
        /// The array.
        entry: String,
        /// The element's index.
        index: Vec<u32>,
        /// What stands there.
        found: i64,
    },
    /// There is no memory for what it holds.
    Memory(ShapeError),
}

impl fmt::Display for FileFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Write(error) => write!(f, "cannot be written: {error}"),
            Self::Read(error) => write!(f, "cannot be read: {error}"),
            Self::Archive { why } => write!(f, "is cut off, damaged or no `.npz` file at all: {why}"),
            Self::Entry { entry, why } => write!(f, "cannot be used: `{entry}` {why}"),
            Self::Format { entry, found } => {
                write!(f, "is of a format that this version does not know: `{entry}` begins with {found:?}")
            }
            Self::Missing { entry } => write!(f, "has no `{entry}`, which the record asks for"),
            Self::Unknown { entry } => write!(f, "has `{entry}`, for which the record has no member"),
            Self::Scalar { entry, found, expected } => {
                write!(f, "has another record: `{entry}` holds `{found}`, its member `{expected}`")
            }
            Self::Shape { entry, found, expected } => {
                write!(f, "has another shape: `{entry}` is of shape {found:?}, where {expected:?} is wanted")
            }
            Self::Value { entry, index, found } => {
                write!(f, "has a value that its type has not: `{entry}` holds {found} at {index:?}")
            }
            Self::Memory(error) => write!(f, "cannot be loaded: {error}"),
        }
    }
}
