//! The header of a `.npy` array, as NumPy's `numpy.lib.format` describes it: a magic text, a version, and a dictionary
//! in Python's words. The values follow.

use std::io::{self, Read, Write};

use crate::element::Kind;

/// With what every array begins; two bytes of version follow.
const MAGIC: &[u8; 6] = b"\x93NUMPY";

/// Values begin at a multiple of so many bytes.
const ALIGNMENT: usize = 64;

/// The longest header that is read. NumPy's own are of one or two hundred bytes.
const LONGEST: usize = 1 << 16;

/// What an array holds.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Header {
    /// The type of its values, in NumPy's words.
    pub(super) descr: String,
    /// Whether the first axis is the fastest.
    pub(super) fortran_order: bool,
    /// Its extents, as the file says: nothing may be allocated on their word.
    pub(super) shape: Vec<u64>,
}

/// A scalar in NumPy's words, as this machine holds it.
pub(super) fn descr(kind: Kind) -> &'static str {
    macro_rules! native {
        ($little:literal, $big:literal) => {
            if cfg!(target_endian = "little") { $little } else { $big }
        };
    }
    match kind {
        Kind::F32 => native!("<f4", ">f4"),
        Kind::F64 => native!("<f8", ">f8"),
        Kind::I8 => "|i1",
        Kind::I16 => native!("<i2", ">i2"),
        Kind::I32 => native!("<i4", ">i4"),
        Kind::I64 => native!("<i8", ">i8"),
        Kind::U8 => "|u1",
        Kind::U16 => native!("<u2", ">u2"),
        Kind::U32 => native!("<u4", ">u4"),
        Kind::U64 => native!("<u8", ">u8"),
        Kind::Bool => "|b1",
    }
}

/// Writes a header of version 1.0 for an array of row-major order.
pub(super) fn write(output: &mut impl Write, kind: Kind, shape: &[u64]) -> io::Result<()> {
    let extents = match shape {
        [one] => format!("({one},)"),
        _ => format!("({})", shape.iter().map(u64::to_string).collect::<Vec<_>>().join(", ")),
    };
    let mut text = format!("{{'descr': '{}', 'fortran_order': False, 'shape': {extents}, }}", descr(kind));
    let before = MAGIC.len() + 4;
    let length = (before + text.len() + 1).next_multiple_of(ALIGNMENT) - before;
    text.extend(std::iter::repeat_n(' ', length - 1 - text.len()));
    text.push('\n');
    output.write_all(MAGIC)?;
    output.write_all(&[1, 0])?;
    output.write_all(&u16::try_from(length).expect("five numbers at most").to_le_bytes())?;
    output.write_all(text.as_bytes())
}

/// Reads a header; what is wrong with it otherwise.
pub(super) fn read(input: &mut impl Read) -> Result<Header, String> {
    let mut exact =
        |bytes: &mut [u8]| input.read_exact(bytes).map_err(|error| format!("ends within its header: {error}"));
    let mut start = [0; 8];
    exact(&mut start)?;
    if !start.starts_with(MAGIC) {
        return Err("is no `.npy` array".into());
    }
    let length = match start[6..] {
        [1, _] => {
            let mut length = [0; 2];
            exact(&mut length)?;
            usize::from(u16::from_le_bytes(length))
        }
        [2 | 3, _] => {
            let mut length = [0; 4];
            exact(&mut length)?;
            u32::from_le_bytes(length) as usize
        }
        _ => return Err(format!("is of version {}.{} of `.npy`", start[6], start[7])),
    };
    if length > LONGEST {
        return Err(format!("has a header of {length} bytes"));
    }
    let mut text = vec![0; length];
    exact(&mut text)?;
    let text = String::from_utf8(text).map_err(|_| "has a header that is no text")?;
    parse(&text).ok_or_else(|| format!("has a header that is not understood: {}", text.trim_end()))
}

/// A dictionary such as `{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2), }`: these three keys, in any order.
fn parse(text: &str) -> Option<Header> {
    let mut rest = text.trim().strip_prefix('{')?.strip_suffix('}')?.trim_start();
    let (mut descr, mut fortran_order, mut shape) = (None, None, None);
    while !rest.is_empty() {
        let (key, after) = rest.strip_prefix('\'')?.split_once('\'')?;
        let value = after.trim_start().strip_prefix(':')?.trim_start();
        rest = match key {
            "descr" => {
                let (kind, after) = value.strip_prefix('\'')?.split_once('\'')?;
                descr = Some(kind.to_owned());
                after
            }
            "fortran_order" => {
                let after = value.strip_prefix("True").map(|after| (true, after));
                let (order, after) = after.or_else(|| Some((false, value.strip_prefix("False")?)))?;
                fortran_order = Some(order);
                after
            }
            "shape" => {
                let (extents, after) = value.strip_prefix('(')?.split_once(')')?;
                shape = Some(parse_extents(extents)?);
                after
            }
            _ => return None,
        };
        rest = rest.trim_start();
        rest = match rest.strip_prefix(',') {
            Some(after) => after.trim_start(),
            None if rest.is_empty() => rest,
            None => return None,
        };
    }
    Some(Header { descr: descr?, fortran_order: fortran_order?, shape: shape? })
}

/// What stands between a tuple's brackets: nothing, `3,` or `3, 2`.
fn parse_extents(text: &str) -> Option<Vec<u64>> {
    let text = text.trim();
    if text.is_empty() {
        return Some(Vec::new());
    }
    let text = text.strip_suffix(',').unwrap_or(text);
    text.split(',').map(|extent| extent.trim().parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_are_read_as_they_are_written() {
        for shape in [&[][..], &[7], &[0, 3], &[1, 2, 3, 4, 5], &[u64::MAX; 5]] {
            let mut bytes = Vec::new();
            write(&mut bytes, Kind::F32, shape).expect("memory");
            assert!(bytes.len().is_multiple_of(ALIGNMENT) && bytes.ends_with(b"\n"));
            let header = read(&mut &bytes[..]).expect("a header");
            assert_eq!(header, Header { descr: descr(Kind::F32).into(), fortran_order: false, shape: shape.into() });
        }
    }

    #[test]
    fn headers_of_other_writers_are_read() {
        let read = |text| parse(text).map(|header| (header.descr, header.fortran_order, header.shape));
        let found = read("{'shape':(0,), 'fortran_order':True,'descr':'<f8'}   \n");
        assert_eq!(found, Some(("<f8".into(), true, vec![0])));
        assert_eq!(read("{ 'descr' : '|b1' , 'fortran_order': False, 'shape': ( ) , }").map(|all| all.2), Some(vec![]));
        for wrong in [
            "",
            "{}",
            "{'descr': '<f4', 'fortran_order': False}",
            "{'descr': '<f4', 'fortran_order': False, 'shape': (-1,)}",
            "{'descr': '<f4', 'fortran_order': False, 'shape': (18446744073709551616,)}",
            "{'descr': '<f4', 'fortran_order': Maybe, 'shape': (1,)}",
            "{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (1,)}",
            "{'descr': '<f4' 'fortran_order': False, 'shape': (1,)}",
            "{'descr': '<f4', 'fortran_order': False, 'shape': (1,), 'more': 1}",
            "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2",
        ] {
            assert_eq!(parse(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn bytes_that_are_no_header_are_refused() {
        let fault = |bytes: &[u8]| read(&mut &bytes[..]).unwrap_err();
        assert!(fault(b"\x93NUM").starts_with("ends within its header"));
        assert_eq!(fault(b"PK345678"), "is no `.npy` array");
        assert_eq!(fault(b"\x93NUMPY\x04\x00"), "is of version 4.0 of `.npy`");
        assert_eq!(fault(b"\x93NUMPY\x02\x00\xff\xff\xff\xff"), "has a header of 4294967295 bytes");
        assert_eq!(fault(b"\x93NUMPY\x01\x00\x02\x00\xff\xfe"), "has a header that is no text");
        assert!(fault(b"\x93NUMPY\x01\x00\x09\x00{}").starts_with("ends within its header"));
        assert_eq!(fault(b"\x93NUMPY\x03\x00\x02\x00\x00\x00{}"), "has a header that is not understood: {}");
    }
}
