//! The grid in dense and sparse layouts.

use allotrope::ShapeError;
use allotrope::prelude::*;
use allotrope::spatial::*;

use super::MpmSetup;

/// The grid of a scene: of its extents, or without bounds where the layout has none.
///
/// # Errors
/// If memory is refused.
pub(super) fn make<R: Record, G: Layout<X>, X: Spatial>(setup: &MpmSetup) -> Result<Field<R, G, X>, String> {
    if G::UNBOUNDED {
        return Ok(Field::unbounded());
    }
    Field::<R, G>::try_new(X::shape(|axis| setup.grid[axis])).map_err(|error: ShapeError| error.to_string())
}

/// Nodes along three axes.
pub(super) fn shape(setup: &MpmSetup) -> [usize; 3] {
    std::array::from_fn(|axis| if axis < setup.dimensions { setup.grid[axis] } else { 1 })
}

/// All nodes of the scene, in row-major order, whatever the layout.
pub(super) fn nodes<'a, R: Record, G: Layout<X>, X: Spatial>(
    grid: &'a Field<R, G, X>,
    shape: [usize; 3],
) -> impl Iterator<Item = R> + 'a {
    let count: usize = shape.iter().product();
    let bounded = (!G::UNBOUNDED).then(|| grid.iter());
    let place = move |n: usize| [n / (shape[1] * shape[2]), n / shape[2] % shape[1], n % shape[2]];
    // In a plane the third extent is one.
    let plane = move |n: usize, axis: usize| place(n)[axis] as i32;
    let unbounded =
        (0..if G::UNBOUNDED { count } else { 0 }).map(move |n| grid.get(X::Index::from_fn(|axis| plane(n, axis))));
    bounded.into_iter().flatten().chain(unbounded)
}

/// A sum over the nodes; over those that are held, where the layout is sparse.
pub(super) fn sum<R: Record, G: Layout<X>, X: Spatial>(grid: &Field<R, G, X>, of: impl Fn(R) -> f64) -> f64 {
    if G::SPARSE { grid.active_iter().map(|(_, node)| of(node)).sum() } else { grid.iter().map(of).sum() }
}
