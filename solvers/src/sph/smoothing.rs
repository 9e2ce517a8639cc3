//! Smoothing kernels and their gradients.

use allotrope::prelude::*;

/// A form of the smoothing kernel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spline {
    /// The cubic spline M4, which ends at two smoothing lengths (Monaghan & Lattanzio 1985; Monaghan 1992).
    #[default]
    Cubic,
    /// The Gaussian, cut off at three smoothing lengths, where it has fallen to 1.2e-4 of its height.
    Gaussian,
}

impl Spline {
    /// The support radius in smoothing lengths.
    pub fn reach(self) -> f64 {
        match self {
            Self::Cubic => 2.0,
            Self::Gaussian => 3.0,
        }
    }

    /// The integral of the form over all of space, in smoothing lengths to the power of the dimensions; `None` for other
    /// than 1, 2 or 3 dimensions.
    fn volume(self, dimensions: usize) -> Option<f64> {
        use std::f64::consts::PI;
        Some(match (self, dimensions) {
            (Self::Cubic, 1) => 3.0 / 2.0,
            (Self::Cubic, 2) => 7.0 * PI / 10.0,
            (Self::Cubic, 3) => PI,
            (Self::Gaussian, 1..=3) => PI.powf(0.5 * dimensions as f64),
            _ => return None,
        })
    }
}

/// A smoothing kernel `W`, in double or single precision.
///
/// It takes the square of a distance, so that no root is taken for what lies beyond the support.
///
/// ```
/// use allotrope_solvers::sph::{Smoothing, Spline};
///
/// let kernel = Smoothing::<f64>::new(Spline::Cubic, 3, 0.1).unwrap();
/// assert!((kernel.weight(0.0) - 1000.0 / std::f64::consts::PI).abs() < 1e-9);
/// assert_eq!((kernel.support(), kernel.weight(0.2f64.powi(2))), (0.2, 0.0));
/// assert!(kernel.slope(0.15f64.powi(2)) < 0.0);
/// assert!(Smoothing::<f64>::new(Spline::Cubic, 4, 0.1).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smoothing<T: Real = f32> {
    form: Spline,
    h: T,
    inv_h: T,
    support: T,
    support_squared: T,
    /// The factor in front of the form, in 1/m^dimensions, ..
    scale: T,
    /// .. and of its slope, in 1/m^(dimensions + 2).
    slope_scale: T,
}

impl<T: Real> Smoothing<T> {
    /// The kernel of a form in 1, 2 or 3 dimensions with the smoothing length `h` in m; `None` for other dimensions.
    pub fn new(form: Spline, dimensions: usize, h: f64) -> Option<Self> {
        let scale = 1.0 / (form.volume(dimensions)? * h.powi(dimensions as i32));
        let support = form.reach() * h;
        Some(Self {
            form,
            h: T::from_f64(h),
            inv_h: T::from_f64(1.0 / h),
            support: T::from_f64(support),
            support_squared: T::from_f64(support * support),
            scale: T::from_f64(scale),
            slope_scale: T::from_f64(scale / (h * h)),
        })
    }

    /// The smoothing length in m.
    #[inline(always)]
    pub fn smoothing_length(&self) -> T {
        self.h
    }

    /// The support radius in m: from there on the kernel is zero.
    #[inline(always)]
    pub fn support(&self) -> T {
        self.support
    }

    /// Its square.
    #[inline(always)]
    pub fn support_squared(&self) -> T {
        self.support_squared
    }

    /// `W` in 1/m^dimensions at a distance whose square is given.
    #[inline(always)]
    pub fn weight(&self, squared: T) -> T {
        if squared >= self.support_squared {
            return T::ZERO;
        }
        let q = squared.sqrt() * self.inv_h;
        self.scale
            * match self.form {
                Spline::Cubic => {
                    let (far, near) = (T::from(2.0) - q, (T::ONE - q).max(T::ZERO));
                    T::from(0.25) * (far * far * far) - near * near * near
                }
                Spline::Gaussian => (-q * q).exp(),
            }
    }

    /// `1/r dW/dr` in 1/m^(dimensions + 2) at a distance `r` whose square is given: the gradient of `W(x_a - x_b)` to `x_a`
    /// is this times `x_a - x_b`, which is zero where both are at one place.
    #[inline(always)]
    pub fn slope(&self, squared: T) -> T {
        if squared >= self.support_squared {
            return T::ZERO;
        }
        self.slope_scale
            * match self.form {
                Spline::Cubic => {
                    let q = squared.sqrt() * self.inv_h;
                    // 3 - 9/4 q up to 1, then 3/4 (2 - q)^2 / q, without a branch.
                    let (far, near) = (T::from(2.0) - q, (T::ONE - q).max(T::ZERO));
                    T::from(-0.75) * (far + near + near) * (far / q.max(T::ONE)).min(T::ONE)
                }
                Spline::Gaussian => T::from(-2.0) * (-squared * self.inv_h * self.inv_h).exp(),
            }
    }
}
