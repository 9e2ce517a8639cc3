//! A field's bytes: zeroed, aligned to a cache line at least, freed on drop.

use core::ptr::NonNull;
use std::alloc::{Layout, alloc_zeroed, dealloc, handle_alloc_error};

/// Every field begins at a cache line.
pub(crate) const LINE: usize = 64;

/// What the system is asked for: with so small an alignment it hands out pages that are zero already, and maps them when
/// they are touched. The start is found within.
const ALIGN: usize = 16;

/// An owned, zeroed stretch of memory.
#[derive(Debug)]
pub(crate) struct Memory {
    /// What was allocated; `None` for no bytes.
    block: Option<(NonNull<u8>, Layout)>,
    start: NonNull<u8>,
    bytes: usize,
}

// SAFETY: `Memory` owns plain bytes; who may touch them when is settled by the borrow of the field that holds it.
unsafe impl Send for Memory {}
// SAFETY: as above; through `&Memory` nothing but the address can be had.
unsafe impl Sync for Memory {}

impl Memory {
    /// So many zeroed bytes from a multiple of `align`, a power of two, on; `None` where the system refuses them.
    pub(crate) fn zeroed(bytes: usize, align: usize) -> Option<Self> {
        if bytes == 0 {
            let start = NonNull::without_provenance(core::num::NonZero::new(align)?);
            return Some(Self { block: None, start, bytes });
        }
        let layout = Layout::from_size_align(bytes.checked_add(align)?, ALIGN).ok()?;
        // SAFETY: the size is not zero.
        let block = NonNull::new(unsafe { alloc_zeroed(layout) })?;
        let skip = block.as_ptr().align_offset(align);
        // SAFETY: `skip` is below `align`, which was asked for on top of `bytes`.
        let start = unsafe { block.add(skip) };
        Some(Self { block: Some((block, layout)), start, bytes })
    }

    /// As [`zeroed`](Self::zeroed); ends the program where the system refuses the bytes.
    pub(crate) fn zeroed_or_abort(bytes: usize, align: usize) -> Self {
        Self::zeroed(bytes, align).unwrap_or_else(|| {
            handle_alloc_error(Layout::from_size_align(bytes.min(isize::MAX as usize), 1).expect("a small alignment"))
        })
    }

    /// Where it begins.
    #[inline(always)]
    pub(crate) fn start(&self) -> *mut u8 {
        self.start.as_ptr()
    }

    /// How many bytes it has.
    pub(crate) fn bytes(&self) -> usize {
        self.bytes
    }

    /// The bytes, initialised as they are from the start.
    pub(crate) fn as_slice(&self) -> &[u8] {
        // SAFETY: all bytes were zeroed and are only ever overwritten; `&self` keeps them from being written meanwhile,
        // since every writer holds the field's `&mut`.
        unsafe { core::slice::from_raw_parts(self.start.as_ptr(), self.bytes) }
    }

    /// The bytes, to overwrite.
    pub(crate) fn as_mut_slice(&mut self) -> &mut [u8] {
        // SAFETY: as above, and `&mut self` is exclusive.
        unsafe { core::slice::from_raw_parts_mut(self.start.as_ptr(), self.bytes) }
    }
}

impl Drop for Memory {
    fn drop(&mut self) {
        if let Some((block, layout)) = self.block {
            // SAFETY: allocated in `zeroed` with this very layout.
            unsafe { dealloc(block.as_ptr(), layout) };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_zero_and_begins_where_it_is_asked_to() {
        for align in [64, 256, 4096] {
            let blocks: Vec<Memory> = (0..9).map(|n| Memory::zeroed(100 * n, align).expect("little memory")).collect();
            assert!(blocks.iter().all(|block| block.start().addr().is_multiple_of(align)));
            assert!(blocks.iter().all(|block| block.as_slice().iter().all(|&byte| byte == 0)));
        }
    }
}
