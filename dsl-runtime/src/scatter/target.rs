//! A field that a loop accumulates into, without its types.

use core::sync::atomic::Ordering;
use std::sync::PoisonError;

use super::combine::{Line, Op, combine_line, set_line};
use crate::axes::{Axes, MAX_AXES};
use crate::field::Handle;
use crate::field::Storage;
use crate::launch::run_jobs;
use crate::layout::{Geometry, Layout, Map};
use crate::record::{ElementList, Record};
use crate::store::Store;
use crate::view::View;

/// A field that a loop accumulates into.
#[doc(hidden)]
pub trait Scattered: Sync {
    /// Its own memory.
    fn root(&self) -> *mut u8;
    /// Its geometry.
    fn geometry(&self) -> &Geometry;
    /// How many axes it has.
    fn rank(&self) -> usize;
    /// Cells of a block of the first accumulated member's branch along each axis.
    fn block(&self) -> [u32; MAX_AXES];
    /// The bytes of a copy.
    fn bytes(&self) -> usize;
    /// Its elements.
    fn cells(&self) -> usize;
    /// Whether every accumulated component lies at a multiple of its size.
    fn aligned(&self) -> bool;
    /// A copy full of the operators' identities.
    fn borrow_copy(&self) -> Storage;
    /// Takes a copy back that is full of identities again.
    fn give_back(&self, copy: Storage);
    /// Into how many parts the field is cut for combination.
    fn parts(&self) -> usize;
    /// Combines one part of a copy into the field and fills that part with identities.
    ///
    /// # Safety
    /// The caller has that part of the field and of the copy to itself.
    unsafe fn combine(&self, copy: &Storage, part: usize);
    /// Combines the blocks of a copy's sparse branches into the field, and takes them out of the copy.
    fn combine_blocks(&self, copy: &mut Storage, threads: usize);
}

/// A field, and the members that a loop accumulates into with their operators.
#[doc(hidden)]
pub struct Target<'a, 'b, R, L, X> {
    handle: Handle<'a, R, L, X>,
    members: &'b [(usize, Op)],
}

impl<R, L, X> core::fmt::Debug for Target<'_, '_, R, L, X> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Target({:?})", self.members)
    }
}

impl<'a, R: Record, L: Layout<X>, X: Axes> View<'a, R, L, X, true> {
    /// This field as a target; `members` are those that the loop accumulates into.
    pub fn target<'b>(self, _slot: usize, members: &'b [(usize, Op)]) -> Target<'a, 'b, R, L, X> {
        Target { handle: self.handle, members }
    }
}

/// Cells of a part.
const PART: usize = 1 << 13;
/// Blocks of a sparse branch that a job combines.
const BLOCKS: usize = 16;

impl<R: Record, L: Layout<X>, X: Axes> Target<'_, '_, R, L, X> {
    /// Leaves of a member's branch, its innermost nodes or the whole flat root, and the cells of each.
    fn leaves(&self, member: usize) -> (usize, usize) {
        let cells = Map::<R, L, X>::geometry(&self.handle.geometry, member).cells;
        match Map::<R, L, X>::chain(member) {
            chain if chain.is_flat() => (1, cells),
            chain => (cells * (chain.cells / chain.leaf), chain.leaf),
        }
    }

    /// Into how many parts a member's branch is cut.
    fn parts_of(&self, member: usize) -> usize {
        if Map::<R, L, X>::is_sparse(member) {
            return 0;
        }
        let (leaves, cells) = self.leaves(member);
        let flat = Map::<R, L, X>::chain(member).is_flat();
        if flat { cells.div_ceil(PART) } else { leaves.div_ceil((PART / cells).max(1)) }
    }

    /// The scalars' kind and operator, if they are the same for all of the memory: it is then one line.
    fn uniform(&self) -> Option<(crate::element::Kind, Op, usize)> {
        let all = R::Elements::MEMBERS;
        let (first, op) = (all[0], self.members.first()?.1);
        let same = const { !Map::<R, L, X>::any_sparse() }
            && self.members.len() == all.len()
            && all.iter().all(|m| m.kind == first.kind)
            && self.members.iter().all(|&(_, other)| other == op);
        same.then_some((first.kind, op, first.scalar))
    }

    /// The scalars of a memory that is one line. A slice ends with its last element, a field somewhere behind it.
    fn scalars(&self, scalar: usize) -> usize {
        self.handle.dense_bytes() / scalar
    }

    /// A block of the sparse branch that a member stands in as one line, if the scalars' kind and operator are the same for all of it.
    fn uniform_block(&self, branch_of: usize) -> Option<Line> {
        let here = |m: usize| Map::<R, L, X>::branch(m) == Map::<R, L, X>::branch(branch_of);
        let &(first, op) = self.members.iter().find(|&&(m, _)| here(m))?;
        let (all, first) = (R::Elements::MEMBERS, R::Elements::MEMBERS[first]);
        let same = |m: usize| all[m].kind == first.kind && self.members.contains(&(m, op));
        let count = Map::<R, L, X>::block_bytes(branch_of) / first.scalar;
        let line = Line { kind: first.kind, op, offset: 0, step: first.scalar, count };
        (0..all.len()).filter(|&m| here(m)).all(same).then_some(line)
    }

    /// The lines of cells that make up a block of the sparse branch that a member stands in.
    fn block_lines(&self, branch_of: usize, mut line: impl FnMut(Line)) {
        if let Some(whole) = self.uniform_block(branch_of) {
            return line(whole);
        }
        let branch = Map::<R, L, X>::branch(branch_of);
        for &(m, op) in self.members.iter().filter(|&&(m, _)| Map::<R, L, X>::branch(m) == branch) {
            let (chain, member) = (Map::<R, L, X>::chain(m), R::Elements::MEMBERS[m]);
            let (start, step) = (Map::<R, L, X>::start(&self.handle.geometry, m), Map::<R, L, X>::stride(m));
            let component = Map::<R, L, X>::component(&self.handle.geometry, m);
            for leaf in 0..chain.cells / chain.leaf {
                for c in 0..member.components {
                    let offset = leaf * Map::<R, L, X>::leaf_bytes(m) + start + c * component;
                    line(Line { kind: member.kind, op, offset, step, count: chain.leaf });
                }
            }
        }
    }

    /// The first accumulated member of each sparse branch.
    fn sparse_branches(&self) -> impl Iterator<Item = usize> + '_ {
        let first = |n: usize| {
            let m = self.members[n].0;
            let same = |&(other, _): &(usize, Op)| Map::<R, L, X>::branch(other) == Map::<R, L, X>::branch(m);
            (Map::<R, L, X>::is_sparse(m) && !self.members[..n].iter().any(same)).then_some(m)
        };
        (0..self.members.len()).filter_map(first)
    }

    /// Fills the background of a copy's blocks with identities, or with zeros.
    fn set_background(&self, copy: &mut Storage, identity: bool) {
        for m in self.sparse_branches() {
            let store = copy.store_mut(Map::<R, L, X>::sparse_branch(m));
            store.set_background(|brick| {
                // SAFETY: lines lie within a block, which the background is; the copy is ours alone.
                self.block_lines(m, |line| unsafe { set_line(brick, line, identity) });
            });
        }
    }

    /// The lines of cells that make up a part: offset of the first scalar, distance and number of scalars.
    fn lines(&self, part: usize, mut line: impl FnMut(Line)) {
        if let Some((kind, op, scalar)) = self.uniform() {
            let scalars = self.scalars(scalar);
            let first = part * PART;
            line(Line { kind, op, offset: first * scalar, step: scalar, count: PART.min(scalars - first) });
            return;
        }
        let geometry = &self.handle.geometry;
        for &(m, op) in self.members.iter().filter(|&&(m, _)| part < self.parts_of(m)) {
            let (leaves, cells) = self.leaves(m);
            let member = R::Elements::MEMBERS[m];
            let (start, step) = (Map::<R, L, X>::start(geometry, m), Map::<R, L, X>::stride(m));
            let component = Map::<R, L, X>::component(geometry, m);
            for c in 0..member.components {
                let mut add = |leaf: usize, first: usize, count: usize| {
                    let offset = leaf * Map::<R, L, X>::leaf_bytes(m) + start + c * component + first * step;
                    line(Line { kind: member.kind, op, offset, step, count });
                };
                if Map::<R, L, X>::chain(m).is_flat() {
                    let first = part * PART;
                    add(0, first, PART.min(cells - first));
                } else {
                    let leaves_a_part = (PART / cells).max(1);
                    let first = part * leaves_a_part;
                    for leaf in first..(first + leaves_a_part).min(leaves) {
                        add(leaf, 0, cells);
                    }
                }
            }
        }
    }
}

impl<R: Record, L: Layout<X>, X: Axes> Scattered for Target<'_, '_, R, L, X> {
    fn root(&self) -> *mut u8 {
        self.handle.root
    }

    fn geometry(&self) -> &Geometry {
        &self.handle.geometry
    }

    fn rank(&self) -> usize {
        X::RANK
    }

    fn block(&self) -> [u32; MAX_AXES] {
        let chain = self.members.first().map(|&(m, _)| Map::<R, L, X>::chain(m));
        core::array::from_fn(|a| chain.map_or(1, |chain| chain.extent[a] as u32).max(1))
    }

    fn bytes(&self) -> usize {
        let stores: usize = self.sparse_branches().map(|m| self.handle.store(m).bytes()).sum();
        Map::<R, L, X>::bytes(&self.handle.geometry).expect("the field has been allocated") + stores
    }

    fn cells(&self) -> usize {
        if const { Map::<R, L, X>::any_sparse() } {
            // About as many as were active last.
            return self
                .sparse_branches()
                .map(|m| self.handle.actives(m).work())
                .max()
                .unwrap_or(self.handle.geometry.len());
        }
        self.handle.geometry.len()
    }

    fn aligned(&self) -> bool {
        self.members.iter().all(|&(m, _)| Map::<R, L, X>::aligned(m))
    }

    fn borrow_copy(&self) -> Storage {
        let spare = self.handle.spare.and_then(|spare| spare.lock().unwrap_or_else(PoisonError::into_inner).pop());
        let mut copy = spare.unwrap_or_else(|| Storage::new_or_abort::<R, L, X>(&self.handle.geometry));
        self.set_background(&mut copy, true);
        if self.members.iter().any(|&(_, op)| !op.identity_is_zero()) {
            for part in 0..self.parts() {
                // SAFETY: lines lie within the field's bytes, which the copy has too, and the copy is ours alone.
                self.lines(part, |line| unsafe { set_line(copy.start(), line, true) });
            }
        }
        copy
    }

    fn give_back(&self, mut copy: Storage) {
        self.set_background(&mut copy, false);
        if self.members.iter().any(|&(_, op)| !op.identity_is_zero()) {
            for part in 0..self.parts() {
                // SAFETY: as in `borrow_copy`.
                self.lines(part, |line| unsafe { set_line(copy.start(), line, false) });
            }
        }
        if let Some(spare) = self.handle.spare {
            spare.lock().unwrap_or_else(PoisonError::into_inner).push(copy);
        }
    }

    fn parts(&self) -> usize {
        if let Some((_, _, scalar)) = self.uniform() {
            return self.scalars(scalar).div_ceil(PART);
        }
        self.members.iter().map(|&(m, _)| self.parts_of(m)).max().unwrap_or(0)
    }

    unsafe fn combine(&self, copy: &Storage, part: usize) {
        self.lines(part, |line| {
            // SAFETY: lines lie within the field's bytes, which the copy has too; the caller has this part of both.
            unsafe { combine_line(self.handle.root, copy.start(), line) };
        });
    }

    fn combine_blocks(&self, copy: &mut Storage, threads: usize) {
        let from = self.handle.at(copy.start());
        for m in self.sparse_branches() {
            let list = from.actives(m);
            let parts = list.bricks.len().div_ceil(BLOCKS);
            run_jobs(threads, parts, &|part| {
                for n in part * BLOCKS..list.bricks.len().min((part + 1) * BLOCKS) {
                    let brick = &list.bricks[n];
                    let to = Map::<R, L, X>::find(&self.handle.geometry, self.handle.store(m), m, &brick.block);
                    let to = if to.is_null() { self.handle.without_paths().grow(m, &brick.block) } else { to };
                    let mut new = 0;
                    for (word, &bits) in list.bits(n).iter().enumerate() {
                        let (field, _) = Store::bit_of(to, Map::<R, L, X>::bits_at(m), word * 64);
                        new |= bits & !field.fetch_or(bits, Ordering::Relaxed);
                    }
                    if new != 0 {
                        self.handle.store(m).mark();
                    }
                    self.block_lines(m, |line| {
                        // SAFETY: lines lie within a block, of the field and of the copy; no job accumulates any more, and each
                        // block is taken by one job.
                        unsafe { combine_line(to, brick.start, line) };
                    });
                }
            });
        }
        copy.settle();
        Map::<R, L, X>::clear(&self.handle.geometry, &mut copy.stores_mut());
    }
}
