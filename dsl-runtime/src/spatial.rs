//! Types that serve two and three axes, single and double precision: `X::Index`, `X::Vec<T>`, `X::Mat<T>`.
//!
//! Generic records and kernels begin with `use allotrope::spatial::*;` beside the prelude. [`Spatial`] shows a kernel.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Index, IndexMut, Mul, MulAssign, Neg, Rem, Sub, SubAssign};

use crate::axes::{Axes, Ij, Ijk, Shape};
use crate::element::Element;
use crate::index::IntoIndex;
use crate::random::Random;
pub use crate::real::Real;

/// Axes of a plane or of space, [`Ij`] or [`Ijk`]: with them come the types of indices, vectors and matrices, so that one record and one kernel
/// serve both.
///
/// ```
/// use allotrope::prelude::*;
/// use allotrope::spatial::*;
///
/// /// A material point.
/// #[derive(Record, Clone, Copy, Default)]
/// struct Point<X: Spatial, T: Real> {
///     x: X::Vec<T>,
///     v: X::Vec<T>,
/// }
///
/// /// Scatters a mass of 1 for each point to the nodes around it, with linear weights.
/// #[kernel]
/// fn deposit<X: Spatial, T: Real>(points: &Field<Point<X, T>, _>, mass: &mut Field<T, _, X>, inv_dx: T) {
///     for p in points {
///         let at = points.x[p] * inv_dx;
///         let base = at.to_index();
///         let fx = at - base.to_vec();
///         for offset in unroll!(X, 0..2) {
///             let mut weight = T::ONE;
///             for axis in 0..X::RANK {
///                 weight *= if offset[axis] == 1 { fx[axis] } else { T::ONE - fx[axis] };
///             }
///             mass[base + offset] += weight;
///         }
///     }
/// }
///
/// let mut flat = Field::<Point<Ij, f32>, Soa>::new([3]);
/// flat.set(1, Point { x: vec2(0.5, 0.25), v: Vec2::ZERO });
/// let mut mass = Field::<f32, Aos>::new([4, 4]);
/// deposit(&flat, &mut mass, 2.0);
/// assert_eq!((mass.get((1, 0)), mass.get((1, 1)), mass.get((0, 0))), (0.5, 0.5, 2.0));
///
/// let solid = Field::<Point<Ijk, f64>, Aos>::new([5]);
/// let mut mass = Field::<f64, Blocked<2>>::new([4, 4, 4]);
/// deposit(&solid, &mut mass, 2.0);
/// assert_eq!(mass.get((0, 0, 0)), 5.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` are not the axes of a plane or of space",
    note = "write `Ij` or `Ijk`"
)]
pub trait Spatial: Axes<Index: IndexVector<Self>, Extents: Shape<X = Self>> + Default + PartialEq + Debug {
    /// A vector of numbers: `Vec2`, `DVec2`, `Vec3` or `DVec3`.
    type Vec<T: Real>: Vector<T, Self>;
    /// A square matrix of numbers, such as `Mat2`.
    type Mat<T: Real>: Matrix<T, Self::Vec<T>>;
    /// Extents, of which [`Field::new`](crate::Field::new) makes a field over these axes.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// use allotrope::spatial::*;
    ///
    /// fn cube<X: Spatial>(side: usize) -> Field<f32, Soa, X>
    /// where
    ///     Soa: Layout<X>,
    /// {
    ///     Field::<f32, Soa>::new(X::shape(|_axis| side))
    /// }
    ///
    /// assert_eq!(cube::<Ij>(8).shape(), [8, 8]);
    /// assert_eq!(cube::<Ijk>(8).shape(), [8, 8, 8]);
    /// ```
    fn shape(extent: impl FnMut(usize) -> usize) -> Self::Extents;
    /// Calls `body` with each index whose coordinates are `low` to `high - 1`, written out, the last axis fastest.
    #[doc(hidden)]
    fn unrolled<const LENGTH: usize>(low: i32, body: impl FnMut(Self::Index));
    /// The same in loops. Inlined all the same: a call would take the body's variables by their addresses, and what has an address is not kept
    /// in registers where the loop is written out, either.
    #[doc(hidden)]
    fn rolled<const LENGTH: usize>(low: i32, body: impl FnMut(Self::Index));
}

impl Spatial for Ij {
    type Vec<T: Real> = T::Vec2;
    type Mat<T: Real> = T::Mat2;
    fn shape(extent: impl FnMut(usize) -> usize) -> [usize; 2] {
        core::array::from_fn(extent)
    }
    #[inline(always)]
    fn unrolled<const LENGTH: usize>(low: i32, mut body: impl FnMut(glam::IVec2)) {
        crate::element::times::<LENGTH>(
            #[inline(always)]
            |i| {
                crate::element::times::<LENGTH>(
                    #[inline(always)]
                    |j| body(glam::ivec2(low + i as i32, low + j as i32)),
                )
            },
        );
    }
    #[inline(always)]
    fn rolled<const LENGTH: usize>(low: i32, mut body: impl FnMut(glam::IVec2)) {
        for i in low..low + LENGTH as i32 {
            for j in low..low + LENGTH as i32 {
                body(glam::ivec2(i, j));
            }
        }
    }
}

impl Spatial for Ijk {
    type Vec<T: Real> = T::Vec3;
    type Mat<T: Real> = T::Mat3;
    fn shape(extent: impl FnMut(usize) -> usize) -> [usize; 3] {
        core::array::from_fn(extent)
    }
    #[inline(always)]
    fn unrolled<const LENGTH: usize>(low: i32, mut body: impl FnMut(glam::IVec3)) {
        crate::element::times::<LENGTH>(
            #[inline(always)]
            |i| {
                Ij::unrolled::<LENGTH>(
                    low,
                    #[inline(always)]
                    |jk| body(glam::ivec3(low + i as i32, jk.x, jk.y)),
                )
            },
        );
    }
    #[inline(always)]
    fn rolled<const LENGTH: usize>(low: i32, mut body: impl FnMut(glam::IVec3)) {
        for i in low..low + LENGTH as i32 {
            Ij::rolled::<LENGTH>(
                low,
                #[inline(always)]
                |jk| body(glam::ivec3(i, jk.x, jk.y)),
            );
        }
    }
}

/// An index of [`Spatial`] axes, `IVec2` or `IVec3`: coordinates by `index[axis]`.
pub trait IndexVector<X: Spatial<Index = Self>>:
    IntoIndex<X>
    + Element<Scalar = i32>
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Add<i32, Output = Self>
    + Sub<i32, Output = Self>
    + Mul<i32, Output = Self>
    + Div<i32, Output = Self>
    + Rem<i32, Output = Self>
    + AddAssign
    + SubAssign
    + Index<usize, Output = i32>
    + IndexMut<usize>
{
    /// All coordinates the same.
    fn splat(coordinate: i32) -> Self;
    /// The coordinate along each axis.
    fn from_fn(coordinate: impl FnMut(usize) -> i32) -> Self;
    /// The coordinates as numbers.
    fn to_vec<T: Real>(self) -> X::Vec<T>;
    /// The smaller coordinate along each axis.
    fn min(self, other: Self) -> Self;
    /// The larger coordinate along each axis.
    fn max(self, other: Self) -> Self;
}

macro_rules! index_vectors {
    ($($index:ident over $axes:ident: $vec:ident, $($axis:literal)*;)*) => {$(
        impl IndexVector<$axes> for glam::$index {
            #[inline(always)]
            fn splat(coordinate: i32) -> Self {
                Self::splat(coordinate)
            }
            #[inline(always)]
            fn from_fn(mut coordinate: impl FnMut(usize) -> i32) -> Self {
                Self::new($(coordinate($axis)),*)
            }
            #[inline(always)]
            fn to_vec<T: Real>(self) -> T::$vec {
                <T::$vec>::from_index(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self::max(self, other)
            }
        }
    )*};
}
index_vectors! {
    IVec2 over Ij: Vec2, 0 1;
    IVec3 over Ijk: Vec3, 0 1 2;
}

/// A vector along [`Spatial`] axes: components by `v[axis]`. A factor stands behind it: `v * x`.
///
/// Its functions are glam's, and [`from_fn`](Vector::from_fn), whose calls are written out: of what the optimiser sees through, no loop remains.
pub trait Vector<T: Real, X: Spatial>:
    Element<Scalar = T>
    + Random
    + Default
    + PartialEq
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<T, Output = Self>
    + Sub<T, Output = Self>
    + Mul<T, Output = Self>
    + Div<T, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + MulAssign<T>
    + DivAssign<T>
    + Index<usize, Output = T>
    + IndexMut<usize>
{
    /// All components zero.
    fn zero() -> Self;
    /// All components the same.
    fn splat(component: T) -> Self;
    /// The component along each axis.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// use allotrope::spatial::*;
    ///
    /// /// The product of one weight an axis.
    /// fn weight<X: Spatial, T: Real>(weights: &[X::Vec<T>; 3], offset: X::Index) -> T {
    ///     X::Vec::<T>::from_fn(|axis| weights[offset[axis] as usize][axis]).element_product()
    /// }
    ///
    /// let weights = [vec2(0.1, 0.2), vec2(0.3, 0.4), vec2(0.5, 0.6)];
    /// assert_eq!(weight::<Ij, f32>(&weights, ivec2(2, 0)), 0.5 * 0.2);
    /// ```
    fn from_fn(component: impl FnMut(usize) -> T) -> Self;
    /// The coordinates of an index.
    fn from_index(index: X::Index) -> Self;
    /// The integer parts of the components, towards zero.
    fn to_index(self) -> X::Index;
    /// The sum of the products of the components.
    fn dot(self, other: Self) -> T;
    /// The Euclidean length.
    fn length(self) -> T;
    /// Its square.
    fn length_squared(self) -> T;
    /// The vector of length 1 in this direction; zero where there is none.
    fn normalize_or_zero(self) -> Self;
    /// The smaller component along each axis.
    fn min(self, other: Self) -> Self;
    /// The larger component along each axis.
    fn max(self, other: Self) -> Self;
    /// Without signs.
    fn abs(self) -> Self;
    /// The largest integers that are not above the components.
    fn floor(self) -> Self;
    /// The smallest component.
    fn min_element(self) -> T;
    /// The largest component.
    fn max_element(self) -> T;
    /// The sum of the components.
    fn element_sum(self) -> T;
    /// The product of the components.
    fn element_product(self) -> T;
    /// Whether all components are finite.
    fn is_finite(self) -> bool;
}

macro_rules! vectors {
    ($($vec:ident of $real:ident over $axes:ident $($axis:literal)*, $index:ident by $from:ident and $to:ident;)*) => {$(
        impl Vector<$real, $axes> for glam::$vec {
            #[inline(always)]
            fn zero() -> Self {
                Self::ZERO
            }
            #[inline(always)]
            fn splat(component: $real) -> Self {
                Self::splat(component)
            }
            #[inline(always)]
            fn from_fn(mut component: impl FnMut(usize) -> $real) -> Self {
                Self::new($(component($axis)),*)
            }
            #[inline(always)]
            fn from_index(index: glam::$index) -> Self {
                index.$from()
            }
            #[inline(always)]
            fn to_index(self) -> glam::$index {
                self.$to()
            }
            vectors!(@functions
                dot(other: Self) -> $real; length() -> $real; length_squared() -> $real; normalize_or_zero() -> Self;
                min(other: Self) -> Self; max(other: Self) -> Self; abs() -> Self; floor() -> Self; min_element() -> $real;
                max_element() -> $real; element_sum() -> $real; element_product() -> $real; is_finite() -> bool;
            );
        }
    )*};
    (@functions $($name:ident($($argument:ident: $ty:ty),*) -> $out:ty;)*) => {$(
        #[inline(always)]
        fn $name(self, $($argument: $ty),*) -> $out {
            Self::$name(self, $($argument),*)
        }
    )*};
}
vectors! {
    Vec2 of f32 over Ij 0 1, IVec2 by as_vec2 and as_ivec2;
    DVec2 of f64 over Ij 0 1, IVec2 by as_dvec2 and as_ivec2;
    Vec3 of f32 over Ijk 0 1 2, IVec3 by as_vec3 and as_ivec3;
    DVec3 of f64 over Ijk 0 1 2, IVec3 by as_dvec3 and as_ivec3;
}

/// A square matrix over [`Spatial`] axes, `V` its columns.
///
/// Its functions are glam's, but for `zero`, `identity`, `from_fn`, `outer` and `trace`.
pub trait Matrix<T: Real, V>:
    Element<Scalar = T>
    + Default
    + PartialEq
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<Output = Self>
    + Mul<V, Output = V>
    + Mul<T, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign<T>
{
    /// All components zero.
    fn zero() -> Self;
    /// Ones on the diagonal.
    fn identity() -> Self;
    /// The component of each row and column.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// use allotrope::spatial::*;
    /// let matrix = <Mat2 as Matrix<f32, Vec2>>::from_fn(|row, column| (10 * row + column) as f32);
    /// assert_eq!(matrix.row(1), vec2(10.0, 11.0));
    /// ```
    fn from_fn(component: impl FnMut(usize, usize) -> T) -> Self;
    /// Zero but for the diagonal.
    fn from_diagonal(diagonal: V) -> Self;
    /// The matrix `a b^T`, whose row `i`, column `j` holds `a[i] b[j]`.
    fn outer(a: V, b: V) -> Self;
    /// The sum of the diagonal.
    fn trace(self) -> T;
    /// A column.
    fn col(self, axis: usize) -> V;
    /// A row.
    fn row(self, axis: usize) -> V;
    /// The transposed matrix.
    fn transpose(self) -> Self;
    /// The determinant.
    fn determinant(self) -> T;
    /// The inverse; not finite where there is none.
    fn inverse(self) -> Self;
}

macro_rules! matrices {
    ($($mat:ident of $real:ident with $vec:ident, $($axis:literal)*, $($last:literal $column:ident)*;)*) => {$(
        impl Matrix<$real, glam::$vec> for glam::$mat {
            #[inline(always)]
            fn zero() -> Self {
                Self::ZERO
            }
            #[inline(always)]
            fn identity() -> Self {
                Self::IDENTITY
            }
            #[inline(always)]
            fn from_fn(mut component: impl FnMut(usize, usize) -> $real) -> Self {
                Self::from_cols($(<glam::$vec>::from_fn(
                    #[inline(always)]
                    |row| component(row, $axis),
                )),*)
            }
            #[inline(always)]
            fn from_diagonal(diagonal: glam::$vec) -> Self {
                Self::from_diagonal(diagonal)
            }
            #[inline(always)]
            fn outer(a: glam::$vec, b: glam::$vec) -> Self {
                Self::from_cols($(a * b[$axis]),*)
            }
            #[inline(always)]
            fn trace(self) -> $real {
                self.x_axis[0] $(+ self.$column[$last])*
            }
            #[inline(always)]
            fn col(self, axis: usize) -> glam::$vec {
                Self::col(&self, axis)
            }
            #[inline(always)]
            fn row(self, axis: usize) -> glam::$vec {
                Self::row(&self, axis)
            }
            #[inline(always)]
            fn transpose(self) -> Self {
                Self::transpose(&self)
            }
            #[inline(always)]
            fn determinant(self) -> $real {
                Self::determinant(&self)
            }
            #[inline(always)]
            fn inverse(self) -> Self {
                Self::inverse(&self)
            }
        }
    )*};
}
matrices! {
    Mat2 of f32 with Vec2, 0 1, 1 y_axis;
    DMat2 of f64 with DVec2, 0 1, 1 y_axis;
    Mat3 of f32 with Vec3, 0 1 2, 1 y_axis 2 z_axis;
    DMat3 of f64 with DVec3, 0 1 2, 1 y_axis 2 z_axis;
}
