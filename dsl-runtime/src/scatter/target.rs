//! A field that a loop accumulates into, without its types.

use std::sync::PoisonError;

use super::combine::{Line, Op, combine_line, set_line};
use crate::axes::Axes;
use crate::field::Handle;
use crate::field::memory::Memory;
use crate::layout::{Layout, Map};
use crate::record::{ElementList, Record};
use crate::view::View;

/// A field that a loop accumulates into.
#[doc(hidden)]
pub trait Scattered: Sync {
    /// Its own memory.
    fn root(&self) -> *mut u8;
    /// The bytes of a copy.
    fn bytes(&self) -> usize;
    /// Its elements.
    fn cells(&self) -> usize;
    /// Whether every accumulated component lies at a multiple of its size.
    fn aligned(&self) -> bool;
    /// A copy full of the operators' identities.
    fn borrow_copy(&self) -> Memory;
    /// Takes a copy back that is full of identities again.
    fn give_back(&self, copy: Memory);
    /// Into how many parts the field is cut for combination.
    fn parts(&self) -> usize;
    /// Combines one part of a copy into the field and fills that part with identities.
    ///
    /// # Safety
    /// The caller has that part of the field and of the copy to itself.
    unsafe fn combine(&self, copy: &Memory, part: usize);
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
        let (leaves, cells) = self.leaves(member);
        let flat = Map::<R, L, X>::chain(member).is_flat();
        if flat { cells.div_ceil(PART) } else { leaves.div_ceil((PART / cells).max(1)) }
    }

    /// The scalars' kind and operator, if they are the same for all of the memory: it is then one line.
    fn uniform(&self) -> Option<(crate::element::Kind, Op, usize)> {
        let all = R::Elements::MEMBERS;
        let (first, op) = (all[0], self.members.first()?.1);
        let same = self.members.len() == all.len()
            && all.iter().all(|m| m.kind == first.kind)
            && self.members.iter().all(|&(_, other)| other == op);
        same.then_some((first.kind, op, first.scalar))
    }

    /// The scalars of a memory that is one line. A slice ends with its last element, a field somewhere behind it.
    fn scalars(&self, scalar: usize) -> usize {
        if const { Map::<R, L, X>::is_one_run() } {
            let (item, repeats) = const { Map::<R, L, X>::run_item() };
            self.handle.geometry.cells * repeats * (item / scalar)
        } else {
            self.bytes() / scalar
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

    fn bytes(&self) -> usize {
        Map::<R, L, X>::bytes(&self.handle.geometry).expect("the field has been allocated")
    }

    fn cells(&self) -> usize {
        self.handle.geometry.len()
    }

    fn aligned(&self) -> bool {
        self.members.iter().all(|&(m, _)| Map::<R, L, X>::aligned(m))
    }

    fn borrow_copy(&self) -> Memory {
        let spare = self.handle.spare.and_then(|spare| spare.lock().unwrap_or_else(PoisonError::into_inner).pop());
        let copy = spare.unwrap_or_else(|| Memory::zeroed_or_abort(self.bytes(), Map::<R, L, X>::LINE));
        if self.members.iter().any(|&(_, op)| !op.identity_is_zero()) {
            for part in 0..self.parts() {
                // SAFETY: lines lie within the field's bytes, which the copy has too, and the copy is ours alone.
                self.lines(part, |line| unsafe { set_line(copy.start(), line, true) });
            }
        }
        copy
    }

    fn give_back(&self, copy: Memory) {
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

    unsafe fn combine(&self, copy: &Memory, part: usize) {
        self.lines(part, |line| {
            // SAFETY: lines lie within the field's bytes, which the copy has too; the caller has this part of both.
            unsafe { combine_line(self.handle.root, copy.start(), line) };
        });
    }
}
