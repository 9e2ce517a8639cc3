//! `Row` and `Own`: paths at the elements of a run, whose addresses need no index.

use core::cell::{Cell, UnsafeCell};
use core::marker::PhantomData;
use core::mem::MaybeUninit;

use super::Site;
use super::probed::note;
use crate::axes::{Axes, MAX_AXES, for_axes, per_axis, sum};
use crate::element::Kind as ScalarKind;
use crate::field::Handle;
use crate::index::inside;
use crate::launch::{
    Cell as RunCell, Run, Space, any_in_blocks, apart, copies_rows, is_in_blocks, prefetch, stay_scalar,
};
use crate::layout::{Block, Chain, Geometry, Layout, Map};
use crate::probe::{Access, Index};
use crate::record::{ElementList, Path, Record};

/// The longest run whose writes are held back, and whose values are copied.
pub(crate) const HELD: usize = 64;
/// How far rows that are copied as a whole may be moved.
const AHEAD: i64 = 8;

/// Whose field a view is of: the macro tells, and a view of a sparse field checks it.
#[doc(hidden)]
pub trait Whose: Copy + 'static {
    /// Whether it is the one that the loop runs over.
    const LOOP: bool;
}
/// The field that the loop runs over.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct OfLoop;
/// Another field.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Other;
impl Whose for OfLoop {
    const LOOP: bool = true;
}
impl Whose for Other {
    const LOOP: bool = false;
}

/// How the elements of a run lie in a field.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// At equal distances.
    Even,
    /// In the field's own blocks, which are the loop's.
    Blocks,
    /// Anyhow: each address is computed from its index.
    Any,
}

/// Addresses of a path at the elements of a run, moved by a constant offset.
struct Line<'a, R, L, X, P, S, H> {
    handle: Handle<'a, R, L, X>,
    site: &'static Site,
    /// Element 0's address (`Even`), or that of its run's line in the block without the run axis' term (`Blocks`).
    start: *mut u8,
    offset: [i64; MAX_AXES],
    /// The run axis' place of element 0 in its block (`Blocks`).
    place: i64,
    fits: bool,
    /// Whether the loop's elements are some of the run's.
    masked: bool,
    /// The block that element 0 moved along the other axes than the run's lies in, and where that begins (sparse branches).
    block: Block,
    brick: Cell<*mut u8>,
    types: PhantomData<(P, S, H)>,
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>, S: Space, H: Whose> Line<'a, R, L, X, P, S, H> {
    const KIND: Kind = if P::MEMBER.is_none() || S::RANK != X::RANK {
        Kind::Any
    } else if Self::CHAIN.is_flat() {
        Kind::Even
    } else if is_in_blocks::<S>(Self::CHAIN) {
        Kind::Blocks
    } else {
        Kind::Any
    };
    const MEMBER: usize = match P::MEMBER {
        Some(m) => m,
        None => 0,
    };

    /// Whether its memory follows what is active.
    const SPARSE: bool = Map::<R, L, X>::is_sparse(Self::MEMBER);
    /// Whether the block of a run is the one that holds the run's elements of this member.
    const OF_LOOP: bool = H::LOOP && S::BRANCH == Map::<R, L, X>::branch(Self::MEMBER);
    /// The branch that the path's member stands in.
    const CHAIN: &'static Chain = Map::<R, L, X>::chain(Self::MEMBER);
    const STRIDE: usize = Map::<R, L, X>::stride(Self::MEMBER);
    const BLOCK_BYTES: usize = Map::<R, L, X>::block_bytes(Self::MEMBER);
    const COMPONENT: usize = Map::<R, L, X>::constant_component(Self::MEMBER);
    /// Whether other members lie between the values of neighbours, in rows of any length.
    const INTERLEAVED: bool = {
        let (seat, spec) = (Map::<R, L, X>::seat(Self::MEMBER), R::Elements::MEMBERS[Self::MEMBER]);
        matches!(Self::KIND, Kind::Even) && S::RUN == 0 && !seat.split && Self::STRIDE != spec.components * spec.scalar
    };

    #[inline(always)]
    fn component(&self) -> usize {
        if const { Self::COMPONENT == 0 } {
            Map::<R, L, X>::component(&self.handle.geometry, Self::MEMBER)
        } else {
            Self::COMPONENT
        }
    }

    /// Where the member would stand at index zero (`Even`). It is the same for all runs, so that the compiler takes it out of their loop.
    #[inline(always)]
    fn zero(geometry: &Geometry) -> usize {
        Map::<R, L, X>::start(geometry, Self::MEMBER).wrapping_sub(sum::<X>(
            #[inline(always)]
            |a| {
                let stride = Map::<R, L, X>::root_stride(geometry, Self::MEMBER, a);
                (geometry.origin[a] as usize).wrapping_mul(stride).wrapping_mul(Self::STRIDE)
            },
        ))
    }

    #[inline(always)]
    fn new(handle: Handle<'a, R, L, X>, site: &'static Site, run: &Run<'_, S>, offset: [i64; MAX_AXES]) -> Self {
        const { assert!(S::RANK == X::RANK, "rows are taken from fields with as many axes as the loop") }
        let geometry = &handle.geometry;
        if const { Self::SPARSE && matches!(Self::KIND, Kind::Blocks) } {
            return Self::in_brick(handle, site, run, offset);
        }
        let (from, moved) = if const { matches!(Self::KIND, Kind::Any) } {
            (0, 0)
        } else if const { matches!(Self::KIND, Kind::Even) } {
            let term = |a: usize, at: i64| {
                let stride = Map::<R, L, X>::root_stride(geometry, Self::MEMBER, a);
                (at as usize).wrapping_mul(stride).wrapping_mul(Self::STRIDE)
            };
            // Apart: where the run begins is the same for all of the member's lines, how far they are moved for all runs.
            let begin = sum::<X>(
                #[inline(always)]
                |a| term(a, run.at[a]),
            );
            let moved = sum::<X>(
                #[inline(always)]
                |a| term(a, offset[a]),
            );
            (Self::zero(geometry).wrapping_add(begin), moved)
        } else {
            // The launch has found that both fields have one origin.
            let from = Map::<R, L, X>::start(geometry, Self::MEMBER).wrapping_add(sum::<X>(
                #[inline(always)]
                |a| {
                    if a == S::AXIS {
                        let stride = Map::<R, L, X>::root_stride(geometry, Self::MEMBER, a);
                        run.block[a].wrapping_mul(stride).wrapping_mul(Self::BLOCK_BYTES)
                    } else {
                        Self::block_term(&handle, a, run.block[a], run.inner[a] as i64 + offset[a])
                    }
                },
            ));
            (from, 0)
        };
        let (start, place) = (handle.root.wrapping_add(from).wrapping_add(moved), run.inner[S::AXIS] as i64);
        let (block, brick) = ([0; MAX_AXES], Cell::new(core::ptr::null_mut()));
        Self {
            handle,
            site,
            start,
            offset,
            place,
            fits: run.fits,
            masked: run.mask.is_some(),
            block,
            brick,
            types: PhantomData,
        }
    }

    /// The same in a sparse branch, whose blocks are arranged as those of the loop's field. The block is looked up once for the run.
    #[inline(always)]
    fn in_brick(handle: Handle<'a, R, L, X>, site: &'static Site, run: &Run<'_, S>, offset: [i64; MAX_AXES]) -> Self {
        let extent = |a: usize| const { Self::CHAIN.extent }[a] as i64;
        // Along most axes nothing moves, which is known where this is compiled.
        let moved = |a: usize| a != S::AXIS && offset[a] != 0;
        let (mut block, mut inner, mut same) = ([0; MAX_AXES], run.inner, true);
        for a in 0..X::RANK {
            block[a] = run.block[a] as u32;
            if moved(a) {
                let c = run.inner[a] as i64 + offset[a];
                let over = c.div_euclid(extent(a));
                inner[a] = c.rem_euclid(extent(a)) as usize;
                block[a] = block[a].wrapping_add(over as u32);
                same &= over == 0;
            }
        }
        let from = Map::<R, L, X>::start(&handle.geometry, Self::MEMBER).wrapping_add(sum::<X>(
            #[inline(always)]
            |a| Map::<R, L, X>::inner(Self::MEMBER, a, if a == S::AXIS { 0 } else { inner[a] }),
        ));
        assert!(!Self::OF_LOOP || core::ptr::eq(run.root, handle.root), "the loop runs over this field");
        let brick = if !run.fits {
            core::ptr::null_mut()
        } else if Self::OF_LOOP && same {
            run.brick
        } else {
            handle.brick(Self::MEMBER, &block)
        };
        if let (true, false, Some(next)) = (Self::OF_LOOP, same, run.next) {
            let next = per_axis(
                #[inline(always)]
                |a| (next[a] as u32).wrapping_add(block[a]).wrapping_sub(run.block[a] as u32),
            );
            prefetch(handle.brick(Self::MEMBER, &next).wrapping_add(from));
        }
        Self {
            handle,
            site,
            start: core::ptr::null_mut::<u8>().wrapping_add(from),
            offset,
            place: run.inner[S::AXIS] as i64,
            fits: run.fits,
            masked: run.mask.is_some(),
            block,
            brick: Cell::new(brick),
            types: PhantomData,
        }
    }

    /// The block of a cell, the cell's place along the run's axis in it, and where the block begins (sparse branches).
    #[inline(always)]
    fn block_of(&self, cell: &RunCell<'_, S>) -> (Block, i64, *mut u8) {
        let along = self.place + cell.k as i64 + self.offset[S::AXIS];
        let extent = const { Self::CHAIN.extent[S::AXIS] } as i64;
        if cell.inside {
            return (self.block, along, self.brick.get());
        }
        let over = along.div_euclid(extent);
        if over == 0 {
            return (self.block, along, self.brick.get());
        }
        let block = per_axis(
            #[inline(always)]
            |a| if a == S::AXIS { self.block[a].wrapping_add(over as u32) } else { self.block[a] },
        );
        (block, along.rem_euclid(extent), self.handle.brick(Self::MEMBER, &block))
    }

    /// The address of a cell whose block begins there.
    #[inline(always)]
    fn in_block(&self, cell: &RunCell<'_, S>, along: i64, brick: *mut u8) -> *mut u8 {
        let term = if cell.inside {
            // One stride an element: a run is a row of its block.
            Map::<R, L, X>::inner(Self::MEMBER, S::AXIS, self.place as usize)
                .wrapping_add(((along - self.place) as usize).wrapping_mul(Self::STRIDE))
        } else {
            Map::<R, L, X>::inner(Self::MEMBER, S::AXIS, along as usize)
        };
        brick.wrapping_add(self.start.addr()).wrapping_add(term)
    }

    /// Whether rows may be copied: those that lead into other blocks along the run's axis, and all where the loop's elements are some of the run's.
    const COPIED: bool = copies_rows::<S>() && matches!(Self::KIND, Kind::Blocks);

    /// Whether it holds floats side by side in whole rows of blocks: what is computed for all of them becomes vectors.
    const FLOATS: bool = {
        let spec = R::Elements::MEMBERS[Self::MEMBER];
        matches!(Self::KIND, Kind::Blocks)
            && matches!(spec.kind, ScalarKind::F32 | ScalarKind::F64)
            && Self::STRIDE == spec.scalar
    };

    /// Whether this row is copied.
    #[inline(always)]
    fn is_copied(&self) -> bool {
        Self::COPIED && (self.offset[S::AXIS] != 0 || self.masked) && self.fits
    }

    /// Copies the values of a run's elements.
    #[inline(always)]
    fn copy(&self, run: &Run<'_, S>, buffer: &Buffer<List<R, P>>) {
        let (by, extent) = (self.offset[S::AXIS], const { Self::CHAIN.extent[S::AXIS] } as i64);
        let (first, end) = (run.first as i64, (run.first + run.len) as i64);
        let own = if const { S::RUN == Self::CHAIN.extent[S::AXIS] } && by.abs() <= AHEAD {
            // The row of its own block is copied as a whole, in steps that are known where this is compiled: what stores write in
            // parts is slow to be read.
            for c in 0..S::RUN as i64 {
                self.put(run, buffer, c - by, true);
            }
            -by..extent - by
        } else {
            let own = -(self.place + by)..extent - self.place - by;
            for k in own.start.max(first)..own.end.min(end) {
                self.put(run, buffer, k, false);
            }
            own
        };
        // What lies in other blocks is a value or two at an end, if the run comes so far.
        for k in first..own.start.min(end) {
            self.put_wanted(run, buffer, k);
        }
        for k in own.end.max(first)..end {
            self.put_wanted(run, buffer, k);
        }
    }

    /// Copies the value of element `k` of a run, if it is the loop's. No closure asks, as that of an iterator's filter: where the optimiser leaves one a
    /// call, it no longer knows what it knew of the run.
    #[inline(always)]
    fn put_wanted(&self, run: &Run<'_, S>, buffer: &Buffer<List<R, P>>, k: i64) {
        if run.mask.is_none_or(|mask| mask.has::<S>(k as usize)) {
            self.put(run, buffer, k, false);
        }
    }

    /// Copies the value of element `k` of a run.
    #[inline(always)]
    fn put(&self, run: &Run<'_, S>, buffer: &Buffer<List<R, P>>, k: i64, inside: bool) {
        let cell = RunCell { run, k: k as usize, slot: 0, inside, chosen: true };
        buffer.put((k + AHEAD) as usize, self.value(&cell));
    }

    /// What a cell's value is made of, where the launch has checked the box.
    #[inline(always)]
    fn value(&self, cell: &RunCell<'_, S>) -> List<R, P> {
        // SAFETY: `fits`, and the cell is one of the run's.
        let (address, component) = (unsafe { self.address(cell) }, self.component());
        // The compiler would load what lies between a row and a value of another block too, and throw it away.
        let address = if cell.inside { address } else { apart(address) };
        // SAFETY: as in `get`.
        unsafe {
            P::gather(
                #[inline(always)]
                |_| (address, component),
            )
        }
        .into_elements()
    }

    /// Makes a cell active that the loop does not run over (sparse branches).
    #[inline(always)]
    fn activate(&self, cell: &RunCell<'_, S>) {
        let (block, along, _) = self.block_of(cell);
        let inner = per_axis(
            #[inline(always)]
            |a| if a == S::AXIS { along as u32 } else { cell.run.inner[a] as u32 },
        );
        self.brick.set(self.handle.touch(Self::MEMBER, &block, &inner));
    }

    /// What place `c` within block `block` along an axis adds to an address; places below zero and beyond the extent are
    /// those of neighbouring blocks.
    #[inline(always)]
    fn block_term(handle: &Handle<'a, R, L, X>, axis: usize, block: usize, c: i64) -> usize {
        let extent = const { &Self::CHAIN.extent }[axis] as i64;
        let (over, place) = (c.div_euclid(extent), c.rem_euclid(extent));
        block
            .wrapping_add(over as usize)
            .wrapping_mul(Map::<R, L, X>::root_stride(&handle.geometry, Self::MEMBER, axis))
            .wrapping_mul(Self::BLOCK_BYTES)
            .wrapping_add(Map::<R, L, X>::inner(Self::MEMBER, axis, place as usize))
    }

    /// The address of a cell (`Even` and `Blocks`).
    ///
    /// # Safety
    /// The loop's box with this offset lies within the shape (`fits`), and the cell is of the run of this line.
    #[inline(always)]
    unsafe fn address(&self, cell: &RunCell<'_, S>) -> *mut u8 {
        let geometry = &self.handle.geometry;
        if const { matches!(Self::KIND, Kind::Even) } {
            let step = Map::<R, L, X>::root_stride(geometry, Self::MEMBER, S::AXIS);
            let bytes = cell.k.wrapping_mul(step.wrapping_mul(Self::STRIDE));
            if const { S::RUN == 0 } {
                // SAFETY: element 0 is visited too, so that it and the cell both lie in the field's memory.
                unsafe { self.start.add(bytes) }
            } else {
                // Element 0 of a cut run may lie outside.
                self.start.wrapping_add(bytes)
            }
        } else if const { matches!(Self::KIND, Kind::Any) } {
            self.start
        } else if const { Self::SPARSE } {
            let (_, along, brick) = self.block_of(cell);
            self.in_block(cell, along, brick)
        } else {
            let along = self.offset[S::AXIS];
            let term = if cell.inside {
                Map::<R, L, X>::inner(Self::MEMBER, S::AXIS, self.place as usize)
                    .wrapping_add(((cell.k as i64 + along) as usize).wrapping_mul(Self::STRIDE))
            } else {
                Self::block_term(&self.handle, S::AXIS, 0, self.place + cell.k as i64 + along)
            };
            self.start.wrapping_add(term)
        }
    }

    /// The place of a cell, moved by the offset, where it lies within the shape.
    #[inline(always)]
    #[track_caller]
    fn checked(&self, cell: &RunCell<'_, S>) -> [u32; MAX_AXES] {
        if self.fits && const { any_in_blocks::<S, L, X>() } {
            // Both fields have one origin, and so the same places.
            let (place, mut moved) = (cell.place(), [0; MAX_AXES]);
            for_axes!(X, A => moved[A] = place[A].wrapping_add(self.offset[A]) as u32);
            return moved;
        }
        let (at, geometry) = (cell.at(), &self.handle.geometry);
        if self.fits {
            // The launch has compared the loop's box with the shape.
            let mut place = [0; MAX_AXES];
            for_axes!(X, A => place[A] = at[A].wrapping_add(self.offset[A]).wrapping_sub(geometry.origin[A].into()) as u32);
            return place;
        }
        let mut place = [0; MAX_AXES];
        for_axes!(X, A => place[A] = at[A].saturating_add(self.offset[A].saturating_sub(geometry.origin[A].into())));
        let Some(place) = inside::<X>(place, &geometry.shape) else {
            self.site.out_of_range::<X>(per_axis(|a| place[a].saturating_add(i64::from(geometry.origin[a]))), geometry)
        };
        place
    }

    /// Tells a recording of an access that the kernel makes at a cell.
    #[inline(always)]
    fn note(&self, cell: &RunCell<'_, S>, access: Access) {
        let index = if self.offset == [0; MAX_AXES] { Index::Own } else { Index::Offset };
        if cell.chosen {
            note::<R, L, X, P>(&self.handle, self.site, || self.checked(cell), access, index);
        }
    }

    #[inline(always)]
    #[track_caller]
    fn get(&self, cell: &RunCell<'_, S>) -> P::Value {
        if const { matches!(Self::KIND, Kind::Any) } || !self.fits {
            let at = self.checked(cell);
            // SAFETY: `checked` returns places within the shape; who else may touch them is the view's promise.
            return unsafe { self.handle.read::<P>(at) };
        }
        // SAFETY: `fits`, and the macro hands a line the cells of its run alone.
        let (address, component) = (unsafe { self.address(cell) }, self.component());
        // SAFETY: the launch found that the loop's box with this offset lies within the shape, so the address is that of
        // a component of an element; who else may touch it is the view's promise.
        unsafe {
            P::gather(
                #[inline(always)]
                |_| (address, component),
            )
        }
    }

    /// Writes a path at a cell.
    ///
    /// # Safety
    /// Nobody else touches the path at this cell during the launch.
    #[inline(always)]
    #[track_caller]
    unsafe fn set(&self, cell: &RunCell<'_, S>, value: P::Value) {
        if const { matches!(Self::KIND, Kind::Any) } || !self.fits {
            let at = self.checked(cell);
            // SAFETY: `checked` returns places within the shape; the caller has the element.
            return unsafe { self.handle.write::<P>(at, value) };
        }
        if const { Self::SPARSE && !Self::OF_LOOP } {
            self.activate(cell);
        }
        if const { Self::INTERLEAVED } {
            // With AVX-512 the stores would be scattered, at several times the cost of scalar ones.
            stay_scalar();
        }
        // SAFETY: as in `get`.
        let (address, component) = (unsafe { self.address(cell) }, self.component());
        // SAFETY: as in `get`; the caller has the element.
        unsafe {
            P::scatter(
                value,
                #[inline(always)]
                |_| (address, component),
            )
        }
    }
}

/// Reads a path at the elements of a run, moved by a constant offset. Nothing in the loop writes it.
#[doc(hidden)]
pub struct Row<'a, 'b, R: Record, L, X, P: Path<R>, S, H> {
    line: Line<'a, R, L, X, P, S, H>,
    copy: &'b Buffer<List<R, P>>,
}

impl<R: Record, L, X, P: Path<R>, S, H> core::fmt::Debug for Row<'_, '_, R, L, X, P, S, H> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Row of `{}`", self.line.site.field)
    }
}

impl<'a, 'b, R: Record, L: Layout<X>, X: Axes, P: Path<R>, S: Space, H: Whose> Row<'a, 'b, R, L, X, P, S, H> {
    #[inline(always)]
    pub(super) fn new(
        handle: Handle<'a, R, L, X>,
        site: &'static Site,
        run: &Run<'_, S>,
        offset: [i64; MAX_AXES],
        copy: &'b Buffer<List<R, P>>,
    ) -> Self {
        let line = Line::<'a, R, L, X, P, S, H>::new(handle, site, run, offset);
        if const { Line::<'static, R, L, X, P, S, H>::COPIED } && line.is_copied() {
            line.copy(run, copy);
        }
        Self { line, copy }
    }

    /// Whether it may be read for all elements of a run, and holds floats.
    #[inline(always)]
    pub fn is_float(&self) -> bool {
        Line::<'static, R, L, X, P, S, H>::FLOATS && self.line.is_copied()
    }

    /// The value at a cell.
    ///
    /// # Panics
    /// Where it lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, cell: &RunCell<'_, S>) -> P::Value {
        self.line.note(cell, Access::Read);
        if const { Line::<'static, R, L, X, P, S, H>::COPIED } && self.line.is_copied() {
            // SAFETY: `new` has copied the values of the run, of which the cell is.
            return P::Value::from_elements(unsafe { self.copy.take(cell.k + AHEAD as usize) });
        }
        self.line.get(cell)
    }
}

/// Reads and writes a path at a run's own elements, which no other iteration touches.
#[doc(hidden)]
pub struct Own<'a, R, L, X, P, S, H>(Line<'a, R, L, X, P, S, H>);

impl<R, L, X, P, S, H> core::fmt::Debug for Own<'_, R, L, X, P, S, H> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Own of `{}`", self.0.site.field)
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes, P: Path<R>, S: Space, H: Whose> Own<'a, R, L, X, P, S, H> {
    #[inline(always)]
    pub(super) fn new(handle: Handle<'a, R, L, X>, site: &'static Site, run: &Run<'_, S>) -> Self {
        Self(Line::new(handle, site, run, [0; MAX_AXES]))
    }

    /// Whether it may be computed for all elements of a run, and holds floats.
    #[inline(always)]
    pub fn is_float(&self) -> bool {
        type Of<R, L, X, P, S, H> = Line<'static, R, L, X, P, S, H>;
        Of::<R, L, X, P, S, H>::FLOATS && (Of::<R, L, X, P, S, H>::OF_LOOP || !Of::<R, L, X, P, S, H>::SPARSE)
    }

    /// The value at a cell.
    ///
    /// # Panics
    /// Where it lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, cell: &RunCell<'_, S>) -> P::Value {
        self.0.note(cell, Access::Read);
        self.0.get(cell)
    }

    /// Puts a value at a cell.
    ///
    /// # Panics
    /// Where it lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn set(&self, cell: &RunCell<'_, S>, value: P::Value) {
        let value = if cell.chosen { value } else { self.0.get(cell) };
        // SAFETY: the cell is a run's element, which one thread visits once, and the macro gives a path that is written
        // no other view; nobody else touches those of the run that are not the loop's, which keep their values.
        unsafe { self.0.set(cell, value) };
        self.0.note(cell, Access::Write);
    }
}

/// What is written to a short run before it is stored at once: reads of other rows cannot alias it. A local of its own,
/// so that it becomes registers.
#[doc(hidden)]
pub struct Buffer<T>(UnsafeCell<[MaybeUninit<T>; HELD + 2 * AHEAD as usize]>);

impl<T> core::fmt::Debug for Buffer<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Buffer")
    }
}

/// A buffer for [`View::held`](super::View::held).
#[doc(hidden)]
#[inline(always)]
pub fn buffer<T: Copy>() -> Buffer<T> {
    Buffer(UnsafeCell::new([const { MaybeUninit::uninit() }; HELD + 2 * AHEAD as usize]))
}

impl<T: Copy> Buffer<T> {
    #[inline(always)]
    fn put(&self, k: usize, value: T) {
        // SAFETY: `Buffer` is not `Sync`, and no reference to its contents outlives a call.
        unsafe { (&mut *self.0.get())[k].write(value) };
    }

    /// # Safety
    /// Value `k` has been put.
    #[inline(always)]
    unsafe fn take(&self, k: usize) -> T {
        // SAFETY: as in `put`; the caller promises that the value is there.
        unsafe { (&*self.0.get())[k].assume_init() }
    }
}

/// What a value is made of: whoever implements `Record` says how, and bytes of a field are a list, never the value itself.
type List<R, P> = <<P as Path<R>>::Value as Record>::Elements;

/// As [`Own`]; what is written to whole runs of blocks waits in a buffer for [`flush`](Held::flush).
#[doc(hidden)]
pub struct Held<'a, 'b, R: Record, L, X, P: Path<R>, S, H> {
    line: Line<'a, R, L, X, P, S, H>,
    buffer: &'b Buffer<List<R, P>>,
}

impl<R: Record, L, X, P: Path<R>, S, H> core::fmt::Debug for Held<'_, '_, R, L, X, P, S, H> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Held of `{}`", self.line.site.field)
    }
}

impl<'a, 'b, R: Record, L: Layout<X>, X: Axes, P: Path<R>, S: Space, H: Whose> Held<'a, 'b, R, L, X, P, S, H> {
    /// Whether whole runs are held back.
    const HOLDS: bool = S::RUN > 0
        && S::RUN <= HELD
        && matches!(Line::<'static, R, L, X, P, S, H>::KIND, Kind::Blocks)
        && (Line::<'static, R, L, X, P, S, H>::OF_LOOP || !Line::<'static, R, L, X, P, S, H>::SPARSE);
    #[inline(always)]
    pub(super) fn new(
        handle: Handle<'a, R, L, X>,
        site: &'static Site,
        run: &Run<'_, S>,
        buffer: &'b Buffer<List<R, P>>,
    ) -> Self {
        let this = Self { line: Line::new(handle, site, run, [0; MAX_AXES]), buffer };
        if const { Self::HOLDS } && this.holds(run) {
            // One by one: values that are copied as bytes never become registers.
            for k in 0..S::RUN {
                buffer.put(k, this.line.get(&run.cell(k, true)).into_elements());
            }
        }
        this
    }

    /// Whether it may be computed for all elements of a run, and holds floats.
    #[inline(always)]
    pub fn is_float(&self) -> bool {
        Self::HOLDS && Line::<'static, R, L, X, P, S, H>::FLOATS
    }

    #[inline(always)]
    fn holds(&self, run: &Run<'_, S>) -> bool {
        Self::HOLDS && (run.whole || run.mask.is_some()) && self.line.fits
    }

    /// The value at a cell.
    ///
    /// # Panics
    /// Where it lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn get(&self, cell: &RunCell<'_, S>) -> P::Value {
        self.line.note(cell, Access::Read);
        if const { Self::HOLDS } && self.holds(cell.run) {
            // SAFETY: `new` has put all values of a whole run.
            return P::Value::from_elements(unsafe { self.buffer.take(cell.slot) });
        }
        self.line.get(cell)
    }

    /// Puts a value at a cell.
    ///
    /// # Panics
    /// Where it lies outside of the shape.
    #[inline(always)]
    #[track_caller]
    pub fn set(&self, cell: &RunCell<'_, S>, value: P::Value) {
        self.line.note(cell, Access::Write);
        if const { Self::HOLDS } && self.holds(cell.run) {
            self.buffer.put(cell.slot, value.into_elements());
            return;
        }
        // SAFETY: the cell is a run's element, which one thread visits once, and the macro gives a path that is written
        // no other view.
        unsafe { self.line.set(cell, value) };
    }

    /// Stores what was held back.
    #[inline(always)]
    pub fn flush(&self, run: &Run<'_, S>) {
        if const { !Self::HOLDS } || !self.holds(run) {
            return;
        }
        for k in 0..S::RUN {
            let cell = run.cell(k, true);
            // SAFETY: `new` has put all values of a whole run.
            let mut value = unsafe { self.buffer.take(k) };
            if let Some(mask) = run.mask {
                // Both are there before one is chosen: a load under a condition would keep the compiler from vectors.
                let old = self.line.get(&cell).into_elements();
                value = if mask.has::<S>(k) { value } else { old };
            }
            // SAFETY: the elements are this thread's own; nobody else touches those of the run that are not the loop's, which keep their
            // values.
            unsafe { self.line.set(&cell, P::Value::from_elements(value)) };
        }
    }
}
