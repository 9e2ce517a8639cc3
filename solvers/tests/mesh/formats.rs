//! Meshes in PLY and STL, and those that are none.

use allotrope_solvers::mesh::{ClosedMesh, read, read_obj};

use super::{BUNNY, cube};

/// The corners of a cube away from the origin, and its quadrilaterals, counted from zero.
fn corners() -> Vec<[f64; 3]> {
    (0..8).map(|n| [0, 1, 2].map(|axis| f64::from(n >> axis & 1) + 10.0)).collect()
}

const FACES: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

fn triangles() -> impl Iterator<Item = [[f64; 3]; 3]> {
    let corners = corners();
    FACES.into_iter().flat_map(move |[a, b, c, d]| [[a, b, c], [a, c, d]].map(|t| t.map(|n| corners[n as usize])))
}

/// The cube as an STL text.
fn stl_text() -> String {
    let mut text = "solid cube of 12 facets\n".to_string();
    for triangle in triangles() {
        text += "facet normal 0 0 0\n  outer loop\n";
        for [x, y, z] in triangle {
            text += &format!("    vertex {x:e} {y} {z:.3}\n");
        }
        text += "  endloop\nendfacet\n";
    }
    text + "endsolid cube of 12 facets\n"
}

/// The cube as a binary STL file of that comment.
fn stl_binary(comment: &str) -> Vec<u8> {
    let mut bytes = comment.as_bytes().to_vec();
    bytes.resize(80, 0);
    bytes.extend(12u32.to_le_bytes());
    for triangle in triangles() {
        bytes.extend([0; 12]);
        bytes.extend(triangle.as_flattened().iter().flat_map(|&x| (x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// The cube as a PLY text: vertices have more than their places, and there are other elements.
fn ply_text() -> String {
    let mut text = "ply\nformat ascii 1.0\ncomment a cube\nelement label 2\nproperty uchar n\nelement vertex 8\n\
                    property double x\nproperty uchar red\nproperty float y\nproperty list uchar int near\n\
                    property int z\nelement face 6\nproperty list uchar uint vertex_index\nproperty float area\n\
                    element edge 1\nproperty list uchar float ends\nend_header\n7\n8\n"
        .to_string();
    for [x, y, z] in corners() {
        text += &format!("{x} 255 {y} 2 1 2 {z}\n");
    }
    for [a, b, c, d] in FACES {
        text += &format!("4 {a} {b} {c} {d} 1.0\n");
    }
    text + "2 0 1\n"
}

/// The cube as a binary PLY file: `little` tells the order of bytes.
fn ply_binary(little: bool) -> Vec<u8> {
    let form = if little { "binary_little_endian" } else { "binary_big_endian" };
    let mut bytes = format!(
        "ply\nformat {form} 1.0\nelement vertex 8\nproperty float x\nproperty short y\nproperty double z\n\
         property uchar quality\nelement face 6\nproperty list ushort int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let mut put = |mut number: Vec<u8>| {
        // Numbers come in the order of little ends.
        if !little {
            number.reverse();
        }
        bytes.extend(number);
    };
    for [x, y, z] in corners() {
        put((x as f32).to_le_bytes().into());
        put((y as i16).to_le_bytes().into());
        put(z.to_le_bytes().into());
        put(vec![255]);
    }
    for face in FACES {
        put(4u16.to_le_bytes().into());
        face.into_iter().for_each(|n| put(n.to_le_bytes().into()));
    }
    bytes
}

fn closed(name: &str, bytes: &[u8]) -> ClosedMesh {
    read(name, bytes).and_then(|mesh| mesh.closed()).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

fn fault(name: &str, bytes: impl AsRef<[u8]>) -> String {
    let message = read(name, bytes.as_ref()).and_then(|mesh| mesh.closed()).unwrap_err().to_string();
    assert_eq!(message.lines().count(), 1, "{message}");
    message
}

#[test]
fn every_form_of_a_cube_is_the_same_cube() {
    let cube = cube(&[0, 1, 2, 3, 4, 5]).into_bytes();
    let several = stl_text().replacen("endfacet\n", "endfacet\nendsolid\nSOLID\n", 1);
    let forms = [
        ("cube.obj", cube.clone()),
        ("CUBE.STL", stl_text().into_bytes()),
        ("nameless.stl", stl_text().replace(" cube of 12 facets", "").into_bytes()),
        ("capital.stl", stl_text().to_uppercase().into_bytes()),
        ("several.stl", several.into_bytes()),
        ("lines.stl", stl_text().replace('\n', "\r\n").into_bytes()),
        ("binary.stl", stl_binary("a cube")),
        ("solid.stl", stl_binary("solid cube, all the same binary")),
        ("cube.ply", ply_text().into_bytes()),
        ("little.ply", ply_binary(true)),
        ("big.Ply", ply_binary(false)),
        // By their content.
        ("cube", cube),
        ("cube.mesh", stl_text().into_bytes()),
        ("cube.bin", stl_binary("a cube")),
        ("cube.dat", ply_binary(true)),
    ];
    for (name, bytes) in forms {
        let mesh = closed(name, &bytes);
        assert!((mesh.volume() - 1.0).abs() < 1e-12, "{name}: {}", mesh.volume());
        assert_eq!(mesh.bounds(), ([10.0; 3], [11.0; 3]), "{name}");
        assert_eq!(mesh.fill(0.25).len(), 64, "{name}");
    }
}

#[test]
fn the_bunny_is_read_by_its_name_as_by_its_form() {
    assert_eq!(read("bunny.obj", BUNNY), read_obj(BUNNY));
}

#[test]
fn files_that_are_cut_short_tell_what_is_there() {
    let binary = stl_binary("a cube");
    assert_eq!(
        fault("a.stl", &binary[..400]),
        "is cut short: its header promises 12 triangles, 684 bytes, and it has 400, 6 triangles"
    );
    assert_eq!(
        fault("a.stl", [&binary[..], &[0; 50]].concat()),
        "goes on: its header promises 12 triangles, 684 bytes only, and it has 734, 13 triangles"
    );
    assert_eq!(
        fault("a.stl", &binary[..83]),
        "is cut short: a binary STL file begins with 84 bytes, and it has 83 in all"
    );
    // A number of triangles that no memory holds.
    let mut many = binary;
    many[80..84].fill(255);
    assert_eq!(
        fault("a.stl", &many),
        "is cut short: its header promises 4294967295 triangles, 214748364834 bytes, and it has 684, 12 triangles"
    );
    let text = stl_text();
    let lines = |count: usize| text.lines().take(count).collect::<Vec<_>>().join("\n");
    assert_eq!(fault("a.stl", lines(18)), "is cut short: it ends on line 18 after 2 facets, without `endsolid`");

    let text = ply_text();
    let cut = fault("a.ply", text.lines().take(22).collect::<Vec<_>>().join("\n"));
    assert!(cut.starts_with("is not a readable PLY file: ") && cut.contains("'vertex' (expected 8, got 3)"), "{cut}");
    let binary = ply_binary(true);
    let cut = fault("a.ply", &binary[..binary.len() - 20]);
    assert!(cut.contains("'face' (expected 6, got 4)"), "{cut}");
    let end = binary.windows(11).position(|bytes| bytes == b"end_header\n").unwrap();
    let header = String::from_utf8_lossy(&binary[..end]);
    let cut = fault("a.ply", header.replace("vertex 8", "vertex 4000000000") + "end_header\n");
    assert!(cut.contains("'vertex' (expected 4000000000, got 0)"), "{cut}");
    let header = fault("a.ply", "ply\nformat ascii 1.0\nelement vertex 8\n");
    assert!(header.starts_with("is not a readable PLY file: "), "{header}");
}

#[test]
fn faulty_texts_tell_the_line_or_the_face() {
    let stl = stl_text();
    let edit = |from: &str, to: &str| fault("a.stl", stl.replacen(from, to, 1));
    assert_eq!(
        edit("vertex 1e1 10", "vertex 1e1 ten"),
        "has on line 4 `vertex 1e1 ten 10.000`, where 3 numbers are wanted"
    );
    assert_eq!(edit("10.000", "10.000 1"), "has on line 4 `vertex 1e1 10 10.000 1`, where 3 numbers are wanted");
    assert_eq!(edit("    vertex 1e1 10 10.000\n", ""), "has on line 6 `endloop`, after 2 vertices, where 3 are wanted");
    assert_eq!(edit("facet normal", "triangle"), "has on line 2 `triangle 0 0 0`, which is not STL");
    assert_eq!(edit("vertex 1e1", "vertex inf"), "has a vertex that is not finite, [inf, 10.0, 10.0]");
    assert_eq!(
        fault("a.stl", [b"solid ".as_slice(), &[200; 90]].concat()),
        "is neither a text in STL nor of the size of a binary STL file"
    );

    let ply = ply_text();
    let edit = |from: &str, to: &str| fault("a.ply", ply.replacen(from, to, 1));
    assert_eq!(edit("4 4 5 7 6", "4 4 5 7 8"), "has a face, 1, of vertex 8, and vertices 0 to 7 only");
    let negative = ply.replace("uint vertex_index", "int vertex_index").replace("4 4 5 7 6", "4 4 5 -7 6");
    assert_eq!(fault("a.ply", negative), "has a face, 1, of vertex -7, and vertices 0 to 7 only");
    assert_eq!(edit("double x", "double u"), "is a PLY file whose vertices have no number `x`");
    assert_eq!(edit("property int z", "property list uchar int z"), "is a PLY file whose vertices have no number `z`");
    assert_eq!(edit("vertex_index", "corners"), "is a PLY file whose faces have no list `vertex_indices`");
    assert_eq!(edit("element face", "element facets"), "is a PLY file without elements named `face`");
    assert_eq!(edit("element vertex", "element point"), "is a PLY file without elements named `vertex`");
    assert_eq!(
        edit("label 2\nproperty uchar n", "label 4000000000"),
        "is a PLY file with 4000000000 elements `label` of nothing"
    );
    let mut infinite = ply_binary(false);
    let first = infinite.windows(11).position(|bytes| bytes == b"end_header\n").unwrap() + 11;
    infinite[first..first + 4].copy_from_slice(&f32::INFINITY.to_be_bytes());
    assert_eq!(fault("a.ply", infinite), "has a vertex that is not finite, [inf, 10.0, 10.0]");
    assert!(edit("10 255", "nan 255").starts_with("is not a readable PLY file: Line 20: "));
    assert!(edit("10 255", "ten 255").starts_with("is not a readable PLY file: "));
    assert!(edit("uint vertex_index", "float vertex_index").starts_with("is not a readable PLY file: "));
}

#[test]
fn empty_open_and_unknown_files_are_refused() {
    let mut none = vec![0; 84];
    assert_eq!(fault("a.stl", &none), "has no faces");
    assert_eq!(fault("a.stl", "solid\nendsolid\n"), "has no faces");
    assert_eq!(fault("a.ply", ply_text().replace("element face 6", "element face 0")), "has no faces");
    assert_eq!(fault("a.obj", ""), "has no faces");
    none[80] = 1;
    none.extend([0; 50]);
    // A triangle that is a point.
    assert_eq!(fault("a.stl", &none), "has no faces");
    let open = stl_binary("a cube");
    let mut open = open[..684 - 50].to_vec();
    open[80] = 11;
    assert!(fault("a.stl", &open).starts_with("is not closed: 3 edges open"));
    let unknown = "is no mesh in a form that is known; they are OBJ, PLY and STL";
    assert_eq!(fault("picture.png", b"\x89PNG\r\n"), unknown);
    assert_eq!(fault("", ""), unknown);
}

#[test]
fn files_with_a_changed_byte_are_read_or_refused_in_one_line() {
    let forms = [
        ("a.stl", stl_text().into_bytes()),
        ("a.stl", stl_binary("a cube")),
        ("a.ply", ply_text().into_bytes()),
        ("a.ply", ply_binary(true)),
        ("a.obj", cube(&[0, 1, 2, 3, 4, 5]).into_bytes()),
    ];
    let (mut whole, mut refused) = (0, 0);
    for (name, bytes) in forms {
        for place in 0..bytes.len() {
            for by in [0, b'-', b'9', b'\n', 127, 255] {
                let mut changed = bytes.clone();
                changed[place] = by;
                match read(name, &changed).and_then(|mesh| mesh.closed()) {
                    Ok(mesh) => whole += usize::from(mesh.volume().is_finite()),
                    Err(fault) => {
                        refused += 1;
                        assert_eq!(fault.to_string().lines().count(), 1, "{fault}");
                    }
                }
            }
        }
    }
    assert!(whole > 1000 && refused > 1000, "{whole} {refused}");
}
