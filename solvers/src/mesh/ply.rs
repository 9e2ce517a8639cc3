//! Reads meshes from PLY files.

use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType};

use super::weld::Welder;
use super::{Mesh, MeshError};

/// The names that programs give to the list of a face's vertices.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

const AXES: [&str; 3] = ["x", "y", "z"];

/// Reads the triangles of a PLY file, a text or binary; polygons are cut into fans. What else it tells of vertices and
/// faces is skipped.
///
/// # Errors
/// If it is not one, or cut short, has no `vertex` with `x`, `y` and `z` or no `face` with a list of vertices, a face
/// names a vertex that is not there, a position is not finite, or there is no face.
pub(super) fn read(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let mut reader = Reader::new(bytes);
    let header = Parser::<Skipped>::new().read_header(&mut reader).map_err(|error| unreadable(&error))?;
    check(&header)?;
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for element in header.elements.values() {
        match element.name.as_str() {
            "vertex" => vertices = payload::<Vertex>(&mut reader, element, &header)?,
            "face" => faces = payload::<Face>(&mut reader, element, &header)?,
            _ => _ = payload::<Skipped>(&mut reader, element, &header)?,
        }
    }

    let mut welder = Welder::default();
    let vertices = vertices.into_iter().map(|Vertex(x)| welder.vertex(x)).collect::<Result<Vec<_>, _>>()?;
    for (n, Face(corners)) in faces.iter().enumerate() {
        let mut welded = Vec::with_capacity(corners.len());
        for &corner in corners {
            let vertex = usize::try_from(corner).ok().and_then(|corner| vertices.get(corner)).copied();
            let fault = || {
                MeshError(format!(
                    "has a face, {n}, of vertex {corner}, and vertices 0 to {} only",
                    vertices.len() as i64 - 1
                ))
            };
            welded.push(vertex.ok_or_else(fault)?);
        }
        let [first, rest @ ..] = &welded[..] else { continue };
        for pair in rest.windows(2) {
            welder.triangle([*first, pair[0], pair[1]]);
        }
    }
    welder.finish()
}

/// Checks that a header tells what a mesh needs.
fn check(header: &Header) -> Result<(), MeshError> {
    let element = |name: &str| {
        header.elements.get(name).ok_or_else(|| MeshError(format!("is a PLY file without elements named `{name}`")))
    };
    let vertex = element("vertex")?;
    for axis in AXES {
        match vertex.properties.get(axis).map(|property| &property.data_type) {
            Some(PropertyType::Scalar(_)) => {}
            _ => return Err(MeshError(format!("is a PLY file whose vertices have no number `{axis}`"))),
        }
    }
    let face = element("face")?;
    let list = |name| face.properties.get(name).is_some_and(|list| matches!(list.data_type, PropertyType::List(..)));
    if !CORNERS.iter().any(|&name| list(name)) {
        return Err(MeshError("is a PLY file whose faces have no list `vertex_indices`".into()));
    }
    // Elements that take no bytes could be promised without end.
    match header.elements.values().find(|element| element.properties.is_empty() && element.count > 0) {
        Some(element) => {
            Err(MeshError(format!("is a PLY file with {} elements `{}` of nothing", element.count, element.name)))
        }
        None => Ok(()),
    }
}

fn payload<E: PropertyAccess>(
    reader: &mut Reader<&[u8]>,
    element: &ElementDef,
    header: &Header,
) -> Result<Vec<E>, MeshError> {
    Parser::<E>::new().read_payload_for_element(reader, element, header).map_err(|error| unreadable(&error))
}

/// The parser's message on one line of bearable length; where a file is cut short it tells how many elements there are.
fn unreadable(error: &ply_rs_bw::parser::ParseError) -> MeshError {
    let text = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let short: String = text.chars().take(200).collect();
    MeshError(format!("is not a readable PLY file: {short}{}", if short.len() < text.len() { ".." } else { "" }))
}

struct Vertex([f64; 3]);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self([0.0; 3])
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let Some(axis) = AXES.iter().position(|axis| *axis == name) else { return PropertyAccessResult::Ignored };
        self.0[axis] = match value {
            Property::Char(x) => x.into(),
            Property::UChar(x) => x.into(),
            Property::Short(x) => x.into(),
            Property::UShort(x) => x.into(),
            Property::Int(x) => x.into(),
            Property::UInt(x) => x.into(),
            Property::Float(x) => x.into(),
            Property::Double(x) => x,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// The vertices of a polygon.
struct Face(Vec<i64>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Self(Vec::new())
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        fn whole<T: Into<i64>>(values: Vec<T>) -> Vec<i64> {
            values.into_iter().map(Into::into).collect()
        }
        if !CORNERS.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match value {
            Property::ListChar(corners) => whole(corners),
            Property::ListUChar(corners) => whole(corners),
            Property::ListShort(corners) => whole(corners),
            Property::ListUShort(corners) => whole(corners),
            Property::ListInt(corners) => whole(corners),
            Property::ListUInt(corners) => whole(corners),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// An element of which nothing is wanted.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}
