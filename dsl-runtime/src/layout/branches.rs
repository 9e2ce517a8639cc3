//! `+`: members under different nodes.

use super::{Chain, Layout};
use crate::axes::Axes;
use crate::element::Sealed;

/// `dense(ij).place([v]) + dense(ji).place([m])`: the branch `A`, a chain of nodes of its own, and the branches `B`. Each member
/// stands in one of them.
///
/// ```
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy)]
/// struct Node {
///     v: Vec2,
///     m: f32,
/// }
///
/// #[kernel]
/// fn advance(grid: &mut Field<Node, _, Ij>) {
///     for ij in grid.m.interior(1) {
///         grid.m[ij] += grid.v[ij].x;
///     }
/// }
///
/// let mut grid = Field::<Node, layout!(Node: dense(ij).place([v]) + dense(ji).dense(j, 8).place([m]))>::new([40, 50]);
/// advance(&mut grid);
/// ```
///
/// A loop names the branch by a member, since each has an order of its own. Without one, a kernel cannot be used with such a layout, which
/// its types do not tell before it is built:
///
/// ```compile_fail,E0080
/// use allotrope::prelude::*;
///
/// #[derive(Record, Clone, Copy)]
/// struct Node {
///     v: Vec2,
///     m: f32,
/// }
///
/// #[kernel]
/// fn halve(grid: &mut Field<Node, _, Ij>) {
///     for ij in grid {
///         grid.m[ij] *= 0.5;
///     }
/// }
///
/// halve(&mut Field::<Node, layout!(Node: dense(ij).place([v]) + dense(ji).place([m]))>::new([40, 50]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Both<A, B>(core::marker::PhantomData<fn() -> (A, B)>);

impl<A, B> Sealed for Both<A, B> {}
impl<A: Layout<X>, B: Layout<X>, X: Axes> Layout<X> for Both<A, B> {
    type Inner = A::Inner;
    type Rest = B;
    type Levels = A::Levels;
    type Corners = ();
    const BRANCHES: usize = {
        assert!(A::BRANCHES == 1, "branches nest to the right");
        1 + B::BRANCHES
    };
    const CHAIN: Chain = A::CHAIN;
}
