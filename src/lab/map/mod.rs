//! Memory maps: where the members of each element lie, as pictures.
//!
//! A map is that of a field, `field.memory_map()`, or of a layout that is a text, [`TextMap`]. Both are drawn alike.
//!
//! ```
//! use allotrope::prelude::*;
//! use allotrope_lab::lab::map::{Drawing, TextMap};
//!
//! #[derive(Record, Clone, Copy)]
//! struct Node { v: Vec2, m: f32 }
//!
//! let grid = Field::<Node, Blocked<4>>::new([10, 12]);
//! let svg = Drawing { title: "a grid".into(), ..Drawing::default() }.svg(&grid.memory_map());
//! assert!(svg.starts_with("<svg ") && svg.contains("a grid"));
//!
//! let same = TextMap::new("v: Vec2, m: f32", "Blocked<4>", Some(&[10, 12]), None).unwrap();
//! assert!(Drawing::default().svg(&same).contains("Vec2"));
//! ```

mod colours;
mod field;
mod legend;
mod lines;
mod overview;
mod page;
mod paper;
mod row;
mod sums;
mod svg;
#[cfg(test)]
mod tests;
mod text;

use std::ops::Range;

use allotrope::Standing;

pub use self::page::{Sheet, page};
pub(in crate::lab) use self::paper::escaped;
pub use self::sums::summary;
pub use self::svg::Drawing;
pub use self::text::TextMap;

/// What a drawing asks of a map.
pub trait Mapped {
    /// Elements along each axis.
    fn shape(&self) -> &[usize];
    /// The members of a record.
    fn members(&self) -> Vec<Member>;
    /// Whether memory follows what is active.
    fn is_sparse(&self) -> bool;
    /// The memory that holds elements: that of dense branches first, then block after block.
    fn pieces(&self) -> Vec<Piece>;
    /// The spans of one piece of which a byte lies in a range, in the order in which they lie.
    fn spans_in(&self, piece: usize, bytes: Range<usize>) -> Vec<Span>;
    /// Where in a piece the values of each member, or of its components where they lie apart, first begin.
    fn starts(&self, piece: usize) -> Vec<usize>;
}

/// A member of a record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    /// Its name; empty for a bare element.
    pub name: String,
    /// Its type.
    pub kind: String,
    /// The type of its components.
    pub scalar: String,
    /// Bytes of a component.
    pub scalar_bytes: usize,
    /// How many it has.
    pub components: usize,
}

impl Member {
    /// Bytes of all components.
    pub fn bytes(&self) -> usize {
        self.components * self.scalar_bytes
    }
}

/// A piece of memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its bytes.
    pub bytes: usize,
    /// Of a block, its first index.
    pub block: Option<Vec<i32>>,
    /// The bytes that hold a block's activity bits.
    pub activity: Range<usize>,
}

/// Bytes that hold a member of an element, or a component of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// Where in their piece.
    pub bytes: Range<usize>,
    /// The number of the member.
    pub member: usize,
    /// Its components that lie here.
    pub components: Range<usize>,
    /// The element.
    pub index: Vec<i32>,
    /// The number of the root's cell that it is in.
    pub block: usize,
    /// The number of the innermost node that it is in.
    pub node: usize,
    /// Whether there is such an element, and it is active.
    pub standing: Standing,
}
