//! The grid in dense and sparse layouts.

use allotrope::ShapeError;
use allotrope::prelude::*;
use allotrope::spatial::*;

use super::MpmSetup;
use super::convert::vectors;
use crate::Array;

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

/// The nodes of the scene by their numbers in row-major order, whatever the layout.
pub(super) fn nodes<'a, R: Record, G: Layout<X>, X: Spatial>(
    grid: &'a Field<R, G, X>,
    shape: [usize; 3],
) -> impl Fn(usize) -> R + 'a {
    // In a plane the third extent is one.
    let place = move |n: usize| [n / (shape[1] * shape[2]), n / shape[2] % shape[1], n % shape[2]];
    move |n| grid.get(X::Index::from_fn(|axis| place(n)[axis] as i32))
}

/// The arrays of velocity and mass of the nodes, compiled once for all layouts.
pub(super) fn arrays<X: Spatial>(shape: [usize; 3], node: &dyn Fn(usize) -> (X::Vec<f32>, f32)) -> Vec<Array> {
    let count: usize = shape.iter().product();
    vec![
        Array::floats("mass", (0..count).map(|n| [node(n).1])),
        vectors::<X>("velocity", (0..count).map(|n| node(n).0)),
    ]
}

/// A sum over the nodes; over those that are held, where the layout is sparse.
pub(super) fn sum<R: Record, G: Layout<X>, X: Spatial>(grid: &Field<R, G, X>, of: impl Fn(R) -> f64) -> f64 {
    if G::SPARSE { grid.active_iter().map(|(_, node)| of(node)).sum() } else { grid.iter().map(of).sum() }
}
