//! Maps of fields.

use std::ops::Range;

use allotrope::MemoryMap;

use super::{Mapped, Member, Piece, Span};

impl Mapped for MemoryMap<'_> {
    fn shape(&self) -> &[usize] {
        self.shape()
    }

    fn members(&self) -> Vec<Member> {
        let members = self.members().iter().map(|member| Member {
            // A bare element's member has no name that a user would know.
            name: if member.name == "0" { String::new() } else { member.name.into() },
            kind: match member.components {
                1 => member.scalar.into(),
                components => format!("{components} x {}", member.scalar),
            },
            scalar: member.scalar.into(),
            scalar_bytes: member.scalar_bytes,
            components: member.components,
        });
        members.collect()
    }

    fn is_sparse(&self) -> bool {
        self.is_sparse()
    }

    fn pieces(&self) -> Vec<Piece> {
        let pieces = self.allocations().iter();
        pieces
            .map(|piece| Piece { bytes: piece.bytes, block: piece.block.clone(), activity: piece.activity.clone() })
            .collect()
    }

    fn spans_in(&self, piece: usize, bytes: Range<usize>) -> Vec<Span> {
        let spans = self.spans_in(piece, bytes).map(|span| Span {
            index: span.index().to_vec(),
            bytes: span.bytes,
            member: span.member,
            components: span.components,
            block: span.block,
            node: span.node,
            standing: span.standing,
        });
        spans.collect()
    }

    fn starts(&self, piece: usize) -> Vec<usize> {
        self.starts(piece)
    }
}
