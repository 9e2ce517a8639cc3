//! Shapes that bodies and colliders share.

use super::keys::Keys;
use super::{Folder, SceneError};
use crate::mesh::{self, ClosedMesh};

/// Keys of a box.
pub(crate) const CORNERS: &[&str] = &["from", "to"];

/// Keys of a mesh.
pub(crate) const MESH: &[&str] = &["file", "scale", "move"];

/// The name of a table's shape, among `shapes` with the keys that each takes beside `shape` and `common`; the table may
/// have no others. `what` has the shape.
pub(crate) fn shape_of<'a>(
    keys: &Keys<'a>,
    what: &str,
    shapes: &[(&'static str, &[&str])],
    common: &[&str],
) -> Result<&'static str, SceneError> {
    keys.required_text("shape", "\"box\"")?;
    let choices: Vec<_> = shapes.iter().map(|shape| (shape.0, shape)).collect();
    let &(name, own) = keys.choice("shape", "shape", &choices)?.unwrap_or(&shapes[0]);
    let takes = [own, &["shape"], common].concat();
    let others: Vec<_> = shapes.iter().flat_map(|(_, keys)| *keys).copied().collect();
    keys.only(&format!("a {what} of the shape `{name}`"), &takes, &others)?;
    Ok(name)
}

/// The lower and the upper corner of a box.
pub(crate) fn corners(keys: &Keys<'_>, dimensions: usize) -> Result<([f64; 3], [f64; 3]), SceneError> {
    let from = keys.required_vector("from", dimensions, "[0.2, 0.2]")?;
    let to = keys.required_vector("to", dimensions, "[0.6, 0.6]")?;
    if let Some(axis) = (0..dimensions).find(|&axis| to[axis] <= from[axis]) {
        let message =
            format!("must lie above `from`, and on axis {axis} {} does not lie above {}", to[axis], from[axis]);
        return Err(keys.fault("to", message));
    }
    Ok((from, to))
}

/// The centre and the radius of a ball.
pub(crate) fn ball(keys: &Keys<'_>, dimensions: usize) -> Result<([f64; 3], f64), SceneError> {
    Ok((keys.required_vector("center", dimensions, "[0.5, 0.5]")?, keys.positive("radius", "0.2")?))
}

/// A closed mesh from a file, where it is placed.
pub(crate) fn mesh(keys: &Keys<'_>, dimensions: usize, folder: &Folder) -> Result<ClosedMesh, SceneError> {
    if dimensions != 3 {
        return Err(keys.fault("shape", "needs `dimensions = 3`"));
    }
    let mesh = keys.file("file", "\"bunny.obj\"", |name| {
        let bytes = folder.read(name)?;
        mesh::read(name, &bytes).and_then(|mesh| mesh.closed()).map_err(|fault| fault.to_string())
    })?;
    let scale = if keys.has("scale") { keys.positive("scale", "0.05")? } else { 1.0 };
    Ok(mesh.placed(scale, keys.vector("move", 3)?.unwrap_or_default()))
}
