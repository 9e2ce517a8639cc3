//! Reads meshes from files of several forms.

use super::{Mesh, MeshError, ply, read_obj, stl};

/// Reads the triangles of an OBJ, PLY or STL file; polygons are cut into fans, and vertices at equal positions are one.
/// The form is that of the name's extension; if it tells none, that which the content looks like.
///
/// # Errors
/// If the form is none of these, the content not of that form, a position not finite, or there is no face.
///
/// ```
/// let text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid";
/// let triangle = allotrope_solvers::mesh::read("triangle.stl", text.as_bytes()).unwrap();
/// assert!(triangle.closed().is_err());
/// ```
pub fn read(name: &str, bytes: &[u8]) -> Result<Mesh, MeshError> {
    let name = name.to_lowercase();
    let is = |extension| name.ends_with(extension);
    if is(".obj") {
        read_obj(bytes)
    } else if is(".ply") {
        ply::read(bytes)
    } else if is(".stl") {
        stl::read(bytes)
    } else if bytes.starts_with(b"ply") {
        ply::read(bytes)
    } else if stl::looks_like(bytes) {
        stl::read(bytes)
    } else if looks_like_obj(bytes) {
        read_obj(bytes)
    } else {
        Err(MeshError("is no mesh in a form that is known; they are OBJ, PLY and STL".into()))
    }
}

/// Whether there is a line of a vertex among the first.
fn looks_like_obj(bytes: &[u8]) -> bool {
    bytes.split(|&byte| byte == b'\n').take(100).any(|line| line.starts_with(b"v "))
}
