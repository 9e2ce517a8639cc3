//! Finding what has become NaN or infinite.

use core::fmt;
use core::sync::atomic::{AtomicUsize, Ordering};

use super::elements::Elements;
use super::parts::each_part;
use super::{Field, Handle};
use crate::axes::{Axes, MAX_AXES};
use crate::element::Kind;
use crate::index::IntoIndex;
use crate::layout::Layout;
use crate::record::{ElementList, Names, Record, Whole};

/// A number of a field that is NaN or infinite: [`Field::find_nonfinite`].
#[derive(Clone, Copy, Debug)]
pub struct NonFinite<X: Axes> {
    /// The element.
    pub index: X::Index,
    /// The member's name; `None` where the record is a bare element.
    pub member: Option<&'static str>,
    /// Which component of the member, 0 where it is a scalar; columns follow one another in matrices.
    pub component: usize,
    /// Its value: NaN, infinity or minus infinity.
    pub value: f64,
}

impl<X: Axes> fmt::Display for NonFinite<X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = &self.index.coordinates()[..X::RANK];
        match self.member {
            Some(name) => write!(f, "component {} of `{name}` at {at:?} is {}", self.component, self.value),
            None => write!(f, "component {} at {at:?} is {}", self.component, self.value),
        }
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// The first number that is NaN or infinite, in logical row-major order, at one element in the order of members
    /// and components; `None` where all are finite. Searches in parallel.
    ///
    /// A NaN that goes unnoticed spreads, and an index computed from it is 0: look for it every few steps.
    ///
    /// ```
    /// use allotrope::prelude::*;
    /// #[derive(Record, Clone, Copy, Default)]
    /// struct Node {
    ///     mass: f32,
    ///     velocity: Vec2,
    /// }
    /// let mut grid = Field::<Node, Blocked<4>>::new([10, 10]);
    /// assert!(grid.find_nonfinite().is_none());
    /// grid.set([3, 7], Node { mass: 1.0, velocity: vec2(2.0, f32::NAN) });
    /// let found = grid.find_nonfinite().expect("a NaN");
    /// assert_eq!((found.index, found.member, found.component), (ivec2(3, 7), Some("velocity"), 1));
    /// assert_eq!(found.to_string(), "component 1 of `velocity` at [3, 7] is NaN");
    /// ```
    pub fn find_nonfinite(&self) -> Option<NonFinite<X>> {
        let handle = self.handle();
        // The first part in which something was found: later ones need no search.
        let least = AtomicUsize::new(usize::MAX);
        let elements = Elements::of::<Whole, R, L, X>(&handle);
        let found = each_part(elements.len(), |part| {
            let first = part.start;
            if first > least.load(Ordering::Relaxed) {
                return None;
            }
            let found = elements.part::<X>(part).find_map(|at| nonfinite_at(&handle, at));
            if found.is_some() {
                least.fetch_min(first, Ordering::Relaxed);
            }
            found
        });
        found.into_iter().flatten().next()
    }
}

/// The first such number of an element within the shape.
fn nonfinite_at<R: Record, L: Layout<X>, X: Axes>(
    handle: &Handle<'_, R, L, X>,
    at: [u32; MAX_AXES],
) -> Option<NonFinite<X>> {
    for (m, spec) in R::Elements::MEMBERS.iter().enumerate() {
        if !matches!(spec.kind, Kind::F32 | Kind::F64) {
            continue;
        }
        let (first, distance) = handle.component(m, at);
        for component in 0..spec.components {
            let from = first.wrapping_add(component * distance);
            let value = match spec.kind {
                // SAFETY: a component of an element within the shape, of this type; the borrow keeps writers away.
                Kind::F32 => f64::from(unsafe { from.cast::<f32>().read_unaligned() }),
                // SAFETY: as above.
                _ => unsafe { from.cast::<f64>().read_unaligned() },
            };
            if !value.is_finite() {
                let index = X::index(handle.geometry.logical(at));
                let member = (!R::Elements::BARE).then(|| Names::<R>::ALL[m]);
                return Some(NonFinite { index, member, component, value });
            }
        }
    }
    None
}
