//! What a field owns: the memory of its dense branches, and the stores of its sparse ones.

use super::memory::Memory;
use crate::axes::Axes;
use crate::layout::{Geometry, Layout, Map};
use crate::record::Record;
use crate::store::Store;

/// A field's memory, in which the addresses of its stores stand where their branches begin.
#[derive(Debug)]
pub struct Storage {
    memory: Memory,
    #[allow(clippy::vec_box, reason = "their addresses stand in the memory")]
    stores: Vec<Box<Store>>,
}

impl Storage {
    /// Storage full of zeros, its sparse branches empty; `None` where the system refuses the memory.
    pub(crate) fn new<R: Record, L: Layout<X>, X: Axes>(geometry: &Geometry) -> Option<Self> {
        let memory = Memory::zeroed(Map::<R, L, X>::bytes(geometry)?, Map::<R, L, X>::LINE)?;
        let mut stores = Vec::new();
        Map::<R, L, X>::stores(geometry, 0, &mut stores)?;
        Some(Self::with(memory, stores))
    }

    /// The same; ends the program where the system refuses the memory.
    pub(crate) fn new_or_abort<R: Record, L: Layout<X>, X: Axes>(geometry: &Geometry) -> Self {
        Self::new::<R, L, X>(geometry).unwrap_or_else(|| {
            let bytes = Map::<R, L, X>::bytes(geometry).unwrap_or(usize::MAX).min(isize::MAX as usize);
            std::alloc::handle_alloc_error(std::alloc::Layout::from_size_align(bytes, 1).expect("a small alignment"))
        })
    }

    fn with(memory: Memory, stores: Vec<(usize, Box<Store>)>) -> Self {
        for (at, store) in &stores {
            assert!(at + size_of::<*const Store>() <= memory.bytes());
            // SAFETY: within the memory, where the branch has a line of its own for it.
            unsafe { memory.start().add(*at).cast::<*const Store>().write(&raw const **store) };
        }
        Self { memory, stores: stores.into_iter().map(|(_, store)| store).collect() }
    }

    /// Where the memory begins.
    #[inline(always)]
    pub(crate) fn start(&self) -> *mut u8 {
        self.memory.start()
    }

    /// Bytes that hold the elements.
    pub(crate) fn bytes(&self) -> usize {
        let stores: usize = self.stores.iter().map(|store| store.bytes()).sum();
        // Of a sparse branch the memory holds an address alone.
        self.memory.bytes() + stores
    }

    /// Bytes of the memory of dense branches; of a sparse branch it holds an address.
    pub(crate) fn memory_bytes(&self) -> usize {
        self.memory.bytes()
    }

    /// Frees what no loop can be using any more.
    #[inline(always)]
    pub(crate) fn settle(&mut self) {
        for store in &mut self.stores {
            store.settle();
        }
    }

    /// The memory of a field without sparse branches.
    pub(crate) fn dense(&self) -> &[u8] {
        assert!(self.stores.is_empty());
        self.memory.as_slice()
    }

    /// The memory of a field without sparse branches, to change.
    pub(crate) fn dense_mut(&mut self) -> &mut [u8] {
        assert!(self.stores.is_empty());
        self.memory.as_mut_slice()
    }

    /// The store of a sparse branch, to change.
    pub(crate) fn store_mut(&mut self, branch: usize) -> &mut Store {
        &mut self.stores[branch]
    }

    /// The stores, to change.
    pub(crate) fn stores_mut(&mut self) -> impl Iterator<Item = &mut Store> {
        self.stores.iter_mut().map(|store| &mut **store)
    }
}
