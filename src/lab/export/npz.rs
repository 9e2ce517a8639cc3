//! Arrays as NumPy's `.npz`: a ZIP archive with a `.npy` file (version 1.0 of its format) for each array, and texts
//! beside them.

use std::io::{Cursor, Read, Write};

use allotrope_solvers::{Array, Values};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use crate::lab::errors::LabError;

/// With what every `.npy` file of version 1.0 begins.
const MAGIC: &[u8; 8] = b"\x93NUMPY\x01\x00";

/// `.npy` files hold their values from a multiple of so many bytes on.
const ALIGNMENT: usize = 64;

/// A file of more bytes than this needs the longer fields of a ZIP archive.
const LARGE: usize = u32::MAX as usize;

/// What an `.npz` file holds, in its order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Npz {
    /// Name, components an element, and values.
    pub arrays: Vec<(String, usize, Values)>,
    /// The name with its ending, and what it says.
    pub texts: Vec<(String, String)>,
}

/// The bytes of an `.npz` file: each array as `<f4`, `<f8` or `<u4` of the shape `(n,)` or `(n, components)`, not compressed,
/// since that takes longer than most disks; and texts, whose names have an ending, such as `about.json`. The same
/// arrays and texts give the same bytes.
///
/// # Errors
/// If an array's values are no multiple of its components, or a name comes twice.
pub fn write(arrays: &[Array], texts: &[(&str, &str)]) -> Result<Vec<u8>, LabError> {
    let fault = |name: &str, why: &dyn std::fmt::Display| {
        LabError::failure(format!("`{name}` cannot be put into an `.npz` file: {why}"))
    };
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default();
    for array in arrays {
        let Array { name, components, ref values } = *array;
        if components == 0 || !values.len().is_multiple_of(components) {
            let why = format!("its {} values are not {components} an element", values.len());
            return Err(fault(name, &why));
        }
        let options = options
            .compression_method(CompressionMethod::Stored)
            .large_file(size(values) * values.len() > LARGE - 1024);
        archive.start_file(format!("{name}.npy"), options).map_err(|error| fault(name, &error))?;
        write_npy(&mut archive, components, values).map_err(|error| fault(name, &error))?;
    }
    for (name, text) in texts {
        if name.ends_with(".npy") {
            return Err(fault(name, &"this is the ending of arrays"));
        }
        let options = options.compression_method(CompressionMethod::Deflated).large_file(text.len() > LARGE);
        archive.start_file(*name, options).map_err(|error| fault(name, &error))?;
        archive.write_all(text.as_bytes()).map_err(|error| fault(name, &error))?;
    }
    Ok(archive.finish().map_err(|error| fault("the table of contents", &error))?.into_inner())
}

/// Bytes a value.
fn size(values: &Values) -> usize {
    match values {
        Values::F32(_) | Values::U32(_) => 4,
        Values::F64(_) => 8,
    }
}

fn write_npy(output: &mut impl Write, components: usize, values: &Values) -> std::io::Result<()> {
    let kind = match values {
        Values::F32(_) => "<f4",
        Values::F64(_) => "<f8",
        Values::U32(_) => "<u4",
    };
    let count = values.len() / components;
    let shape = if components == 1 { format!("({count},)") } else { format!("({count}, {components})") };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    let length = (MAGIC.len() + 2 + header.len() + 1).next_multiple_of(ALIGNMENT) - MAGIC.len() - 2;
    header.extend(std::iter::repeat_n(' ', length - 1 - header.len()));
    header.push('\n');
    output.write_all(MAGIC)?;
    // A header of one or two numbers is far shorter than 2^16.
    output.write_all(&(length as u16).to_le_bytes())?;
    output.write_all(header.as_bytes())?;
    match values {
        Values::F32(values) => write_words(output, values, |value| value.to_le_bytes()),
        Values::F64(values) => write_words(output, values, |value| value.to_le_bytes()),
        Values::U32(values) => write_words(output, values, |value| value.to_le_bytes()),
    }
}

/// Writes values of `N` bytes, a piece at a time.
fn write_words<T: Copy, const N: usize>(
    output: &mut impl Write,
    values: &[T],
    bytes: impl Fn(T) -> [u8; N],
) -> std::io::Result<()> {
    const PIECE: usize = 1 << 14;
    let mut buffer = Vec::with_capacity(N * PIECE);
    for piece in values.chunks(PIECE) {
        buffer.clear();
        buffer.extend(piece.iter().flat_map(|&value| bytes(value)));
        output.write_all(&buffer)?;
    }
    Ok(())
}

/// Reads an `.npz` file: arrays of `<f4`, `<f8` or `<u4` with one or two axes, and texts in UTF-8. Every byte of them is
/// checked against the sums that the archive holds.
///
/// # Errors
/// What is wrong, without the name of the file, if it is cut off, damaged, or holds something else.
pub fn read(bytes: &[u8]) -> Result<Npz, String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))
        .map_err(|error| format!("is cut off, damaged or no `.npz` file at all ({} bytes): {error}", bytes.len()))?;
    let mut npz = Npz::default();
    for n in 0..archive.len() {
        let mut member = archive.by_index(n).map_err(|error| format!("is damaged: member {n}: {error}"))?;
        let name = member.name().map_err(|error| format!("is damaged: the name of member {n}: {error}"))?.into_owned();
        let mut content = Vec::new();
        member.read_to_end(&mut content).map_err(|error| format!("is damaged: `{name}`: {error}"))?;
        match name.strip_suffix(".npy") {
            Some(name) => {
                let (components, values) = read_npy(&content).map_err(|why| format!("array `{name}` {why}"))?;
                npz.arrays.push((name.to_string(), components, values));
            }
            None => {
                let text = String::from_utf8(content).map_err(|_| format!("`{name}` is not a text in UTF-8"))?;
                npz.texts.push((name, text));
            }
        }
    }
    Ok(npz)
}

/// Components and values.
fn read_npy(bytes: &[u8]) -> Result<(usize, Values), String> {
    let rest = bytes.strip_prefix(MAGIC).ok_or("does not begin as version 1.0 of `.npy` does")?;
    let (length, rest) = rest.split_first_chunk().ok_or("has no header")?;
    let (header, data) =
        rest.split_at_checked(usize::from(u16::from_le_bytes(*length))).ok_or("ends within its header")?;
    let header = std::str::from_utf8(header).map_err(|_| "has a header that is no text")?;
    let (kind, count, components) =
        parse_header(header).ok_or_else(|| format!("has a header that is not understood: {}", header.trim_end()))?;
    let wanted = count.checked_mul(components).and_then(|values| values.checked_mul(if kind == "<f8" { 8 } else { 4 }));
    if wanted != Some(data.len()) {
        return Err(format!("holds {} bytes, where {count} x {components} values are told", data.len()));
    }
    let words = data.as_chunks::<4>().0.iter();
    match kind {
        "<f4" => Ok((components, Values::F32(words.map(|word| f32::from_le_bytes(*word)).collect()))),
        "<f8" => {
            let words = data.as_chunks::<8>().0.iter();
            Ok((components, Values::F64(words.map(|word| f64::from_le_bytes(*word)).collect())))
        }
        "<u4" => Ok((components, Values::U32(words.map(|word| u32::from_le_bytes(*word)).collect()))),
        _ => Err(format!("is of `{kind}`, where `<f4`, `<f8` or `<u4` is wanted")),
    }
}

/// Kind, elements and components of a header, a literal of Python such as `{'descr': '<f4', 'fortran_order': False,
/// 'shape': (3, 2), }`.
fn parse_header(header: &str) -> Option<(&str, usize, usize)> {
    let value = |key: &str| Some(header.split_once(&format!("'{key}':"))?.1.trim_start());
    let kind = value("descr")?.strip_prefix('\'')?.split_once('\'')?.0;
    let (shape, _) = value("shape")?.strip_prefix('(')?.split_once(')')?;
    let axes: Vec<usize> = shape
        .split(',')
        .map(str::trim)
        .filter(|axis| !axis.is_empty())
        .map(|axis| axis.parse().ok())
        .collect::<Option<_>>()?;
    match (axes[..].split_first()?, value("fortran_order")?.starts_with("False")) {
        ((&count, []), _) => Some((kind, count, 1)),
        ((&count, &[components]), true) => Some((kind, count, components)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrays() -> Vec<Array> {
        let wave: Vec<f32> = (0..3000).map(|n| (n as f32 * 0.37).sin()).collect();
        vec![
            Array { name: "position", components: 3, values: Values::F32(wave) },
            Array { name: "odd", components: 1, values: Values::F32(vec![f32::NAN, -0.0, f32::INFINITY, 1e-42]) },
            Array { name: "identity", components: 1, values: Values::U32((0..50_000).rev().collect()) },
            Array { name: "double", components: 2, values: Values::F64(vec![0.1, -0.0, f64::NAN, 1e-310]) },
            Array { name: "none", components: 2, values: Values::F32(Vec::new()) },
        ]
    }

    fn bits(values: &Values) -> Vec<u64> {
        match values {
            Values::F32(values) => values.iter().map(|value| value.to_bits().into()).collect(),
            Values::F64(values) => values.iter().map(|value| value.to_bits()).collect(),
            Values::U32(values) => values.iter().map(|&value| value.into()).collect(),
        }
    }

    #[test]
    fn what_is_written_is_read_bit_by_bit() {
        let arrays = arrays();
        let texts = [("about.json", "{\"step\": 7}"), ("scene.txt", "grün\n")];
        let bytes = write(&arrays, &texts).unwrap();
        assert_eq!(bytes, write(&arrays, &texts).unwrap(), "no clock is written");
        let npz = read(&bytes).unwrap();
        assert_eq!(npz.arrays.len(), arrays.len());
        for ((name, components, values), array) in npz.arrays.iter().zip(&arrays) {
            assert_eq!((name.as_str(), *components), (array.name, array.components));
            assert_eq!(std::mem::discriminant(values), std::mem::discriminant(&array.values), "{name}");
            assert_eq!(bits(values), bits(&array.values), "{name}");
        }
        assert_eq!(npz.texts, texts.map(|(name, text)| (name.to_string(), text.to_string())));
    }

    #[test]
    fn what_cannot_be_written_is_told() {
        let odd = Array { name: "odd", components: 2, values: Values::F32(vec![1.0; 3]) };
        let message = write(&[odd], &[]).unwrap_err().to_string();
        assert_eq!(message, "`odd` cannot be put into an `.npz` file: its 3 values are not 2 an element");
        let twice = [arrays().remove(0), arrays().remove(0)];
        assert!(write(&twice, &[]).unwrap_err().to_string().starts_with("`position` cannot be put"));
        assert!(write(&[], &[("x.npy", "")]).is_err());
    }

    #[test]
    fn a_file_that_is_cut_off_is_refused() {
        let bytes = write(&arrays(), &[("about.json", "{}")]).unwrap();
        for end in (0..10).map(|tenth| bytes.len() * tenth / 10).chain([bytes.len() - 1]) {
            let message = read(&bytes[..end]).unwrap_err();
            let start = format!("is cut off, damaged or no `.npz` file at all ({end} bytes): ");
            assert!(message.starts_with(&start), "{message}");
        }
    }

    #[test]
    fn a_damaged_value_is_refused_by_the_name_of_its_array() {
        let bytes = write(&arrays(), &[]).unwrap();
        for (name, place) in [("position", 6000), ("identity", 100_000)] {
            let mut damaged = bytes.clone();
            damaged[place] ^= 1;
            assert_eq!(read(&damaged).unwrap_err(), format!("is damaged: `{name}.npy`: Invalid checksum"));
        }
    }

    #[test]
    fn damage_anywhere_is_an_error_or_does_no_harm() {
        let bytes = write(&arrays()[1..2], &[("about.json", "{}")]).unwrap();
        let whole = read(&bytes).unwrap();
        let mut refused = 0;
        for place in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[place] ^= 0x41;
            match read(&damaged) {
                Err(_) => refused += 1,
                Ok(npz) => {
                    // Dates and the like may change; a value or a text never does.
                    for ((_, components, values), (_, wanted, right)) in npz.arrays.iter().zip(&whole.arrays) {
                        assert_eq!((components, bits(values)), (wanted, bits(right)), "byte {place}");
                    }
                }
            }
        }
        assert!(refused > bytes.len() / 2, "{refused} of {}", bytes.len());
    }

    #[test]
    fn headers_are_read_as_numpy_writes_them() {
        let header = |text| parse_header(text);
        assert_eq!(header("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }   \n"), Some(("<f4", 3, 2)));
        assert_eq!(header("{'descr': '<u4', 'fortran_order': True, 'shape': (5,), }"), Some(("<u4", 5, 1)));
        assert_eq!(header("{'shape':(0,), 'fortran_order':False,'descr':'<f8'}"), Some(("<f8", 0, 1)));
        assert_eq!(header("{'descr': '<f4', 'fortran_order': True, 'shape': (3, 2), }"), None);
        assert_eq!(header("{'descr': '<f4', 'fortran_order': False, 'shape': (), }"), None);
        assert_eq!(header("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2, 3), }"), None);
        assert_eq!(header("{'descr': '<f4', 'fortran_order': False, 'shape': (-1,), }"), None);
        assert_eq!(header(""), None);
    }

    #[test]
    fn an_array_that_tells_more_than_it_holds_is_refused() {
        let mut bytes = Vec::new();
        write_npy(&mut bytes, 1, &Values::F32(vec![1.0; 4])).unwrap();
        assert_eq!(bytes.len(), ALIGNMENT * 2 + 16);
        assert_eq!(read_npy(&bytes[..140]).unwrap_err(), "holds 12 bytes, where 4 x 1 values are told");
        assert_eq!(read_npy(&bytes[..50]).unwrap_err(), "ends within its header");
        assert_eq!(read_npy(&bytes[..9]).unwrap_err(), "has no header");
        assert_eq!(read_npy(b"PK").unwrap_err(), "does not begin as version 1.0 of `.npy` does");
    }
}
