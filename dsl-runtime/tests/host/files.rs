//! Fields saved and loaded: read back to the same bits, and files that are not a field's refused without harm.

use std::fmt::Debug;
use std::fs;
use std::io::{Cursor, Read, Write};
use std::path::{Path, PathBuf};

use allotrope::prelude::*;
use allotrope::{FileFault, Record as RecordTrait};
use tempfile::TempDir;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::{Numbers, Point};

/// A file that goes with the folder it lies in.
fn place() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("field.npz");
    (folder, path)
}

/// An archive of these parts.
fn archive(parts: &[(&str, &[u8])], method: CompressionMethod) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in parts {
        archive.start_file(*name, SimpleFileOptions::default().compression_method(method)).expect("a part");
        archive.write_all(bytes).expect("memory");
    }
    archive.finish().expect("memory").into_inner()
}

/// The parts of an archive.
fn parts(path: &Path) -> Vec<(String, Vec<u8>)> {
    let mut archive = ZipArchive::new(fs::File::open(path).expect("a file")).expect("an archive");
    let numbers = 0..archive.len();
    let part = |n| {
        let mut part = archive.by_index(n).expect("a part");
        let mut bytes = Vec::new();
        part.read_to_end(&mut bytes).expect("its bytes");
        (part.name().expect("a name").into_owned(), bytes)
    };
    numbers.map(part).collect()
}

/// An array as another writer might write it.
fn npy(header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

/// What loading a field of ten `u8` from a file says, without the file's name; the field must stay as it was.
fn refused(bytes: &[u8]) -> String {
    let (_folder, path) = place();
    fs::write(&path, bytes).expect("a file");
    let mut u = Field::<u8, Soa>::new([10]).with_background(7);
    let error = u.load(&path).unwrap_err();
    assert_eq!(u.to_vec(), [7; 10]);
    assert_eq!(error.path(), path);
    let text = error.to_string();
    text.strip_prefix(&format!("`{}` ", path.display())).expect("the file's name").to_owned()
}

/// What loading ten `u8` from an archive of one array says.
fn refused_array(header: &str, data: &[u8]) -> String {
    refused(&archive(&[("value.npy", &npy(header, data))], CompressionMethod::Stored))
}

const TEN_BYTES: &str = "{'descr': '|u1', 'fortran_order': False, 'shape': (10,), }";

#[derive(RecordTrait, Clone, Copy, Debug, PartialEq)]
struct Everything {
    float: f32,
    double: f64,
    tiny: i8,
    small: i16,
    middle: i32,
    large: i64,
    byte: u8,
    word: u16,
    count: u32,
    key: u64,
    flag: bool,
    place: Vec3,
    aligned: Vec3A,
    turn: DQuat,
    stress: Mat3,
    cell: IVec2,
    r#type: UVec4,
    flags: [bool; 3],
    corners: [[DVec2; 2]; 2],
}

impl Everything {
    fn any(numbers: &mut Numbers) -> Self {
        let mut bits = || numbers.next() << 33 ^ numbers.next() << 11 ^ numbers.next();
        // Floats of all kinds, but no NaN, which equals nothing.
        let float = |bits: u64| Some(f32::from_bits(bits as u32)).filter(|x| !x.is_nan()).unwrap_or(-0.0);
        let double = |bits: u64| Some(f64::from_bits(bits)).filter(|x| !x.is_nan()).unwrap_or(f64::INFINITY);
        Self {
            float: float(bits()),
            double: double(bits()),
            tiny: bits() as i8,
            small: bits() as i16,
            middle: bits() as i32,
            large: bits() as i64,
            byte: bits() as u8,
            word: bits() as u16,
            count: bits() as u32,
            key: bits(),
            flag: bits() & 1 == 1,
            place: Vec3::from_array([0; 3].map(|_| float(bits()))),
            aligned: Vec3A::from_array([0; 3].map(|_| float(bits()))),
            turn: DQuat::from_array([0; 4].map(|_| double(bits()))),
            stress: Mat3::from_cols_array(&[0; 9].map(|_| float(bits()))),
            cell: IVec2::from_array([0; 2].map(|_| bits() as i32)),
            r#type: UVec4::from_array([0; 4].map(|_| bits() as u32)),
            flags: [0; 3].map(|_| bits() & 1 == 1),
            corners: [[0; 2]; 2].map(|two| two.map(|_| dvec2(double(bits()), double(bits())))),
        }
    }
}

/// Saves a field in one layout and loads it in another.
fn round_trip<R, L: Layout<X>, M: Layout<X>, X: Axes>(
    records: &[R],
    mut field: Field<R, L, X>,
    mut other: Field<R, M, X>,
) where
    R: RecordTrait + PartialEq + Debug,
{
    let (folder, path) = place();
    for (n, &record) in records.iter().enumerate() {
        let mut rest = n;
        let shape = field.shape();
        let mut at = [0i64; 4];
        for axis in (0..X::RANK).rev() {
            at[axis] = (rest % shape.as_ref()[axis]) as i64;
            rest /= shape.as_ref()[axis];
        }
        field.set(X::index(at.map(|n| n as i32)), record);
    }
    field.save(&path).expect("saved");
    other.load(&path).expect("loaded");
    assert!(field.iter().eq(records.iter().copied()));
    assert!(other.iter().eq(records.iter().copied()));
    // Nothing else is left in the folder, and what is saved again is the same but for the layout's name.
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 1);
    let first = parts(&path);
    other.save(&path).expect("saved over the former one");
    assert_eq!(parts(&path)[1..], first[1..]);
}

#[test]
fn all_elements_are_read_back_to_the_same_bits() {
    let mut numbers = Numbers(11);
    let mut any = |len: usize| (0..len).map(|_| Everything::any(&mut numbers)).collect::<Vec<_>>();
    type Mixed = layout!(Everything: dense(ij).dense(ji, (3, 4)).place([split(stress), flag], [float, double, tiny, small],
        [middle, large, byte, word, count, key, place, split(aligned), turn, cell, r#type, split(flags), corners]));
    round_trip(&any(37), Field::<_, Aos>::new([37]), Field::<_, AoSoA<8>>::new([37]));
    round_trip(&any(5 * 7), Field::<_, Mixed>::new([5, 7]), Field::<_, Soa>::new([5, 7]));
    round_trip(&any(3 * 4 * 5), Field::<_, Morton<4>>::new([3, 4, 5]), Field::<_, Split>::new([3, 4, 5]));
    round_trip(&any(16), Field::<_, Blocked<3>>::new([2, 2, 2, 2]), Field::<_, Aos>::new([2, 2, 2, 2]));
    round_trip(&any(1), Field::<_, Aos>::new([]), Field::<_, Split>::new([]));
    round_trip(&any(0), Field::<_, Aos>::new([3, 0]), Field::<_, Soa>::new([3, 0]));
}

#[test]
fn numbers_that_are_not_numbers_keep_their_bits() {
    let (_folder, path) = place();
    let bits = [0x7fc0_0000, 0xffc0_1234, 0x7f80_0001, 0x8000_0000, 1];
    let mut u = Field::<f32, Aos>::new([5]);
    u.copy_from_slice(&bits.map(f32::from_bits));
    u.save(&path).expect("saved");
    let mut again = Field::<f32, Soa>::new([5]);
    again.load(&path).expect("loaded");
    assert_eq!(again.to_vec().iter().map(|x| x.to_bits()).collect::<Vec<_>>(), bits);
}

#[test]
fn more_than_one_piece_is_read_back() {
    let (_folder, path) = place();
    let mut u = Field::<[u16; 3], AoSoA<16>>::new([300, 211]);
    for n in 0..300 * 211u32 {
        u.set((n / 211, n % 211), [n as u16, (n >> 8) as u16, 7]);
    }
    u.save(&path).expect("saved");
    let mut again = Field::<[u16; 3], layout!(dense(ji).split)>::new([300, 211]);
    again.load(&path).expect("loaded");
    assert!(again.iter().eq(u.iter()));
    // One element may be more than a piece.
    let mut wide = Field::<[f64; 10_000], Soa>::new([2]);
    wide.set(1, [0.5; 10_000]);
    wide.save(&path).expect("saved");
    let mut again = Field::<[f64; 10_000], Split>::new([2]);
    again.load(&path).expect("loaded");
    assert!(again.get(1) == [0.5; 10_000] && again.get(0) == [0.0; 10_000]);
}

#[test]
fn the_file_holds_what_its_description_says() {
    let (_folder, path) = place();
    let mut points = Field::<Point, Soa>::new([2, 3]);
    points.set([0, 1], Point::numbered(5));
    points.save(&path).expect("saved");
    let parts = parts(&path);
    let names: Vec<&str> = parts.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["allotrope.json", "x.npy", "mass.npy", "id.npy"]);
    let about = String::from_utf8(parts[0].1.clone()).expect("a text");
    let layout = std::any::type_name::<Soa>();
    let expected = format!(
        r#"{{
  "format": "allotrope field",
  "version": 1,
  "origin": [0, 0],
  "shape": [2, 3],
  "layout": "{layout}",
  "members": [
    {{ "name": "x", "scalar": "<f4", "components": 2 }},
    {{ "name": "mass", "scalar": "<f4", "components": 1 }},
    {{ "name": "id", "scalar": "<u4", "components": 1 }}
  ]
}}
"#
    );
    assert_eq!(about, expected);
    let x = &parts[1].1;
    assert!(
        x.starts_with(b"\x93NUMPY\x01\x00\x76\x00{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 2), }  ")
    );
    assert_eq!(x.len(), 128 + 2 * 3 * 2 * 4);
    assert_eq!(x[128 + 8..128 + 16], [0, 0, 0xa0, 0x40, 0, 0, 0xa0, 0xc0], "5.0 and -5.0");
}

#[test]
fn arrays_of_other_writers_are_loaded() {
    let (_folder, path) = place();
    // Compressed, in another order, without a description; version 2.0 of `.npy`, one axis "in Fortran's order".
    let mut mass = b"\x93NUMPY\x02\x00".to_vec();
    let header = "{'shape': (2,), 'fortran_order': True, 'descr': '<f4'}\n";
    mass.extend((header.len() as u32).to_le_bytes());
    mass.extend(header.as_bytes());
    mass.extend([1.5f32, 2.5].map(f32::to_le_bytes).as_flattened());
    let id = npy("{'descr': '<u4', 'fortran_order': False, 'shape': (2,), }", &[1, 0, 0, 0, 2, 1, 0, 0]);
    let x = npy(
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }",
        [0.0f32, 1.0, 2.0, 3.0].map(f32::to_le_bytes).as_flattened(),
    );
    let bytes = archive(&[("id.npy", &id), ("mass.npy", &mass), ("x.npy", &x)], CompressionMethod::Deflated);
    fs::write(&path, bytes).expect("a file");
    let mut points = Field::<Point, AoSoA<4>>::new([2]);
    points.load(&path).expect("loaded");
    assert_eq!(points.get(0), Point { x: vec2(0.0, 1.0), mass: 1.5, id: 1 });
    assert_eq!(points.get(1), Point { x: vec2(2.0, 3.0), mass: 2.5, id: 258 });
}

#[test]
fn a_file_that_is_cut_off_is_refused() {
    let (_folder, path) = place();
    let mut points = Field::<Point, Aos>::new([200]);
    for n in 0..200 {
        points.set(n, Point::numbered(n));
    }
    points.save(&path).expect("saved");
    let whole = fs::read(&path).expect("the file");
    let mut other = Field::<Point, Soa>::new([200]).with_background(Point::numbered(3));
    for end in (0..20).map(|twentieth| whole.len() * twentieth / 20).chain([whole.len() - 1]) {
        fs::write(&path, &whole[..end]).expect("a file");
        let error = other.load(&path).unwrap_err();
        assert!(matches!(error.fault(), FileFault::Archive { .. }), "{end}: {error}");
        assert!(error.to_string().contains("field.npz` is cut off, damaged or no `.npz` file at all: "), "{error}");
        assert!(other.iter().all(|point| point == Point::numbered(3)));
    }
}

#[test]
fn damage_anywhere_is_an_error_or_does_no_harm() {
    let (_folder, path) = place();
    let mut points = Field::<Point, Aos>::new([3]);
    for n in 0..3 {
        points.set(n, Point::numbered(n));
    }
    points.save(&path).expect("saved");
    let whole = fs::read(&path).expect("the file");
    let mut refused = 0;
    for byte in 0..whole.len() {
        for change in [0x01, 0x41, 0x80, 0xff] {
            let mut damaged = whole.clone();
            damaged[byte] ^= change;
            fs::write(&path, &damaged).expect("a file");
            let mut other = Field::<Point, Soa>::new([3]).with_background(Point::numbered(9));
            match other.load(&path) {
                // Dates and the like may change, values never.
                Ok(()) => assert!(other.iter().eq(points.iter()), "byte {byte}"),
                Err(_) => {
                    refused += 1;
                    assert!(other.iter().all(|point| point == Point::numbered(9)), "byte {byte}");
                }
            }
        }
    }
    assert!(refused > 2 * whole.len(), "{refused} of {}", 4 * whole.len());
}

#[test]
fn a_damaged_value_is_refused_by_the_name_of_its_array() {
    let (_folder, path) = place();
    let points = Field::<Point, Aos>::new([1000]).with_background(Point::numbered(77));
    points.save(&path).expect("saved");
    let mut bytes = fs::read(&path).expect("the file");
    let mass = 77.5f32.to_le_bytes();
    let place = bytes.windows(8).position(|window| window == [mass, mass].as_flattened()).expect("masses");
    bytes[place + 400] ^= 1;
    fs::write(&path, &bytes).expect("a file");
    let error = points.clone().load(&path).unwrap_err();
    assert!(matches!(error.fault(), FileFault::Entry { entry, .. } if entry == "mass.npy"), "{error}");
    assert!(error.to_string().contains("`mass.npy` is cut off or damaged: Invalid checksum"), "{error}");
}

#[test]
fn files_of_others_are_refused() {
    assert!(refused(b"").starts_with("is cut off, damaged or no `.npz` file at all: "));
    assert!(refused(&[0xa7; 5000]).starts_with("is cut off, damaged or no `.npz` file at all: "));
    let stored = |parts: &[(&str, &[u8])]| refused(&archive(parts, CompressionMethod::Stored));
    assert_eq!(stored(&[("letter.txt", b"Dear")]), "has `letter.txt`, for which the record has no member");
    assert_eq!(stored(&[]), "has no `value.npy`, which the record asks for");
    assert_eq!(stored(&[("value.npy", b"PK345678")]), "cannot be used: `value.npy` is no `.npy` array");
    let array = npy(TEN_BYTES, &[1; 10]);
    assert_eq!(
        stored(&[("value.npy", &array), ("more.npy", &array)]),
        "has `more.npy`, for which the record has no member"
    );
    let about = |text: &str| stored(&[("allotrope.json", text.as_bytes()), ("value.npy", &array)]);
    assert_eq!(
        about("{\n  \"format\": \"allotrope field\",\n  \"version\": 2,\n}"),
        "is of a format that this version does not know: `allotrope.json` begins with \
        \"{\\n  \\\"format\\\": \\\"allotrope field\\\",\\n  \\\"version\\\": 2,\\n\""
    );
    assert_eq!(about(""), "is of a format that this version does not know: `allotrope.json` begins with \"\"");
    assert_eq!(about(&" ".repeat((1 << 20) + 1)), "cannot be used: `allotrope.json` has more than 1048576 bytes");
}

#[test]
fn arrays_of_another_kind_or_shape_are_refused() {
    let header =
        |descr: &str, shape: &str| format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}");
    assert_eq!(
        refused_array(&header("|i1", "(10,)"), &[0; 10]),
        "has another record: `value.npy` holds `|i1`, its member `|u1`"
    );
    for (shape, found) in [("(9,)", "[9]"), ("(10, 1)", "[10, 1]"), ("()", "[]"), ("(11,)", "[11]")] {
        assert_eq!(
            refused_array(&header("|u1", shape), &[0; 11]),
            format!("has another shape: `value.npy` is of shape {found}, where [10] is wanted")
        );
    }
    assert_eq!(refused_array(TEN_BYTES, &[0; 11]), "cannot be used: `value.npy` goes on after its last value");
    assert!(refused_array(TEN_BYTES, &[0; 9]).starts_with("cannot be used: `value.npy` is cut off or damaged: "));
    assert!(
        refused_array("{'descr': 5}", &[0; 10]).starts_with("cannot be used: `value.npy` has a header that is not")
    );

    let (_folder, path) = place();
    let columns = npy("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2), }", &[0; 16]);
    fs::write(&path, archive(&[("value.npy", &columns)], CompressionMethod::Stored)).expect("a file");
    let error = Field::<f32, Aos>::new([2, 2]).load(&path).unwrap_err();
    assert!(error.to_string().contains("`value.npy` is in Fortran's order: save `numpy.ascontiguousarray`"), "{error}");

    Field::<Point, Aos>::new([3, 4]).save(&path).expect("saved");
    let error = Field::<Point, Aos>::new([4, 3]).load(&path).unwrap_err();
    assert!(error.to_string().ends_with("`x.npy` is of shape [3, 4, 2], where [4, 3, 2] is wanted"), "{error}");
    let error = Field::<Point, Aos>::new([12]).load(&path).unwrap_err();
    assert!(matches!(error.fault(), FileFault::Shape { .. }), "{error}");
    let error = Field::<f32, Aos>::new([3, 4]).load(&path).unwrap_err();
    assert!(error.to_string().ends_with("has `x.npy`, for which the record has no member"), "{error}");
}

#[test]
fn counts_are_not_trusted() {
    // Were memory taken on the file's word, these would end the process.
    let much = 1u64 << 60;
    let array = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': ({much},), }}");
    assert_eq!(
        refused_array(&array, &[0; 10]),
        format!("has another shape: `value.npy` is of shape [{much}], where [10] is wanted")
    );
    let mut header = b"\x93NUMPY\x03\x00\xff\xff\xff\xff".to_vec();
    header.extend([b' '; 100]);
    assert_eq!(
        refused(&archive(&[("value.npy", &header)], CompressionMethod::Stored)),
        "cannot be used: `value.npy` has a header of 4294967295 bytes"
    );
    // A few bytes that unfold to a gigabyte are read no further than the field is long.
    let array = npy(TEN_BYTES, &vec![0; 1 << 26]);
    assert_eq!(
        refused(&archive(&[("value.npy", &array)], CompressionMethod::Deflated)),
        "cannot be used: `value.npy` goes on after its last value"
    );
}

#[test]
fn bytes_that_are_no_bool_are_refused() {
    #[derive(RecordTrait, Clone, Copy, Debug, PartialEq)]
    struct Flags {
        count: u8,
        set: [bool; 2],
    }
    let (_folder, path) = place();
    let count = npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 2), }", &[200; 4]);
    let header = "{'descr': '|b1', 'fortran_order': False, 'shape': (2, 2, 2), }";
    let set = |bytes: [u8; 8]| {
        archive(&[("count.npy", &count), ("set.npy", &npy(header, &bytes))], CompressionMethod::Stored)
    };
    let mut flags = Field::<Flags, Soa>::new([2, 2]);
    fs::write(&path, set([0, 1, 1, 0, 0, 2, 1, 1])).expect("a file");
    let error = flags.load(&path).unwrap_err();
    assert!(matches!(error.fault(), FileFault::Value { index, found: 2, .. } if index == &[1, 0]), "{error}");
    assert!(error.to_string().ends_with("has a value that its type has not: `set.npy` holds 2 at [1, 0]"), "{error}");
    assert!(flags.iter().all(|flags| flags == Flags { count: 0, set: [false; 2] }));
    fs::write(&path, set([0, 1, 1, 0, 0, 1, 1, 1])).expect("a file");
    flags.load(&path).expect("loaded");
    assert_eq!(flags.get([1, 0]), Flags { count: 200, set: [false, true] });
}

#[test]
fn what_the_system_refuses_is_an_error_and_leaves_nothing() {
    let (folder, path) = place();
    let u = Field::<u8, Aos>::new([10]);
    let error = u.clone().load(&path).unwrap_err();
    assert!(matches!(error.fault(), FileFault::Read(why) if why.kind() == std::io::ErrorKind::NotFound), "{error}");
    assert!(std::error::Error::source(&error).is_some());
    let error = u.save(folder.path().join("no/such.npz")).unwrap_err();
    assert!(matches!(error.fault(), FileFault::Write(_)), "{error}");
    assert!(error.to_string().contains("such.npz` cannot be written: "), "{error}");
    // A folder of that name: all is written, and then cannot be renamed.
    fs::create_dir(&path).expect("a folder");
    assert!(matches!(u.save(&path).unwrap_err().fault(), FileFault::Write(_)));
    assert!(matches!(u.clone().load(&path).unwrap_err().fault(), FileFault::Archive { .. } | FileFault::Read(_)));
    assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 1);
}

#[test]
fn integers_that_are_no_variant_are_refused() {
    #[derive(Element, Clone, Copy, Debug, PartialEq)]
    enum Phase {
        Steam = -1,
        Water,
        Ice = 7,
    }
    #[derive(RecordTrait, Clone, Copy, Debug, PartialEq)]
    struct Parcel {
        phases: [Phase; 2],
        mass: f32,
    }
    let (_folder, path) = place();
    let mut parcels = Field::<Parcel, AoSoA<2>>::new([3]);
    parcels.set(1, Parcel { phases: [Phase::Ice, Phase::Steam], mass: 2.0 });
    parcels.save(&path).expect("saved");
    let mut loaded = Field::<Parcel, Split>::new([3]);
    loaded.load(&path).expect("loaded");
    assert!(loaded.iter().eq(parcels.iter()));

    let mass = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (3,), }", &[0; 12]);
    let phases = npy("{'descr': '|i1', 'fortran_order': False, 'shape': (3, 2), }", &[0, 255, 7, 0, 0, 254]);
    fs::write(&path, archive(&[("phases.npy", &phases), ("mass.npy", &mass)], CompressionMethod::Stored))
        .expect("a file");
    let error = loaded.load(&path).unwrap_err();
    assert!(error.to_string().ends_with("has a value that its type has not: `phases.npy` holds -2 at [2]"), "{error}");
    assert!(loaded.iter().eq(parcels.iter()), "the field stays as it was");
}

#[derive(RecordTrait, Clone, Copy, Default, Debug, PartialEq)]
struct Outer {
    side: u8,
    inner: Inner,
}

#[derive(RecordTrait, Clone, Copy, Default, Debug, PartialEq)]
struct Inner {
    v: Vec2,
    flag: bool,
}

#[test]
fn each_member_of_an_inner_record_is_an_array() {
    let (_folder, path) = place();
    let mut field = Field::<Outer, Soa>::new([3, 4]);
    (0..12u8).for_each(|n| {
        let inner = Inner { v: vec2(n.into(), -1.0), flag: n % 3 == 0 };
        field.set((n / 4, n % 4), Outer { side: n, inner });
    });
    field.save(&path).expect("it is saved");
    let names: Vec<String> = parts(&path).into_iter().map(|(name, _)| name).collect();
    for name in ["side.npy", "inner.v.npy", "inner.flag.npy"] {
        assert!(names.iter().any(|known| known == name), "{name} in {names:?}");
    }
    let mut back = Field::<Outer, Blocked<2>>::new([3, 4]);
    back.load(&path).expect("it is read");
    assert!(back.iter().eq(field.iter()));
    let mut odd = field.get([2, 1]);
    odd.inner.v.y = f32::NAN;
    back.set([2, 1], odd);
    let found = back.find_nonfinite().expect("a number that is none");
    assert_eq!((found.member, found.component, found.index), (Some("inner.v"), 1, ivec2(2, 1)));
}

#[test]
fn files_keep_where_indices_begin() {
    let (_folder, path) = place();
    let mut field = Field::<f32, Blocked<4>>::new([5, 6]).with_origin([-3, 7]);
    field.set([-3, 12], 2.0);
    field.save(&path).expect("it is saved");
    let (_, about) = parts(&path).swap_remove(0);
    let about = String::from_utf8(about).expect("text");
    assert!(about.contains("\"origin\": [-3, 7],\n  \"shape\": [5, 6],"), "{about}");
    let mut back = Field::<f32, Aos>::new([5, 6]);
    back.load(&path).expect("it is read");
    assert_eq!((back.origin(), back.get([-3, 12])), (ivec2(-3, 7), 2.0));
    assert!(back.try_get([0, 0]).is_err());
    // A description of a file without one, or of a wrong one.
    let array = npy(TEN_BYTES, &[1; 10]);
    let stored =
        |text: &str| archive(&[("allotrope.json", text.as_bytes()), ("value.npy", &array)], CompressionMethod::Stored);
    let beginning = "{\n  \"format\": \"allotrope field\",\n  \"version\": 1,\n";
    for (origin, why) in [
        ("1, 2", "has `\"origin\": [1, 2]`, which is not one integer for each of 1 axes"),
        ("x", "has `\"origin\": [x]`, which is not one integer for each of 1 axes"),
        ("", "has `\"origin\": []`, which is not one integer for each of 1 axes"),
        (
            "2147483640",
            "has an `\"origin\"` that does not fit: the 10 indices of axis `i` from 2147483640 on reach beyond those of an `i32`, \
             -2147483648 to 2147483646",
        ),
    ] {
        let text = refused(&stored(&format!("{beginning}  \"origin\": [{origin}],\n")));
        assert_eq!(text, format!("cannot be used: `allotrope.json` {why}"));
    }
    fs::write(&path, stored(beginning)).expect("a file");
    let mut u = Field::<u8, Soa>::new([10]).with_origin(-5);
    u.load(&path).expect("it is read");
    assert_eq!((u.origin(), u.get(-5), u.get(4)), (-5, 1, 1));
}
