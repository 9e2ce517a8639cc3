//! The indices of active elements as an array: a row an element, a column an axis.

use std::io::{self, Read, Write};

use super::{FileFault, PIECE, npy};
use crate::axes::{Axes, MAX_AXES};
use crate::element::Kind;
use crate::index::within;
use crate::layout::Geometry;

/// Its name in the archive.
pub(super) const NAME: &str = "allotrope_active.npy";

/// Writes the indices of places.
pub(super) fn write<X: Axes>(
    output: &mut impl Write,
    places: &[[u32; MAX_AXES]],
    geometry: &Geometry,
) -> io::Result<()> {
    npy::write(output, Kind::I32, &[places.len() as u64, X::RANK as u64])?;
    let mut piece = Vec::with_capacity(PIECE + size_of::<[i32; MAX_AXES]>());
    for &place in places {
        for c in &geometry.logical(place)[..X::RANK] {
            piece.extend_from_slice(&c.to_ne_bytes());
        }
        if piece.len() >= PIECE {
            output.write_all(&piece)?;
            piece.clear();
        }
    }
    output.write_all(&piece)
}

/// Reads indices: their places, each within the shape.
pub(super) fn read<X: Axes>(
    mut input: impl Read,
    name: &str,
    geometry: &Geometry,
) -> Result<Vec<[u32; MAX_AXES]>, FileFault> {
    let fault = |why: String| FileFault::Entry { entry: name.into(), why };
    let header = npy::read(&mut input).map_err(fault)?;
    if header.descr != npy::descr(Kind::I32) || header.fortran_order && X::RANK > 1 {
        let (found, expected) = (header.descr, npy::descr(Kind::I32));
        return Err(FileFault::Scalar { entry: name.into(), found, expected });
    }
    let &[count, axes] = header.shape.as_slice() else {
        return Err(fault(format!(
            "has the shape {:?}, and is to have a row an element and a column an axis",
            header.shape
        )));
    };
    if axes != X::RANK as u64 {
        return Err(fault(format!("has {axes} columns, and the field {} axes", X::RANK)));
    }
    // Nothing is allocated on the file's word: the list grows with what is read.
    let mut places = Vec::new();
    let mut row = vec![0; X::RANK * size_of::<i32>()];
    for n in 0..count {
        input.read_exact(&mut row).map_err(|error| fault(format!("is cut off or damaged: {error}")))?;
        let mut at = [0; MAX_AXES];
        for (c, bytes) in at.iter_mut().zip(row.chunks_exact(size_of::<i32>())) {
            *c = i64::from(i32::from_ne_bytes(bytes.try_into().expect("four bytes")));
        }
        let place = within::<X>(at, geometry).ok_or_else(|| {
            fault(format!("has the index {:?} in row {n}, which lies outside of the field", &at[..X::RANK]))
        })?;
        places.push(place);
    }
    Ok(places)
}
