//! Reads meshes from STL files, binary ones and texts.

use super::weld::Welder;
use super::{Mesh, MeshError};

/// Bytes before the triangles of a binary file: a comment, and their number.
const HEADER: usize = 84;

/// Bytes of a triangle: its normal, three vertices, and two bytes more.
const TRIANGLE: usize = 50;

/// Whether these are a text in STL, or as many bytes as a binary file of its header has.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    is_text(bytes) || promised(bytes).is_some_and(|count| bytes.len() as u64 == size(count))
}

/// Reads the triangles of an STL file. Their normals are not used: the order of vertices tells the outside.
///
/// # Errors
/// If it is not one, or cut short, a position is not finite, or there is no triangle.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    if is_text(bytes) { read_text(bytes) } else { read_binary(bytes) }
}

/// A text begins with `solid`; but so does the comment of many a binary file, which then has just the bytes that its
/// header promises.
fn is_text(bytes: &[u8]) -> bool {
    let begins = bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    begins && promised(bytes).is_none_or(|count| bytes.len() as u64 != size(count))
}

/// How many triangles the header of a binary file promises.
fn promised(bytes: &[u8]) -> Option<u32> {
    bytes.get(HEADER - 4..HEADER)?.try_into().ok().map(u32::from_le_bytes)
}

fn size(count: u32) -> u64 {
    HEADER as u64 + u64::from(count) * TRIANGLE as u64
}

fn read_binary(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let Some(count) = promised(bytes) else {
        let message =
            format!("is cut short: a binary STL file begins with {HEADER} bytes, and it has {} in all", bytes.len());
        return Err(MeshError(message));
    };
    let (triangles, rest) = bytes[HEADER..].as_chunks::<TRIANGLE>();
    if triangles.len() as u64 != u64::from(count) || !rest.is_empty() {
        let (what, wanted) = if size(count) > bytes.len() as u64 { ("is cut short", "") } else { ("goes on", " only") };
        return Err(MeshError(format!(
            "{what}: its header promises {count} triangles, {} bytes{wanted}, and it has {}, {} triangles",
            size(count),
            bytes.len(),
            triangles.len()
        )));
    }
    let mut welder = Welder::default();
    for triangle in triangles {
        let (numbers, _) = triangle.as_chunks::<4>();
        let number = |n: usize| f64::from(f32::from_le_bytes(numbers[n]));
        let mut corners = [0; 3];
        for (n, corner) in corners.iter_mut().enumerate() {
            // The first three are the normal.
            *corner = welder.vertex([3, 4, 5].map(|axis| number(axis + 3 * n)))?;
        }
        welder.triangle(corners);
    }
    welder.finish()
}

fn read_text(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|_| MeshError("is neither a text in STL nor of the size of a binary STL file".into()))?;
    let mut welder = Welder::default();
    let mut corners = Vec::new();
    let (mut lines, mut facets, mut ended) = (0, 0, false);
    for line in text.lines() {
        lines += 1;
        let fault = |what: &str| {
            let line: String = line.trim().chars().take(40).collect();
            MeshError(format!("has on line {lines} `{line}`, {what}"))
        };
        let words: Vec<&str> = line.split_whitespace().collect();
        let keyword = words.first().map(|word| word.to_ascii_lowercase());
        match keyword.as_deref() {
            None | Some("facet" | "outer") => {}
            Some("solid") => ended = false,
            Some("endsolid") => ended = true,
            Some("vertex") => {
                let numbers: Vec<f64> = words[1..].iter().filter_map(|word| word.parse().ok()).collect();
                let position = <[f64; 3]>::try_from(numbers).ok().filter(|_| words.len() == 4);
                corners.push(welder.vertex(position.ok_or_else(|| fault("where 3 numbers are wanted"))?)?);
            }
            Some("endloop") => {
                let Ok(triangle) = corners[..].try_into() else {
                    return Err(fault(&format!("after {} vertices, where 3 are wanted", corners.len())));
                };
                welder.triangle(triangle);
                corners.clear();
            }
            Some("endfacet") => facets += 1,
            Some(_) => return Err(fault("which is not STL")),
        }
    }
    if !ended {
        let message = format!("is cut short: it ends on line {lines} after {facets} facets, without `endsolid`");
        return Err(MeshError(message));
    }
    welder.finish()
}
