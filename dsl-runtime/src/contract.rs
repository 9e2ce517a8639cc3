//! Products that are added to something, in one rounding: what `#[kernel(contract)]` makes of `a * b + c`.

use core::ops::Neg;

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4, Mat2, Mat3, Mat4, Vec2, Vec3, Vec4};

/// The operands `a`, `b` and `c`, and the result in two roundings.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Contracted<A, B, C, T>(pub A, pub B, pub C, pub T);

/// `a * b + c` in one rounding each component and product.
trait MulAdd<B, C> {
    fn fuse(self, b: B, c: C) -> C;
}

/// Operands that have a fused form.
#[doc(hidden)]
pub trait FuseKnown<T> {
    /// `a * b + c`.
    fn plus(&self, fused: bool) -> T;
    /// `a * b - c`.
    fn minus(&self, fused: bool) -> T;
    /// `c - a * b`.
    fn from(&self, fused: bool) -> T;
}

impl<A: MulAdd<B, C> + Neg<Output = A> + Copy, B: Copy, C: Neg<Output = C> + Copy> FuseKnown<C>
    for Contracted<A, B, C, C>
{
    #[inline(always)]
    fn plus(&self, fused: bool) -> C {
        if fused { self.0.fuse(self.1, self.2) } else { self.3 }
    }
    #[inline(always)]
    fn minus(&self, fused: bool) -> C {
        if fused { self.0.fuse(self.1, -self.2) } else { self.3 }
    }
    #[inline(always)]
    fn from(&self, fused: bool) -> C {
        if fused { (-self.0).fuse(self.1, self.2) } else { self.3 }
    }
}

/// All others, whose result is the plain one: whole numbers, and types of the user's own. A method is looked for here after
/// [`FuseKnown`], which takes one reference less.
#[doc(hidden)]
pub trait FuseAny<T> {
    /// `a * b + c`.
    fn plus(&self, fused: bool) -> T;
    /// `a * b - c`.
    fn minus(&self, fused: bool) -> T;
    /// `c - a * b`.
    fn from(&self, fused: bool) -> T;
}

impl<A, B, C, T: Copy> FuseAny<T> for &Contracted<A, B, C, T> {
    #[inline(always)]
    fn plus(&self, _: bool) -> T {
        self.3
    }
    #[inline(always)]
    fn minus(&self, _: bool) -> T {
        self.3
    }
    #[inline(always)]
    fn from(&self, _: bool) -> T {
        self.3
    }
}

/// Scalars, and their vectors and matrices: by each other, and by scalars from both sides.
macro_rules! fused_forms {
    ($($scalar:ident: [$($vector:ident)*] [$($matrix:ident of $column:ident, $($n:ident $axis:ident)*;)*])*) => {$(
        impl MulAdd<$scalar, $scalar> for $scalar {
            #[inline(always)]
            fn fuse(self, b: $scalar, c: $scalar) -> $scalar {
                self.mul_add(b, c)
            }
        }
        $(
            impl MulAdd<$vector, $vector> for $vector {
                #[inline(always)]
                fn fuse(self, b: $vector, c: $vector) -> $vector {
                    self.mul_add(b, c)
                }
            }
            impl MulAdd<$scalar, $vector> for $vector {
                #[inline(always)]
                fn fuse(self, b: $scalar, c: $vector) -> $vector {
                    self.mul_add($vector::splat(b), c)
                }
            }
            impl MulAdd<$vector, $vector> for $scalar {
                #[inline(always)]
                fn fuse(self, b: $vector, c: $vector) -> $vector {
                    b.mul_add($vector::splat(self), c)
                }
            }
        )*
        $(
            impl MulAdd<$column, $column> for $matrix {
                #[inline(always)]
                fn fuse(self, b: $column, c: $column) -> $column {
                    $(let c = self.$n.mul_add($column::splat(b.$axis), c);)*
                    c
                }
            }
            impl MulAdd<$scalar, $matrix> for $matrix {
                #[inline(always)]
                fn fuse(self, b: $scalar, c: $matrix) -> $matrix {
                    $matrix::from_cols($(self.$n.mul_add($column::splat(b), c.$n)),*)
                }
            }
            impl MulAdd<$matrix, $matrix> for $scalar {
                #[inline(always)]
                fn fuse(self, b: $matrix, c: $matrix) -> $matrix {
                    b.fuse(self, c)
                }
            }
        )*
    )*};
}

fused_forms! {
    f32: [Vec2 Vec3 Vec4] [
        Mat2 of Vec2, x_axis x y_axis y;
        Mat3 of Vec3, x_axis x y_axis y z_axis z;
        Mat4 of Vec4, x_axis x y_axis y z_axis z w_axis w;
    ]
    f64: [DVec2 DVec3 DVec4] [
        DMat2 of DVec2, x_axis x y_axis y;
        DMat3 of DVec3, x_axis x y_axis y z_axis z;
        DMat4 of DVec4, x_axis x y_axis y z_axis z w_axis w;
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Calls a method as expansions do, on a reference.
    macro_rules! fused {
        ($a:expr, $b:expr, $c:expr, $plain:expr, $method:ident, $fused:expr) => {{
            let operands = &Contracted($a, $b, $c, $plain);
            operands.$method($fused)
        }};
    }

    #[test]
    fn what_has_a_fused_form_is_rounded_once() {
        let (a, c) = (1.0 + f32::EPSILON, -1.0f32);
        let exact = 2.0 * f32::EPSILON + f32::EPSILON * f32::EPSILON;
        assert_eq!(fused!(a, a, c, a * a + c, plus, true), exact);
        assert_eq!(fused!(a, a, c, a * a + c, plus, false), 2.0 * f32::EPSILON);
        assert_eq!(fused!(a, a, -c, a * a - -c, minus, true), exact);
        assert_eq!(fused!(a, a, -c, -c - a * a, from, true), -exact);
        let (v, one) = (Vec3::splat(a), Vec3::splat(c));
        assert_eq!(fused!(v, a, one, v * a + one, plus, true), Vec3::splat(exact));
        assert_eq!(fused!(a, v, one, a * v + one, plus, true), Vec3::splat(exact));
        let m = Mat3::from_diagonal(v);
        assert_eq!(fused!(m, v, one, m * v + one, plus, true), Vec3::splat(exact));
        assert_eq!(fused!(m, a, -Mat3::IDENTITY, m * a - Mat3::IDENTITY, plus, true).x_axis.x, exact);
    }

    #[test]
    fn all_others_are_as_they_are() {
        assert_eq!(fused!(2, 3, 4, 2 * 3 + 4, plus, true), 10);
        assert_eq!(fused!(2.0f32, 3.0f32, 4u8, "plain", from, true), "plain");
    }
}
