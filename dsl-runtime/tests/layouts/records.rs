//! Records of mixed scalars, and what the oracle is told of them by hand.

use allotrope::prelude::*;

use crate::oracle::Member;

/// A record that can be made from a number and told member by member.
pub(crate) trait Sample: Record + PartialEq + std::fmt::Debug {
    const MEMBERS: &'static [Member];
    /// All values of each member.
    type Columns: PartialEq;
    /// A value whose every component depends on `n`.
    fn sample(n: usize) -> Self;
    /// Each member's `to_vec`.
    fn columns<L: Layout<X>, X: Axes>(field: &Field<Self, L, X>) -> Self::Columns;
    /// What they should be.
    fn columns_of(records: &[Self]) -> Self::Columns;
    /// The numbers of all members and their components.
    fn components() -> impl Iterator<Item = (usize, usize)> {
        Self::MEMBERS.iter().enumerate().flat_map(|(m, member)| (0..member.components).map(move |c| (m, c)))
    }
}

fn column<R: Copy, T>(records: &[R], member: impl Fn(R) -> T) -> Vec<T> {
    records.iter().map(|&record| member(record)).collect()
}

/// A node of a grid: 4-byte scalars and a byte.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) v: Vec2,
    pub(crate) m: f32,
    pub(crate) flags: u8,
}

impl Sample for Node {
    type Columns = (Vec<Vec2>, Vec<f32>, Vec<u8>);
    const MEMBERS: &'static [Member] = &[
        Member { name: "v", components: 2, bytes: 4 },
        Member { name: "m", components: 1, bytes: 4 },
        Member { name: "flags", components: 1, bytes: 1 },
    ];
    fn sample(n: usize) -> Self {
        let x = n as f32;
        Self { v: vec2(x + 0.25, -x), m: x + 0.5, flags: n as u8 }
    }
    fn columns<L: Layout<X>, X: Axes>(field: &Field<Self, L, X>) -> Self::Columns {
        let members = field.members();
        (members.v.to_vec(), members.m.to_vec(), members.flags.to_vec())
    }
    fn columns_of(records: &[Self]) -> Self::Columns {
        (column(records, |r| r.v), column(records, |r| r.m), column(records, |r| r.flags))
    }
}

/// A body: scalars of 1, 2, 4 and 8 bytes, an array, and a member with padding of its own.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub(crate) struct Body {
    pub(crate) fixed: bool,
    pub(crate) spins: [i16; 3],
    pub(crate) x: Vec3A,
    pub(crate) frame: DMat2,
    pub(crate) id: u64,
}

impl Sample for Body {
    type Columns = (Vec<bool>, Vec<[i16; 3]>, Vec<Vec3A>, Vec<DMat2>, Vec<u64>);
    const MEMBERS: &'static [Member] = &[
        Member { name: "fixed", components: 1, bytes: 1 },
        Member { name: "spins", components: 3, bytes: 2 },
        Member { name: "x", components: 3, bytes: 4 },
        Member { name: "frame", components: 4, bytes: 8 },
        Member { name: "id", components: 1, bytes: 8 },
    ];
    fn sample(n: usize) -> Self {
        let x = n as f32;
        Self {
            fixed: n % 3 == 1,
            spins: [n as i16, -(n as i16), 7],
            x: vec3a(x, x + 0.5, -x),
            frame: DMat2::from_cols_array(&[n as f64, 1.0, -1.0, n as f64 + 0.25]),
            id: (n as u64) << 33 | 5,
        }
    }
    fn columns<L: Layout<X>, X: Axes>(field: &Field<Self, L, X>) -> Self::Columns {
        let members = field.members();
        (
            members.fixed.to_vec(),
            members.spins.to_vec(),
            members.x.to_vec(),
            members.frame.to_vec(),
            members.id.to_vec(),
        )
    }
    fn columns_of(records: &[Self]) -> Self::Columns {
        (
            column(records, |r| r.fixed),
            column(records, |r| r.spins),
            column(records, |r| r.x),
            column(records, |r| r.frame),
            column(records, |r| r.id),
        )
    }
}

/// A record with a record and an enum in it.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
pub(crate) struct Outer {
    pub(crate) side: Side,
    pub(crate) node: Node,
    pub(crate) id: u16,
}

/// One integer in memory.
#[derive(Element, Clone, Copy, Default, Debug, PartialEq)]
pub(crate) enum Side {
    #[default]
    Left,
    Right = 7,
}

impl Sample for Outer {
    type Columns = (Vec<Side>, Vec<Vec2>, Vec<f32>, Vec<u8>, Vec<u16>);
    const MEMBERS: &'static [Member] = &[
        Member { name: "side", components: 1, bytes: 1 },
        Member { name: "node.v", components: 2, bytes: 4 },
        Member { name: "node.m", components: 1, bytes: 4 },
        Member { name: "node.flags", components: 1, bytes: 1 },
        Member { name: "id", components: 1, bytes: 2 },
    ];
    fn sample(n: usize) -> Self {
        Self { side: [Side::Left, Side::Right][n % 2], node: Node::sample(n), id: n as u16 + 1 }
    }
    fn columns<L: Layout<X>, X: Axes>(field: &Field<Self, L, X>) -> Self::Columns {
        let members = field.members();
        let node = members.node;
        (members.side.to_vec(), node.v.to_vec(), node.m.to_vec(), node.flags.to_vec(), members.id.to_vec())
    }
    fn columns_of(records: &[Self]) -> Self::Columns {
        (
            column(records, |r| r.side),
            column(records, |r| r.node.v),
            column(records, |r| r.node.m),
            column(records, |r| r.node.flags),
            column(records, |r| r.id),
        )
    }
}
