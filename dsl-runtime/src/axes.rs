//! The axes of a field: how many indices an element has.

use crate::element::Sealed;

/// The most axes that a field can have.
pub(crate) const MAX_AXES: usize = 4;

/// One number an axis; places beyond the rank are unused.
pub(crate) type PerAxis = [usize; MAX_AXES];

/// The names of the axes, in order.
pub(crate) const AXIS_NAMES: [&str; MAX_AXES] = ["i", "j", "k", "l"];

/// The axes of a field, its third parameter: [`O`], [`I`], [`Ij`], [`Ijk`] or [`Ijkl`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` names no axes",
    note = "the axes of a field are `O`, `I`, `Ij`, `Ijk` or `Ijkl`"
)]
pub trait Axes: Copy + Send + Sync + Sealed + 'static {
    /// How many there are.
    const RANK: usize;
    /// The axes without the last: those of the lists that the last one counts the entries of.
    type Outer: Axes;
    /// What a loop variable over them is: `()`, `i32`, `IVec2`, `IVec3` or `IVec4`.
    type Index: Copy + Send + Sync + core::fmt::Debug + PartialEq + crate::index::IntoIndex<Self>;
    /// The same as a tuple: `()`, `(i32,)`, `(i32, i32)` and so on.
    type Tuple: Copy;
    /// Extents along them: `[usize; RANK]`.
    type Extents: Copy + core::fmt::Debug + AsRef<[usize]>;
    #[doc(hidden)]
    fn index(at: [i32; MAX_AXES]) -> Self::Index;
    #[doc(hidden)]
    fn tuple(at: [i32; MAX_AXES]) -> Self::Tuple;
    #[doc(hidden)]
    fn extents(at: PerAxis) -> Self::Extents;
}

/// Extents that a field can be made from: `[]`, `[n]`, `[n, m]` and so on, up to four.
pub trait Shape: Copy + Sealed {
    /// The axes that so many extents mean.
    type X: Axes;
    #[doc(hidden)]
    fn per_axis(self) -> PerAxis;
}

macro_rules! axes {
    ($($name:ident, $rank:literal, $outer:ident, $index:ty, $tuple:ty, $doc:literal, |$at:pat_param| $make:expr, $make_tuple:expr;)*) => {$(
        #[doc = $doc]
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct $name;
        impl Sealed for $name {}
        impl Axes for $name {
            const RANK: usize = $rank;
            type Outer = $outer;
            type Index = $index;
            type Tuple = $tuple;
            type Extents = [usize; $rank];
            #[inline(always)]
            fn index($at: [i32; MAX_AXES]) -> $index {
                $make
            }
            #[inline(always)]
            fn tuple($at: [i32; MAX_AXES]) -> $tuple {
                $make_tuple
            }
            #[inline(always)]
            fn extents(at: PerAxis) -> [usize; $rank] {
                core::array::from_fn(|a| at[a])
            }
        }
        // `Sealed` of `[usize; N]` comes with `[T; N]: Element`.
        impl Shape for [usize; $rank] {
            type X = $name;
            fn per_axis(self) -> PerAxis {
                core::array::from_fn(|a| self.get(a).copied().unwrap_or(1))
            }
        }
    )*};
}
axes! {
    O, 0, O, (), (), "No axes: a single record, indexed by `()`.", |_| (), ();
    I, 1, O, i32, (i32,), "One axis, `i`: lists of particles, vectors. The default.", |at| at[0], (at[0],);
    Ij, 2, I, glam::IVec2, (i32, i32), "Two axes, `i` and `j`: images, grids.", |at| glam::ivec2(at[0], at[1]), (at[0], at[1]);
    Ijk, 3, Ij, glam::IVec3, (i32, i32, i32), "Three axes, `i`, `j` and `k`: volumes.", |at| glam::ivec3(at[0], at[1], at[2]), (at[0], at[1], at[2]);
    Ijkl, 4, Ijk, glam::IVec4, (i32, i32, i32, i32), "Four axes, `i`, `j`, `k` and `l`: volumes of phase space.", |at| glam::IVec4::from_array(at), at.into();
}

/// Does something for each axis of `$x`, whose number is a constant there: whatever that decides is settled before the optimiser sees it, and there is no
/// call to inline. For what is written out at every access of a kernel, where closures are
/// much to inline.
macro_rules! for_axes {
    ($x:ty, $axis:ident => $what:expr) => {{
        {
            const $axis: usize = 0;
            $what;
        }
        if const { <$x as $crate::axes::Axes>::RANK > 1 } {
            const $axis: usize = 1;
            $what;
        }
        if const { <$x as $crate::axes::Axes>::RANK > 2 } {
            const $axis: usize = 2;
            $what;
        }
        if const { <$x as $crate::axes::Axes>::RANK > 3 } {
            const $axis: usize = 3;
            $what;
        }
    }};
}
pub(crate) use for_axes;

/// One value an axis, written out: no loop hides the places from the optimiser. What is `Copy` needs no code to drop it, should a call unwind.
#[inline(always)]
pub(crate) fn per_axis<T: Copy>(value: impl Fn(usize) -> T + Copy) -> [T; MAX_AXES] {
    [value(0), value(1), value(2), value(3)]
}

/// Offsets along the axes that there are, and none along the others that there could be. Slices' own copies are calls where the optimiser has
/// seen enough.
#[inline(always)]
pub(crate) fn padded<const N: usize>(offset: [i64; N]) -> [i64; MAX_AXES] {
    per_axis(
        #[inline(always)]
        |a| if a < N { offset[a] } else { 0 },
    )
}

/// Adds up one term an axis, unrolled: the rank is a constant.
#[inline(always)]
pub(crate) fn sum<X: Axes>(term: impl Fn(usize) -> usize + Copy) -> usize {
    let mut sum = term(0);
    if const { X::RANK > 1 } {
        sum = sum.wrapping_add(term(1));
    }
    if const { X::RANK > 2 } {
        sum = sum.wrapping_add(term(2));
    }
    if const { X::RANK > 3 } {
        sum = sum.wrapping_add(term(3));
    }
    sum
}

/// Whether a condition holds along every axis, unrolled.
#[inline(always)]
pub(crate) fn all<X: Axes>(holds: impl Fn(usize) -> bool + Copy) -> bool {
    // `&`, not `&&`: one branch on the whole.
    let mut all = holds(0);
    if const { X::RANK > 1 } {
        all &= holds(1);
    }
    if const { X::RANK > 2 } {
        all &= holds(2);
    }
    if const { X::RANK > 3 } {
        all &= holds(3);
    }
    all
}
