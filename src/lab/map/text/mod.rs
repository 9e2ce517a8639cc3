//! Maps of layouts that are texts: an interpreter of the language's layouts, for which nothing is compiled.

mod active;
mod blocks;
mod branch;
mod check;
mod layout;
mod levels;
mod nodes;
mod places;
mod record;
mod scan;
mod shape;
mod spans;
mod streams;
mod syntax;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod wrong;

use std::ops::Range;

use self::blocks::Block;
use self::branch::Branch;
use self::layout::Layout;
use self::shape::Rooted;
use super::{Mapped, Member, Piece, Span};
use crate::lab::errors::LabError;

/// Where the members of records lie in a layout over a shape, all of them as texts.
///
/// ```
/// use allotrope_lab::lab::map::{Mapped, TextMap};
///
/// let map = TextMap::new("v: Vec2, m: f32", "dense(ij).dense(ij, 4).soa", Some(&[10, 12]), None).unwrap();
/// assert_eq!(map.pieces()[0].bytes, 3 * 3 * 16 * 12);
/// let first = &map.spans_in(0, 0..64)[0];
/// assert_eq!((first.bytes.clone(), first.index.as_slice()), (0..8, &[0, 0][..]));
///
/// let error = TextMap::new("v: Vec2", "dens(ij).aos", None, None).unwrap_err();
/// let message = "layout `dens(ij).aos`: column 1, `dens`: there is no node or place `dens`; did you mean `dense`?";
/// assert_eq!(error.to_string(), message);
/// ```
#[derive(Clone, Debug)]
pub struct TextMap {
    members: Vec<Member>,
    shape: Vec<usize>,
    /// What the layout is written out, where it has a name.
    meaning: Option<String>,
    branches: Vec<Branch>,
    /// Of each dense branch.
    roots: Vec<Option<Rooted>>,
    /// Bytes of all dense branches; 0 where there are none.
    bytes: usize,
    blocks: Vec<Block>,
}

impl TextMap {
    /// The map of a record such as `x: Vec2, m: f32` in a layout such as `dense(ij).dense(ij, 4).aos` or `Blocked<4>`.
    ///
    /// The shape has an extent for each axis but that of lists; without one a small one is taken. `active` tells which elements of a sparse
    /// layout are active: `all`, `none`, `diagonal` (taken without it), `disc`, `random:10` (percent), or boxes of indices, `0..8,0..8; 20,30`.
    /// With a `hash`, the shape is that of the pattern alone.
    ///
    /// # Errors
    /// One line that names the text and the place in it that is wrong, and what to write instead.
    pub fn new(record: &str, layout: &str, shape: Option<&[usize]>, active: Option<&str>) -> Result<Self, LabError> {
        let members = record::parse(record)?;
        let parsed = layout::parse(layout, shape.map(<[usize]>::len))?;
        let shape = shape::of(layout, &parsed, shape)?;
        let streams = streams::of(layout, &parsed, &members)?;
        let chains = parsed.branches.iter().zip(streams);
        let branches: Vec<Branch> = chains.map(|(chain, streams)| Branch::new(chain, streams, &members)).collect();
        let meaning = layout::meaning(layout, shape.len());
        let (roots, bytes) = shape::lay(&branches, &shape)?;
        let mut map = Self { members, shape, meaning, branches, roots, bytes, blocks: Vec::new() };
        map.activate(layout, &parsed, active)?;
        Ok(map)
    }

    /// What a layout with a name is, written out.
    pub fn meaning(&self) -> Option<&str> {
        self.meaning.as_deref()
    }

    /// Makes the blocks in which elements are active.
    fn activate(&mut self, text: &str, layout: &Layout, active: Option<&str>) -> Result<(), LabError> {
        if !self.is_sparse() {
            return match active {
                Some(_) => Err(LabError::usage(format!(
                    "the layout `{text}` has no sparse nodes, so that all its elements are active; leave the activity out"
                ))),
                None => Ok(()),
            };
        }
        let hash = self.branches.iter().any(|branch| branch.sparse.as_ref().is_some_and(|sparse| sparse.hash));
        let places = active::elements(active.unwrap_or("diagonal"), &self.shape, !hash)?;
        for (number, branch) in self.branches.iter().enumerate() {
            if layout.branches[number].is_sparse() {
                self.blocks.extend(blocks::of(text, number, branch, &self.shape, &places)?);
            }
        }
        Ok(())
    }
}

impl Mapped for TextMap {
    fn shape(&self) -> &[usize] {
        &self.shape
    }

    fn members(&self) -> Vec<Member> {
        self.members.clone()
    }

    fn is_sparse(&self) -> bool {
        self.branches.iter().any(|branch| branch.sparse.is_some())
    }

    fn pieces(&self) -> Vec<Piece> {
        let dense =
            self.roots.iter().any(Option::is_some).then_some(Piece { bytes: self.bytes, block: None, activity: 0..0 });
        let blocks = self.blocks.iter().map(|block| {
            let (at, bits, bytes) = self.branches[block.branch].block().unwrap_or_default();
            let first = block.first[..self.shape.len()].iter().map(|&c| c as i32).collect();
            Piece { bytes, block: Some(first), activity: at..at + bits.div_ceil(64) * 8 }
        });
        dense.into_iter().chain(blocks).collect()
    }

    fn spans_in(&self, piece: usize, bytes: Range<usize>) -> Vec<Span> {
        spans::within(self, piece, &bytes)
    }

    fn starts(&self, piece: usize) -> Vec<usize> {
        spans::starts(self, piece)
    }
}
