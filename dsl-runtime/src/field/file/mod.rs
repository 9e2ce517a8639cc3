//! Fields as files that NumPy opens: `.npz`, a ZIP archive of one `.npy` array a member.

mod about;
mod active;
mod beside;
mod error;
mod npy;
mod values;

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

pub use error::{FileError, FileFault};

use super::elements::Elements;
use super::{Field, ShapeError};
use crate::axes::Axes;
use crate::layout::{Layout, Map};
use crate::record::{ElementList, Names, Record};

/// Bytes that are moved at a time.
const PIECE: usize = 1 << 16;

/// What archives add to an array's bytes, at most.
const HEADERS: u64 = 1 << 12;

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// Saves the field as an `.npz` file, which NumPy opens: `numpy.load("grid.npz")["velocity"]`.
    ///
    /// There is an array a member, named after it, or `value` for a bare element, whose axes are the field's and, where
    /// the member has several components, one over these: `velocity: Vec2` of a field of 64 by 48 has the shape
    /// `(64, 48, 2)`. Matrices are their columns, one after another. The file does not depend on the layout, but for
    /// its name in `allotrope.json`, which describes the field. Nothing is compressed, since that takes longer than
    /// most disks.
    ///
    /// Of a sparse field the arrays hold the active elements alone, one after another in row-major order, and an array `allotrope_active` of
    /// as many rows their indices: `f = numpy.load("smoke.npz"); f["density"], f["allotrope_active"]`. Where only some branches of a layout
    /// are sparse, or several, each member of such a branch has an array of its own, `allotrope_active_density`. The background is the
    /// field's, not the file's.
    ///
    /// The file is written beside its place, brought to the disk and renamed: there is the former one or the new one,
    /// never half of one.
    ///
    /// # Errors
    /// Where the system does not let it be written.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// # let folder = tempfile::tempdir().unwrap();
    /// # let path = folder.path().join("heat.npz");
    /// let mut heat = Field::<f32, Blocked<8>>::new([64, 48]);
    /// heat.set([3, 5], 1.5);
    /// heat.save(&path)?;
    ///
    /// let mut again = Field::<f32, Soa>::new([64, 48]);
    /// again.load(&path)?;
    /// assert_eq!(again.to_vec(), heat.to_vec());
    /// # Ok::<(), allotrope::FileError>(())
    /// ```
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), FileError> {
        let path = path.as_ref();
        beside::write(path, |file| self.write_archive(file))
            .map_err(|error| FileError::new(path, FileFault::Write(error)))
    }

    /// Takes all values, and which elements are active, from an `.npz` file that [`save`](Self::save) has written from a field of the same
    /// record and shape, in any layout, and its [origin](Self::origin); or NumPy, which leaves this field's origin as it is, with an array for every member and no other:
    /// `numpy.savez("grid.npz", velocity=v, mass=m)`.
    ///
    /// # Errors
    /// Where the file cannot be read, is cut off or damaged, has another shape or other members, or a `bool` that is
    /// neither 0 nor 1. The error names the file and what is wrong, and the field stays as it was.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// # let folder = tempfile::tempdir().unwrap();
    /// # let path = folder.path().join("heat.npz");
    /// Field::<f32, Aos>::new([64, 48]).save(&path)?;
    /// let error = Field::<f64, Aos>::new([64, 48]).load(&path).unwrap_err();
    /// assert!(error.to_string().ends_with("has another record: `value.npy` holds `<f4`, its member `<f8`"));
    /// # Ok::<(), allotrope::FileError>(())
    /// ```
    pub fn load(&mut self, path: impl AsRef<Path>) -> Result<(), FileError> {
        let path = path.as_ref();
        let fresh = self.read_archive(path).map_err(|fault| FileError::new(path, fault))?;
        (self.storage, self.geometry) = (fresh.storage, fresh.geometry);
        Ok(())
    }

    fn write_archive(&self, file: &mut File) -> io::Result<()> {
        let mut archive = ZipWriter::new(BufWriter::new(file));
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
        archive.start_file(about::NAME, options)?;
        archive.write_all(about::write::<R, L, X>(&self.extents(), &self.geometry.origin[..X::RANK]).as_bytes())?;
        let large = |bytes: usize| options.large_file(bytes as u64 > u64::from(u32::MAX) - HEADERS);
        let mut written: Vec<String> = Vec::new();
        for (m, spec) in R::Elements::MEMBERS.iter().enumerate() {
            let elements = Elements::of_member(&self.handle(), m);
            if let Elements::Active(places) = &elements {
                let name = active_entry::<R, L, X>(m);
                if !written.contains(&name) {
                    archive.start_file(name.as_str(), large(places.len() * X::RANK * size_of::<i32>()))?;
                    active::write::<X>(&mut archive, places, &self.geometry)?;
                    written.push(name);
                }
            }
            archive.start_file(entry::<R>(m), large(elements.len() * values::size(spec)))?;
            npy::write(&mut archive, spec.kind, &self.array_shape(m, &elements))?;
            let mut piece = Vec::with_capacity(PIECE + values::size(spec));
            for at in elements.all::<X>() {
                values::append(self, m, at, &mut piece);
                if piece.len() >= PIECE {
                    archive.write_all(&piece)?;
                    piece.clear();
                }
            }
            archive.write_all(&piece)?;
        }
        archive.finish()?.flush()
    }

    /// A field of this one's shape with what the file holds.
    fn read_archive(&self, path: &Path) -> Result<Self, FileFault> {
        let file = File::open(path).map_err(FileFault::Read)?;
        let mut archive =
            ZipArchive::new(BufReader::new(file)).map_err(|error| FileFault::Archive { why: error.to_string() })?;
        let known: Vec<String> = (0..R::Elements::MEMBERS.len()).map(entry::<R>).collect();
        for name in archive.file_names() {
            let name = name.map_err(|error| FileFault::Archive { why: error.to_string() })?;
            let active = |m: usize| name == own_active_entry::<R>(m);
            let is_active = name == active::NAME || (0..known.len()).any(active);
            if name != about::NAME && !is_active && !known.iter().any(|known| *known == name) {
                return Err(FileFault::Unknown { entry: name.into_owned() });
            }
        }
        let origin = match archive.index_for_name(about::NAME) {
            Some(number) => about::read(open(&mut archive, number, about::NAME)?)?,
            None => None,
        };
        // All arrays are asked for before any is read, and memory is for this field's shape, not for the file's.
        let numbers = known
            .iter()
            .map(|entry| archive.index_for_name(entry).ok_or_else(|| FileFault::Missing { entry: entry.clone() }));
        let numbers = numbers.collect::<Result<Vec<usize>, FileFault>>()?;
        let mut fresh = self.empty().map_err(FileFault::Memory)?;
        // Arrays of another shape are told before an origin that does not suit this one.
        let moved = match Map::<R, L, X>::is_unbounded() {
            true => Ok(self.geometry),
            false => about::moved::<X>(self.geometry, &origin),
        };
        fresh.geometry = *moved.as_ref().unwrap_or(&self.geometry);
        for (m, (number, entry)) in numbers.into_iter().zip(&known).enumerate() {
            let own = own_active_entry::<R>(m);
            let listed =
                [own.as_str(), active::NAME].into_iter().find_map(|name| Some((name, archive.index_for_name(name)?)));
            let elements = match listed {
                Some((name, number)) => {
                    active::read::<X>(open(&mut archive, number, name)?, name, &fresh.geometry).map(Elements::Active)?
                }
                None => Elements::All(self.geometry.shape),
            };
            fresh.read_array(m, entry, &elements, open(&mut archive, number, entry)?)?;
        }
        fresh.geometry = moved?;
        Ok(fresh)
    }

    /// Takes the values of member `m` from an array, which must end with them.
    fn read_array(
        &mut self,
        m: usize,
        entry: &str,
        elements: &Elements,
        mut input: impl Read,
    ) -> Result<(), FileFault> {
        let fault = |why: String| FileFault::Entry { entry: entry.into(), why };
        let (spec, expected) = (&R::Elements::MEMBERS[m], self.array_shape(m, elements));
        let header = npy::read(&mut input).map_err(fault)?;
        if header.descr != npy::descr(spec.kind) {
            let (entry, expected) = (entry.into(), npy::descr(spec.kind));
            return Err(FileFault::Scalar { entry, found: header.descr, expected });
        }
        if header.shape != expected {
            return Err(FileFault::Shape { entry: entry.into(), found: header.shape, expected });
        }
        if header.fortran_order && expected.len() > 1 {
            return Err(fault("is in Fortran's order: save `numpy.ascontiguousarray` of it".into()));
        }
        let damaged = |error: io::Error| fault(format!("is cut off or damaged: {error}"));
        let size = values::size(spec);
        let (mut places, mut left) = (elements.all::<X>(), elements.len());
        let mut piece = vec![0; size * (PIECE / size.max(1)).max(1)];
        while left > 0 {
            let count = left.min(piece.len() / size.max(1)).max(1);
            left -= count;
            let piece = &mut piece[..size * count];
            input.read_exact(piece).map_err(damaged)?;
            for (n, at) in places.by_ref().take(count).enumerate() {
                values::put(self, m, at, &piece[n * size..(n + 1) * size]).map_err(|found| FileFault::Value {
                    entry: entry.into(),
                    index: at[..X::RANK].to_vec(),
                    found,
                })?;
            }
        }
        // The archive's sum of the array's bytes is compared at their end.
        match input.read(&mut [0]).map_err(damaged)? {
            0 => Ok(()),
            _ => Err(fault("goes on after its last value".into())),
        }
    }

    /// The field's extents.
    fn extents(&self) -> Vec<u64> {
        self.geometry.shape[..X::RANK].iter().map(|&n| u64::from(n)).collect()
    }

    /// A field of the same shape and background without active elements.
    fn empty(&self) -> Result<Self, ShapeError> {
        if Map::<R, L, X>::is_unbounded() {
            return Ok(Self::unbounded().with_background(self.background()));
        }
        let fresh = Self::with_extents(self.geometry.shape.map(|n| n as usize))?;
        Ok(if Map::<R, L, X>::any_sparse() { fresh.with_background(self.background()) } else { fresh })
    }

    /// The extents of the array of member `m`.
    fn array_shape(&self, m: usize, elements: &Elements) -> Vec<u64> {
        let components = R::Elements::MEMBERS[m].components;
        let mut shape = match elements {
            Elements::All(_) => self.extents(),
            Elements::Active(places) => vec![places.len() as u64],
        };
        if components != 1 {
            shape.push(components as u64);
        }
        shape
    }
}

/// The name of the array of member `m`.
fn array_name<R: Record>(m: usize) -> &'static str {
    if R::Elements::BARE { "value" } else { Names::<R>::ALL[m] }
}

/// The name of its file in the archive.
fn entry<R: Record>(m: usize) -> String {
    format!("{}.npy", array_name::<R>(m))
}

/// The name of the indices of the active elements that a member's array holds.
fn active_entry<R: Record, L: Layout<X>, X: Axes>(m: usize) -> String {
    if L::BRANCHES == 1 { active::NAME.to_owned() } else { own_active_entry::<R>(m) }
}

/// The same where the member has its own.
fn own_active_entry<R: Record>(m: usize) -> String {
    format!("allotrope_active_{}.npy", array_name::<R>(m))
}

/// A part of an archive, to be read.
fn open<'a, F: Read + io::Seek>(
    archive: &'a mut ZipArchive<F>,
    number: usize,
    entry: &str,
) -> Result<impl Read + use<'a, F>, FileFault> {
    let fault =
        |error: zip::result::ZipError| FileFault::Entry { entry: entry.into(), why: format!("is damaged: {error}") };
    archive.by_index(number).map_err(fault)
}
