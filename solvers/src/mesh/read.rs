//! Reads meshes from OBJ files.

use std::collections::HashMap;

use super::{Mesh, MeshError};

/// Reads the triangles of a file, told its kind by its name.
///
/// # Errors
/// As those of [`read_obj`].
pub fn read(_name: &str, bytes: &[u8]) -> Result<Mesh, MeshError> {
    read_obj(bytes)
}

/// Reads the triangles of an OBJ file; polygons are cut into fans. All objects of the file make one mesh, in which
/// vertices at equal positions are one vertex, since many programs write a vertex once for each face or object that it
/// belongs to.
///
/// # Errors
/// If the text is not an OBJ file, a position is not finite, or there is no face.
pub fn read_obj(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    let (models, _) = tobj::load_obj_buf(&mut &bytes[..], &options, |_| Ok(Default::default()))
        .map_err(|error| MeshError(format!("is not a readable OBJ file: {error}")))?;
    let mut mesh = Mesh { vertices: Vec::new(), triangles: Vec::new() };
    let mut known = HashMap::new();
    for tobj::Model { mesh: part, .. } in models {
        let (positions, _) = part.positions.as_chunks::<3>();
        let mut renumbered = Vec::with_capacity(positions.len());
        for position in positions {
            if position.iter().any(|x| !x.is_finite()) {
                return Err(MeshError(format!("has a vertex that is not finite, {position:?}")));
            }
            // `+ 0.0` makes the two zeros one.
            let vertex = *known.entry(position.map(|x| (x + 0.0).to_bits())).or_insert(mesh.vertices.len() as u32);
            if vertex as usize == mesh.vertices.len() {
                mesh.vertices.push(*position);
            }
            renumbered.push(vertex);
        }
        let (triangles, _) = part.indices.as_chunks::<3>();
        let corners = triangles.iter().map(|triangle| triangle.map(|vertex| renumbered[vertex as usize]));
        // A triangle that names a vertex twice has no area, and its neighbours meet where it is left out.
        mesh.triangles.extend(corners.filter(|[a, b, c]| a != b && b != c && c != a));
    }
    if mesh.triangles.is_empty() { Err(MeshError("has no faces".into())) } else { Ok(mesh) }
}
