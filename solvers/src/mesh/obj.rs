//! Reads meshes from OBJ files.

use super::weld::Welder;
use super::{Mesh, MeshError};

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
    let mut welder = Welder::default();
    for tobj::Model { mesh: part, .. } in models {
        let (positions, _) = part.positions.as_chunks::<3>();
        let renumbered = positions.iter().map(|&position| welder.vertex(position)).collect::<Result<Vec<_>, _>>()?;
        let (triangles, _) = part.indices.as_chunks::<3>();
        for triangle in triangles {
            welder.triangle(triangle.map(|vertex| renumbered[vertex as usize]));
        }
    }
    welder.finish()
}
