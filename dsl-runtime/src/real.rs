//! `Real`: what kernels that serve single and double precision are written for.

use core::fmt::{Debug, Display, LowerExp};
use core::iter;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use crate::axes::{Ij, Ijk};
use crate::element::{Element, Packed};
use crate::number::{ComponentMul, Number};
use crate::random::Random;
use crate::spatial::{Matrix, Vector};

macro_rules! real {
    (
        constants { $($(#[$constant_doc:meta])* $constant:ident = $path:ident::$value:ident,)* }
        unary { $($(#[$unary_doc:meta])* $unary:ident,)* }
        binary { $($(#[$binary_doc:meta])* $binary:ident($other:ident),)* }
        tests { $($(#[$test_doc:meta])* $test:ident,)* }
    ) => {
        /// A floating-point number, `f32` or `f64`: with `T: Real` one kernel serves both precisions.
        ///
        /// It has the operators of numbers and, under the same names, the functions that `f32` and `f64` have in common. A constant is
        /// written `T::from(0.5)`, another number is converted by [`from_f64`](Real::from_f64) or [`from_i32`](Real::from_i32).
        ///
        /// ```
        /// use allotrope::prelude::*;
        ///
        /// /// A step of the heat equation.
        /// #[kernel]
        /// fn heat<T: Real>(from: &Field<T, _>, to: &mut Field<T, _>, rate: T) -> T {
        ///     let mut change = T::ZERO;
        ///     for i in to.interior(1) {
        ///         let flow = from[i - 1] + from[i + 1] - T::from(2.0) * from[i];
        ///         to[i] = from[i] + rate * flow;
        ///         change.max_assign((rate * flow).abs());
        ///     }
        ///     change
        /// }
        ///
        /// let mut single = Field::<f32, Soa>::new([9]);
        /// single.set(4, 1.0);
        /// let double = &mut Field::<f64, Blocked<4>>::new([9]);
        /// assert_eq!(heat(&single, &mut single.clone(), 0.25), 0.5);
        /// assert_eq!(heat::<f64>(&double.clone(), double, 0.25), 0.0);
        /// ```
        #[diagnostic::on_unimplemented(
            message = "`{Self}` is no floating-point number",
            label = "neither `f32` nor `f64`",
            note = "kernels over `T: Real` serve `f32` and `f64`"
        )]
        pub trait Real:
            Element<Scalar = Self>
            + Packed
            + Number
            + ComponentMul<Self>
            + Random
            + Default
            + PartialOrd
            + Debug
            + Display
            + LowerExp
            + From<f32>
            + Into<f64>
            + Neg<Output = Self>
            + Add<Output = Self>
            + Sub<Output = Self>
            + Mul<Output = Self>
            + Div<Output = Self>
            + Rem<Output = Self>
            + AddAssign
            + SubAssign
            + MulAssign
            + DivAssign
            + RemAssign
            + iter::Sum
            + iter::Product
        {
            /// `Vec2` or `DVec2`.
            type Vec2: Vector<Self, Ij>;
            /// `Vec3` or `DVec3`.
            type Vec3: Vector<Self, Ijk>;
            /// `Mat2` or `DMat2`.
            type Mat2: Matrix<Self, Self::Vec2>;
            /// `Mat3` or `DMat3`.
            type Mat3: Matrix<Self, Self::Vec3>;
            /// 0.
            const ZERO: Self;
            /// 1.
            const ONE: Self;
            $($(#[$constant_doc])* const $constant: Self;)*
            /// The nearest number of this type.
            fn from_f64(value: f64) -> Self;
            /// The nearest number of this type.
            fn from_i32(value: i32) -> Self;
            /// This number in double precision.
            fn to_f64(self) -> f64;
            /// This number without its fraction, as `as i32` makes it: the nearest `i32` where it is out of range, 0 for NaN.
            fn to_i32(self) -> i32;
            $($(#[$unary_doc])* fn $unary(self) -> Self;)*
            $($(#[$binary_doc])* fn $binary(self, $other: Self) -> Self;)*
            $($(#[$test_doc])* fn $test(self) -> bool;)*
            /// Between `low` and `high`.
            ///
            /// # Panics
            /// Where `low` is above `high`, or either is NaN.
            fn clamp(self, low: Self, high: Self) -> Self;
            /// `self * factor + term`, rounded once.
            fn mul_add(self, factor: Self, term: Self) -> Self;
            /// Raised to an integer power.
            fn powi(self, power: i32) -> Self;
            /// Sine and cosine.
            fn sin_cos(self) -> (Self, Self);
        }

        real!(@impl f32 (Vec2 Vec3 Mat2 Mat3) [$($constant $path $value,)*] [$($unary)*] [$($binary)*] [$($test)*]);
        real!(@impl f64 (DVec2 DVec3 DMat2 DMat3) [$($constant $path $value,)*] [$($unary)*] [$($binary)*] [$($test)*]);
    };
    (@impl $float:ident ($vec2:ident $vec3:ident $mat2:ident $mat3:ident) [$($constant:ident $path:ident $value:ident,)*] [$($unary:ident)*] [$($binary:ident)*] [$($test:ident)*]) => {
        impl Real for $float {
            type Vec2 = glam::$vec2;
            type Vec3 = glam::$vec3;
            type Mat2 = glam::$mat2;
            type Mat3 = glam::$mat3;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            $(const $constant: Self = real!(@constant $float $path $value);)*
            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn from_i32(value: i32) -> Self {
                value as $float
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.into()
            }
            #[inline(always)]
            fn to_i32(self) -> i32 {
                self as i32
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    $float::$unary(self)
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    $float::$binary(self, other)
                }
            )*
            $(
                #[inline(always)]
                fn $test(self) -> bool {
                    $float::$test(self)
                }
            )*
            #[inline(always)]
            fn clamp(self, low: Self, high: Self) -> Self {
                $float::clamp(self, low, high)
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                $float::mul_add(self, factor, term)
            }
            #[inline(always)]
            fn powi(self, power: i32) -> Self {
                $float::powi(self, power)
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $float::sin_cos(self)
            }
        }
    };
    (@constant $float:ident consts $value:ident) => { core::$float::consts::$value };
    (@constant $float:ident own $value:ident) => { $float::$value };
}

real! {
    constants {
        /// The difference between 1 and the next larger number.
        EPSILON = own::EPSILON,
        /// The largest finite number.
        MAX = own::MAX,
        /// The smallest finite number.
        MIN = own::MIN,
        /// Infinity.
        INFINITY = own::INFINITY,
        /// Minus infinity.
        NEG_INFINITY = own::NEG_INFINITY,
        /// Not a number.
        NAN = own::NAN,
        /// π.
        PI = consts::PI,
        /// 2π.
        TAU = consts::TAU,
    }
    unary {
        /// The absolute value.
        abs,
        /// The square root.
        sqrt,
        /// The cube root.
        cbrt,
        /// 1 divided by the number.
        recip,
        /// 1 or -1, of the number's sign; NaN for NaN.
        signum,
        /// The largest integer that is not above.
        floor,
        /// The smallest integer that is not below.
        ceil,
        /// The nearest integer, halves away from zero.
        round,
        /// The integer towards zero.
        trunc,
        /// What [`trunc`](Real::trunc) leaves.
        fract,
        /// The exponential function.
        exp,
        /// 2 to this power.
        exp2,
        /// The natural logarithm.
        ln,
        /// The logarithm to the base 2.
        log2,
        /// The logarithm to the base 10.
        log10,
        /// The sine.
        sin,
        /// The cosine.
        cos,
        /// The tangent.
        tan,
        /// The inverse sine.
        asin,
        /// The inverse cosine.
        acos,
        /// The inverse tangent.
        atan,
        /// The hyperbolic sine.
        sinh,
        /// The hyperbolic cosine.
        cosh,
        /// The hyperbolic tangent.
        tanh,
        /// From degrees to radians.
        to_radians,
        /// From radians to degrees.
        to_degrees,
    }
    binary {
        /// The smaller; NaN never is.
        min(other),
        /// The larger; NaN never is.
        max(other),
        /// Raised to a power.
        powf(power),
        /// The angle of the point (`x`, `self`).
        atan2(x),
        /// The length of the vector of both.
        hypot(other),
        /// This magnitude with another number's sign.
        copysign(sign),
        /// The remainder that is not negative.
        rem_euclid(divisor),
    }
    tests {
        /// Whether it is not a number.
        is_nan,
        /// Whether it is neither infinite nor NaN.
        is_finite,
        /// Whether its sign is minus, that of zeros included.
        is_sign_negative,
    }
}
