//! Where the elements of a field lie in memory.

mod spans;

use core::marker::PhantomData;
use core::ops::Range;

pub use spans::{Span, Standing};

use super::Field;
use super::sparse::branches;
use crate::axes::{Axes, MAX_AXES};
use crate::element::Kind;
use crate::layout::plan::Plan;
use crate::layout::{Brick, Geometry, Layout, Map};
use crate::record::{ElementList, MemberSpec, Names, Record};
use crate::store::Store;

/// Where the elements of a field lie in memory: for each element and member, its bytes, and what they are a part of. Made by
/// [`Field::memory_map`].
#[derive(Clone, Debug)]
pub struct MemoryMap<'a> {
    shape: Vec<usize>,
    geometry: Geometry,
    members: Vec<MapMember>,
    branches: Vec<Branch>,
    allocations: Vec<Allocation>,
    bytes: usize,
    /// What is active does not change meanwhile.
    field: PhantomData<&'a ()>,
}

/// A member of the records of a map.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MapMember {
    /// Its name, a path where it stands in a record in the record: `node.v`. That of a bare element is `0`.
    pub name: &'static str,
    /// The type of its components: `f32`.
    pub scalar: &'static str,
    /// Bytes of a component.
    pub scalar_bytes: usize,
    /// How many components it has.
    pub components: usize,
}

impl MapMember {
    fn of(name: &'static str, spec: &MemberSpec) -> Self {
        Self { name, scalar: spec.kind.name(), scalar_bytes: spec.scalar, components: spec.components }
    }

    /// Bytes of all components.
    pub fn bytes(&self) -> usize {
        self.components * self.scalar_bytes
    }
}

/// A piece of memory that holds elements: that of all dense branches, or a block of a sparse one.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Allocation {
    /// Where it begins, as a number.
    pub address: usize,
    /// Its bytes.
    pub bytes: usize,
    /// Of a block, its first index.
    pub block: Option<Vec<i32>>,
    /// The bytes of a block that hold its activity bits; empty where it has none.
    pub activity: Range<usize>,
    branch: usize,
    /// The first place of a block.
    first: [u64; MAX_AXES],
    entries: usize,
    bits: Vec<u64>,
}

/// A branch of the layout.
#[derive(Clone, Debug)]
struct Branch {
    plan: Plan,
    /// For each stream, the members in it and where they stand in its items.
    seats: Vec<Vec<(usize, usize)>>,
}

impl Branch {
    fn of(plan: Plan) -> Self {
        let streams = plan.streams;
        let seats = (0..streams.count).map(|stream| {
            let seated = streams.seats.iter().enumerate().filter(|(_, seat)| seat.stream == stream);
            let mut seats: Vec<(usize, usize)> = seated.map(|(member, seat)| (member, seat.offset)).collect();
            seats.sort_by_key(|&(_, offset)| offset);
            seats
        });
        Self { plan, seats: seats.collect() }
    }
}

impl MemoryMap<'_> {
    /// Elements along each axis of the field.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// The members of its records, in declared order.
    pub fn members(&self) -> &[MapMember] {
        &self.members
    }

    /// The memory that holds elements: first that of all dense branches, if there are some, then the blocks of the sparse ones, in the order of
    /// their trees.
    pub fn allocations(&self) -> &[Allocation] {
        &self.allocations
    }

    /// Whether memory follows what is active, for some members at least.
    pub fn is_sparse(&self) -> bool {
        self.branches.iter().any(|branch| branch.plan.chain.is_sparse())
    }

    /// All bytes of the field: as [`Field::bytes`].
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Bytes of the field that hold no elements: pointers to blocks, heads of lists, and blocks that are kept for later.
    pub fn overhead(&self) -> usize {
        self.bytes - self.allocations.iter().map(|allocation| allocation.bytes).sum::<usize>()
    }

    /// A map without the blocks of sparse branches; `dense` are address and bytes of the memory of the others.
    fn new(
        shape: &[usize],
        geometry: Geometry,
        (specs, names): (&[MemberSpec], &[&'static str]),
        plans: Vec<Plan>,
        bytes: usize,
        dense: (usize, usize),
    ) -> Self {
        let branches: Vec<Branch> = plans.into_iter().map(Branch::of).collect();
        let any_dense = branches.iter().any(|branch| !branch.plan.chain.is_sparse());
        Self {
            shape: shape.to_vec(),
            geometry,
            members: specs.iter().zip(names).map(|(spec, name)| MapMember::of(name, spec)).collect(),
            branches,
            allocations: any_dense.then(|| Allocation::dense(dense.0, dense.1)).into_iter().collect(),
            bytes,
            field: PhantomData,
        }
    }

    /// Notes a block.
    fn push(&mut self, branch: usize, brick: &Brick) {
        let Plan { chain, brick: (bytes, bits_at), .. } = self.branches[branch].plan;
        let first = core::array::from_fn(|a| u64::from(brick.block[a]) * chain.extent[a] as u64);
        let words = chain.bits().div_ceil(64);
        let word = |n: usize| {
            let (word, _) = Store::bit_of(brick.start, bits_at, 64 * n);
            word.load(core::sync::atomic::Ordering::Relaxed)
        };
        let logical = self.geometry.logical(first.map(|c| c as u32));
        self.allocations.push(Allocation {
            address: brick.start.expose_provenance(),
            bytes,
            block: Some(logical[..self.shape.len()].to_vec()),
            activity: bits_at..bits_at + words * 8,
            branch,
            first,
            entries: brick.entries,
            bits: (0..words).map(word).collect(),
        });
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Field<R, L, X> {
    /// Where each element lies in memory, member by member. Nothing is walked for it but the blocks of sparse branches.
    ///
    /// ```
    /// use allotrope::prelude::*;
    ///
    /// #[derive(Record, Clone, Copy)]
    /// struct Node { v: Vec2, m: f32 }
    ///
    /// let grid = Field::<Node, AoSoA<4>>::new([8]);
    /// let map = grid.memory_map();
    /// assert_eq!(map.allocations()[0].bytes, 2 * 4 * 12);
    ///
    /// // Four values of `v`, four of `m`, and so on.
    /// let third = map.spans().find(|span| span.index() == [2] && map.members()[span.member].name == "m").unwrap();
    /// assert_eq!(third.bytes, 40..44);
    ///
    /// // The second cache line alone: it costs no more where the field is large.
    /// let line: Vec<_> = map.spans_in(0, 64..128).map(|span| (span.index()[0], span.member)).collect();
    /// assert_eq!(line[..3], [(6, 0), (7, 0), (4, 1)]);
    /// ```
    pub fn memory_map(&self) -> MemoryMap<'_> {
        let handle = self.handle();
        let mut plans = Vec::new();
        Map::<R, L, X>::plans(&handle.geometry, 0, &mut plans);
        let dense = (self.storage.start().expose_provenance(), self.storage.memory_bytes());
        let names = (R::Elements::MEMBERS, Names::<R>::ALL);
        let mut map = MemoryMap::new(self.shape().as_ref(), handle.geometry, names, plans, self.bytes(), dense);
        if const { Map::<R, L, X>::any_sparse() } {
            let mut sparse: Vec<_> =
                branches::<R, L, X>().into_iter().map(|m| (Map::<R, L, X>::branch(m), m)).collect();
            sparse.sort_unstable();
            for (branch, m) in sparse {
                Map::<R, L, X>::walk(&handle.geometry, handle.store(m), m, &mut |brick| map.push(branch, &brick));
            }
        }
        map
    }
}

impl Allocation {
    /// The memory of dense branches.
    fn dense(address: usize, bytes: usize) -> Self {
        let (first, bits) = ([0; MAX_AXES], Vec::new());
        Self { address, bytes, block: None, activity: 0..0, branch: 0, first, entries: usize::MAX, bits }
    }
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::I8 => "i8",
            Self::I16 => "i16",
            Self::I32 => "i32",
            Self::I64 => "i64",
            Self::U8 => "u8",
            Self::U16 => "u16",
            Self::U32 => "u32",
            Self::U64 => "u64",
            Self::Bool => "bool",
        }
    }
}
