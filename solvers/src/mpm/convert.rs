//! Between what kernels compute with, which has as many components as axes, and the rest of the program, where vectors
//! have three.

use allotrope::prelude::*;
use allotrope::spatial::*;

use crate::{Array, State};

/// A vector from one with a third component.
pub(crate) fn vector<X: Spatial, T: Real>(v: [f64; 3]) -> X::Vec<T> {
    X::Vec::<T>::from_fn(|axis| T::from_f64(v[axis]))
}

/// A vector with a third component.
pub(crate) fn triple<X: Spatial>(v: X::Vec<f32>) -> [f64; 3] {
    std::array::from_fn(|axis| if axis < X::RANK { f64::from(v[axis]) } else { 0.0 })
}

/// A matrix from its rows.
pub(crate) fn matrix<X: Spatial, T: Real>(rows: [[f64; 3]; 3]) -> X::Mat<T> {
    X::Mat::<T>::from_fn(|row, column| T::from_f64(rows[row][column]))
}

/// A matrix' rows.
pub(crate) fn rows<X: Spatial>(matrix: X::Mat<f32>) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| if row < X::RANK { triple::<X>(matrix.row(row)) } else { [0.0; 3] })
}

/// A node with a third component.
#[inline(always)]
pub(crate) fn node<X: Spatial>(index: X::Index) -> IVec3 {
    ivec3(index[0], index[1], if X::RANK > 2 { index[2] } else { 0 })
}

/// A velocity with a third component.
#[inline(always)]
pub(crate) fn raised<X: Spatial>(v: X::Vec<f32>) -> Vec3 {
    vec3(v[0], v[1], if X::RANK > 2 { v[2] } else { 0.0 })
}

/// A velocity without its third component, where there is none.
#[inline(always)]
pub(crate) fn lowered<X: Spatial>(v: Vec3) -> X::Vec<f32> {
    X::Vec::<f32>::from_fn(|axis| v[axis])
}

/// An array of vectors.
pub(crate) fn vectors<X: Spatial>(name: &'static str, mut vectors: impl Iterator<Item = X::Vec<f32>>) -> Array {
    vectors_of::<X>(name, &mut || vectors.next())
}

/// The same, compiled once for all iterators.
fn vectors_of<X: Spatial>(name: &'static str, next: &mut dyn FnMut() -> Option<X::Vec<f32>>) -> Array {
    Array::numbers(name, X::RANK, std::iter::from_fn(next).flat_map(|v| (0..X::RANK).map(move |axis| v[axis])))
}

/// An array of matrices.
pub(crate) fn matrices<X: Spatial>(name: &'static str, mut matrices: impl Iterator<Item = X::Mat<f32>>) -> Array {
    matrices_of::<X>(name, &mut || matrices.next())
}

/// The same, compiled once for all iterators.
fn matrices_of<X: Spatial>(name: &'static str, next: &mut dyn FnMut() -> Option<X::Mat<f32>>) -> Array {
    let components =
        |matrix: X::Mat<f32>| (0..X::RANK).flat_map(move |column| (0..X::RANK).map(move |row| matrix.col(column)[row]));
    Array::numbers(name, X::RANK * X::RANK, std::iter::from_fn(next).flat_map(components))
}

/// The vectors of a saved array.
///
/// # Errors
/// If it is missing or of another length.
pub(crate) fn saved_vectors<X: Spatial>(
    state: &State,
    name: &str,
    count: usize,
) -> Result<impl Fn(usize) -> X::Vec<f32>, String> {
    let values = state.numbers(name, X::RANK, count)?;
    Ok(move |p: usize| X::Vec::<f32>::from_fn(|axis| values[p * X::RANK + axis]))
}

/// The matrices of a saved array.
///
/// # Errors
/// If it is missing or of another length.
pub(crate) fn saved_matrices<X: Spatial>(
    state: &State,
    name: &str,
    count: usize,
) -> Result<impl Fn(usize) -> X::Mat<f32>, String> {
    let values = state.numbers(name, X::RANK * X::RANK, count)?;
    Ok(move |p: usize| X::Mat::<f32>::from_fn(|row, column| values[(p * X::RANK + column) * X::RANK + row]))
}
