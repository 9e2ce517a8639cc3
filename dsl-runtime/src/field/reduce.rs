//! Reductions on the host side, in a fixed order.

use super::elements::Elements;
use super::parts::each_part;
use super::{Field, Handle, Member};
use crate::axes::Axes;
use crate::layout::Layout;
use crate::record::{Path, Record, Whole};

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// All records combined into one, in parallel; of a sparse field, those of the active elements.
    ///
    /// Parts of fixed size are combined from their first record on, in logical order, and then part after part,
    /// beginning with `identity`. So the result has the same bits for any number of threads and any layout. `combine`
    /// must be associative but for rounding; it need not be commutative.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// let mut u = Field::<f32, Blocked<8>>::new([300, 200]);
    /// u.fill(0.1);
    /// u.set([7, 9], 5.0);
    /// assert_eq!(u.reduce(0.0, f32::max), 5.0);
    /// let sum = |threads| Schedule { threads, ..Schedule::default() }.run(|| u.reduce(0.0, |a, b| a + b));
    /// assert_eq!(sum(1), sum(3));
    /// ```
    pub fn reduce(&self, identity: R, combine: impl Fn(R, R) -> R + Sync) -> R {
        reduce::<Whole, _, _, _, _>(&self.handle(), identity, |record| record, combine)
    }

    /// What `map` makes of the records, combined into one, in parallel. The order is that of [`reduce`](Self::reduce).
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// #[derive(Record, Clone, Copy)]
    /// struct Point {
    ///     velocity: Vec2,
    ///     mass: f32,
    /// }
    /// let mut points = Field::<Point, Soa>::new([10]);
    /// points.fill(Point { velocity: vec2(1.0, 2.0), mass: 0.5 });
    /// let momentum = points.map_reduce(|point| point.mass * point.velocity, Vec2::ZERO, |a, b| a + b);
    /// assert_eq!(momentum, vec2(5.0, 10.0));
    /// ```
    pub fn map_reduce<T: Send>(
        &self,
        map: impl Fn(R) -> T + Sync,
        identity: T,
        combine: impl Fn(T, T) -> T + Sync,
    ) -> T {
        reduce::<Whole, _, _, _, _>(&self.handle(), identity, map, combine)
    }
}

impl<R: Record, L: Layout<X>, X: Axes, P: Path<R>> Member<'_, R, L, X, P> {
    /// All values of the member combined into one, in parallel. The order is that of [`Field::reduce`].
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// #[derive(Record, Clone, Copy)]
    /// struct Node {
    ///     velocity: Vec2,
    ///     mass: f64,
    /// }
    /// let mut grid = Field::<Node, Soa>::new([4, 4]);
    /// grid.members_mut().mass.fill(0.5);
    /// assert_eq!(grid.members().mass.reduce(0.0, |a, b| a + b), 8.0);
    /// ```
    pub fn reduce(&self, identity: P::Value, combine: impl Fn(P::Value, P::Value) -> P::Value + Sync) -> P::Value {
        reduce::<P, _, _, _, _>(self.handle(), identity, |value| value, combine)
    }
}

fn reduce<P: Path<R>, R: Record, L: Layout<X>, X: Axes, T: Send>(
    handle: &Handle<'_, R, L, X>,
    identity: T,
    map: impl Fn(P::Value) -> T + Sync,
    combine: impl Fn(T, T) -> T + Sync,
) -> T {
    let elements = Elements::of::<P, R, L, X>(handle);
    let parts = each_part(elements.len(), |part| {
        // SAFETY: elements lie within the shape; whoever made the handle borrows the field, which keeps writers away.
        elements.part::<X>(part).map(|at| map(unsafe { handle.read::<P>(at) })).reduce(&combine)
    });
    parts.into_iter().flatten().fold(identity, combine)
}
