//! Updates that a job may not make where they belong, kept until no job runs.

use core::mem::{MaybeUninit, size_of};

use super::Scattered;
use crate::axes::MAX_AXES;
use crate::element::Element;
use crate::layout::Geometry;

/// Makes an update of the element at a place of the field at a root, by the value at an address.
pub(crate) type Apply = unsafe fn(*mut u8, &Geometry, [u32; MAX_AXES], *const u8);

/// Updates in the order in which they came.
#[derive(Debug, Default)]
pub(crate) struct Late {
    updates: Vec<Update>,
    values: Vec<MaybeUninit<u64>>,
}

#[derive(Debug)]
struct Update {
    apply: Apply,
    slot: usize,
    at: [u32; MAX_AXES],
    /// Where the value begins.
    value: usize,
}

impl Late {
    pub(crate) fn is_empty(&self) -> bool {
        self.updates.is_empty()
    }

    /// Keeps an update of the field of a slot.
    ///
    /// # Safety
    /// `apply` reads a `T`, and may be called with the root and geometry of that field when nothing else reaches it.
    pub(crate) unsafe fn push<T: Element>(&mut self, apply: Apply, slot: usize, at: [u32; MAX_AXES], value: T) {
        let start = self.values.len();
        self.values.resize(start + size_of::<T>().div_ceil(size_of::<u64>()), MaybeUninit::uninit());
        // SAFETY: as many bytes as the value has begin there.
        unsafe { self.values.as_mut_ptr().add(start).cast::<T>().write_unaligned(value) };
        self.updates.push(Update { apply, slot, at, value: start });
    }

    /// Makes all updates.
    ///
    /// # Safety
    /// Nothing else reaches the targets, which are those that the updates were kept for.
    pub(crate) unsafe fn apply(&self, targets: &[&dyn Scattered]) {
        for update in &self.updates {
            let (target, value) = (targets[update.slot], self.values[update.value..].as_ptr());
            // SAFETY: as promised when it was kept; the caller has the targets to itself.
            unsafe { (update.apply)(target.root(), target.geometry(), update.at, value.cast()) };
        }
    }
}
