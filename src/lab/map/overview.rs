//! Which blocks of a sparse layout are there, as a plan seen from above.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use allotrope::Standing;

use super::paper::{FAINT, MARGIN, Paper, WIDTH};
use super::{Mapped, Piece, Span};

/// The most blocks, and the most bytes of them all, that are looked through.
const MOST: usize = 1 << 12;
const MOST_BYTES: usize = 1 << 24;
/// Units of a block's side.
const SIDES: RangeInclusive<f64> = 2.5..=12.0;
/// The most units of the plan down.
const DOWN: f64 = 260.0;

/// Blocks of equal size in one or two dimensions.
#[derive(Debug, PartialEq)]
pub(super) struct Overview {
    /// Elements of a block along each axis.
    extent: Vec<i64>,
    /// The first block and how many there are, along two axes, the first of which may be of no account.
    first: [i64; 2],
    count: [i64; 2],
    /// For each block that is there, which part of its elements is active.
    share: BTreeMap<[i64; 2], f64>,
}

impl Overview {
    /// That of a sparse map over one or two axes, if it can be drawn.
    pub(super) fn of(map: &dyn Mapped, pieces: &[Piece]) -> Option<Self> {
        let rank = map.shape().len();
        let blocks: Vec<_> =
            pieces.iter().enumerate().filter_map(|(n, piece)| Some((n, piece.block.as_ref()?))).collect();
        let bytes: usize = pieces.iter().map(|piece| piece.bytes).sum();
        if !(1..=2).contains(&rank) || blocks.is_empty() || blocks.len() > MOST || bytes > MOST_BYTES {
            return None;
        }
        let (mut extent, mut share) = (Vec::new(), BTreeMap::new());
        for (n, first) in blocks {
            let spans = map.spans_in(n, 0..pieces[n].bytes);
            let (own, active) = about(&spans, first);
            if extent.is_empty() {
                extent = own;
            } else if extent != own {
                return None;
            }
            let at: Vec<i64> = first.iter().zip(&extent).map(|(&c, extent)| i64::from(c).div_euclid(*extent)).collect();
            let at = if rank == 1 { [0, at[0]] } else { [at[0], at[1]] };
            // Blocks of several branches.
            if share.insert(at, active).is_some() {
                return None;
            }
        }
        let along = |axis: usize| {
            let blocks = share.keys().map(|at| at[axis]);
            let (first, last) = (blocks.clone().min().unwrap_or(0), blocks.max().unwrap_or(0));
            let Some(axis) = (axis + rank).checked_sub(2) else { return (0, 1) };
            // Without bounds, what is there.
            match map.shape()[axis] as i64 {
                bounded if bounded < i64::from(i32::MAX) && first >= 0 => {
                    (0, ((bounded - 1) / extent[axis]).max(last) + 1)
                }
                _ => (first, last - first + 1),
            }
        };
        let ((i, rows), (j, columns)) = (along(0), along(1));
        let overview = Self { extent, first: [i, j], count: [rows, columns], share };
        (overview.side() >= *SIDES.start()).then_some(overview)
    }

    fn side(&self) -> f64 {
        let [rows, columns] = self.count.map(|count| count as f64);
        ((WIDTH - 2.0 * MARGIN) / columns).min(DOWN / rows).min(*SIDES.end())
    }

    pub(super) fn draw(&self, paper: &mut Paper, size: f64) {
        let extent: Vec<String> = self.extent.iter().map(i64::to_string).collect();
        let axes = if self.extent.len() == 1 { "`i` to the right" } else { "`i` down, `j` to the right" };
        let text = format!(
            "Allocated are {} of {} blocks of {}, the darker the more of their elements are active ({}):",
            self.share.len(),
            self.count[0] * self.count[1],
            extent.join(" x "),
            axes.replace('`', "")
        );
        paper.paragraph(&text, size, FAINT);
        paper.y += 6.0;
        let side = self.side();
        for row in 0..self.count[0] {
            for column in 0..self.count[1] {
                let area = [MARGIN + column as f64 * side, paper.y + row as f64 * side, side, side];
                let style = match self.share.get(&[self.first[0] + row, self.first[1] + column]) {
                    Some(share) => format!(r##"fill="#0072b2" fill-opacity="{:.2}""##, 0.2 + 0.8 * share),
                    None => r#"fill="none""#.into(),
                };
                paper.rectangle(area, &format!(r##"{style} stroke="#9ca3af" stroke-width="0.5""##));
            }
        }
        paper.y += self.count[0] as f64 * side + 8.0;
    }
}

/// The extent of a block, and which part of its elements is active.
fn about(spans: &[Span], first: &[i32]) -> (Vec<i64>, f64) {
    let mut extent = vec![1; first.len()];
    let (mut elements, mut active) = (0.0f64, 0.0);
    let once = spans.first().map(|span| (span.member, span.components.start));
    for span in spans.iter().filter(|span| Some((span.member, span.components.start)) == once) {
        for (axis, extent) in extent.iter_mut().enumerate() {
            *extent = (i64::from(span.index[axis]) - i64::from(first[axis]) + 1).max(*extent);
        }
        elements += f64::from(u8::from(span.standing != Standing::Beyond));
        active += f64::from(u8::from(span.standing == Standing::Active));
    }
    (extent, active / elements.max(1.0))
}

#[cfg(test)]
mod tests {
    use super::super::TextMap;
    use super::*;

    fn of(layout: &str, shape: &[usize], active: &str) -> Option<Overview> {
        let map = TextMap::new("m: f32", layout, Some(shape), Some(active)).unwrap();
        Overview::of(&map, &map.pieces())
    }

    #[test]
    fn blocks_are_counted_and_shaded() {
        let overview = of("pointer(ij).bitmasked(ij, 4).aos", &[10, 14], "0,0; 9,13; 8,13").unwrap();
        assert_eq!((overview.extent, overview.first, overview.count), (vec![4, 4], [0, 0], [3, 4]));
        // The last block has but four elements within the shape.
        assert_eq!(overview.share, BTreeMap::from([([0, 0], 1.0 / 16.0), ([2, 3], 0.5)]));
        let overview = of("hash(i).dense(i, 4).aos", &[8], "-9; 5").unwrap();
        assert_eq!((overview.first, overview.count), ([0, -3], [1, 5]));
    }

    #[test]
    fn what_cannot_be_seen_from_above_is_left_out() {
        assert_eq!(of("hash(ij).dense(ij, 4).aos", &[8, 8], "0,0; 1000000,3"), None);
        assert_eq!(of("Sparse<2>", &[8, 8, 8], "all"), None);
        assert_eq!(of("Sparse<2>", &[8, 8], "none"), None);
    }
}
