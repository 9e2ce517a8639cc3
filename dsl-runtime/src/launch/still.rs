//! Memory that a launch only reads, in a form that the optimiser understands: as references that a loop's body gets as arguments.
//!
//! What lies behind such an argument nothing that the body writes can be. Of addresses that a body finds in what it captures the optimiser does not know
//! that, and compares them before each row, or leaves loops scalar.

use core::marker::PhantomData;
use core::mem::MaybeUninit;

use crate::axes::Axes;
use crate::field::{Handle, Source};
use crate::layout::{Layout, Map};
use crate::record::Record;

/// The memory of a field; empty where it may be changed meanwhile, or lies in blocks.
pub(crate) type Memory<'a> = &'a [MaybeUninit<u8>];

/// Of so many fields bodies get the memory. The macro knows the number, too.
pub(crate) const MOST: usize = 4;

/// The memory of as many fields.
pub(crate) type All<'a> = [Memory<'a>; MOST];

/// A field that a loop only reads.
#[doc(hidden)]
pub struct Still<'a, S: ?Sized> {
    memory: Memory<'a>,
    of: PhantomData<fn(&S)>,
}

impl<S: ?Sized> Clone for Still<'_, S> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<S: ?Sized> Copy for Still<'_, S> {}
impl<S: ?Sized> core::fmt::Debug for Still<'_, S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Still({} bytes)", self.memory.len())
    }
}

/// A field that a loop only reads.
#[doc(hidden)]
#[inline(always)]
pub fn still<S: Source + ?Sized>(field: &S) -> Still<'_, S> {
    let memory = if const { Still::<S>::KNOWN } { memory(&field.handle()) } else { &[] };
    Still { memory, of: PhantomData }
}

impl<'a, S: Source + ?Sized> Still<'a, S> {
    /// Whether all of the memory is known to stay as it is.
    pub(crate) const KNOWN: bool = S::WHOLE && !Map::<S::Record, S::Layout, S::Axes>::any_sparse();

    /// The memory, where it is known.
    #[inline(always)]
    pub fn memory(self) -> Memory<'a> {
        self.memory
    }
}

#[inline(always)]
fn memory<'a, R: Record, L: Layout<X>, X: Axes>(handle: &Handle<'a, R, L, X>) -> Memory<'a> {
    // SAFETY: a dense field, or a slice, has so many bytes, which live as long as it is borrowed. All of it is borrowed shared, so that nobody writes to
    // them, and whoever reads them as bytes that may be uninitialised asks nothing of their values.
    unsafe { core::slice::from_raw_parts(handle.root.cast_const().cast(), handle.dense_bytes()) }
}

#[cfg(test)]
mod tests {
    use super::still;
    use crate::Field;
    use crate::layout::{Aos, Blocked, Soa, Sparse, Split};

    #[test]
    fn memory_is_known_where_all_of_it_is_borrowed_and_dense() {
        let field = Field::<f32, Blocked<4>>::new([8, 8]);
        assert_eq!(still(&field).memory().len(), 8 * 8 * 4);
        // A slice ends with its last element, a field behind it.
        assert_eq!(still(&[1.0f32; 5][..]).memory().len(), 20);
        assert_eq!(still(&Field::<[f32; 3], Aos>::new([5])).memory().len(), 60);
        assert_eq!(still(&Field::<[f32; 3], Soa>::new([5])).memory().len(), 60);
        // Each component's run is filled up to a line.
        assert_eq!(still(&Field::<[f32; 3], Split>::new([5])).memory().len(), 3 * 64);
        assert!(still(&Field::<f32, Sparse<4>>::new([8, 8])).memory().is_empty());
    }
}
