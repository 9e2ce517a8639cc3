//! Which lines of which pieces are drawn.

use std::ops::Range;

use super::Mapped;

/// Bytes of a line, which are those of a cache line.
pub(super) const LINE: usize = 64;

/// What is drawn of a piece: lines, and those left out between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Shown {
    pub(super) piece: usize,
    pub(super) lines: Vec<Range<usize>>,
}

/// Of each piece at most so many lines, the first and those where a run of values begins; of many pieces the first.
pub(super) fn chosen(map: &dyn Mapped, budget: usize) -> Vec<Shown> {
    let pieces = map.pieces();
    let mut left = budget.max(1);
    let mut chosen = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let all = piece.bytes.div_ceil(LINE);
        // A piece after the first is not begun for a line or two.
        if left == 0 || number > 0 && left < all.min(3) {
            break;
        }
        // The first leaves room for another.
        let share = if number == 0 && pieces.len() > 1 { (left * 2).div_ceil(3) } else { left };
        let mut starts: Vec<usize> = map.starts(number).into_iter().map(|start| start / LINE).collect();
        starts.extend((!piece.activity.is_empty()).then_some(piece.activity.start / LINE));
        let lines = of_piece(all, share, &starts);
        left -= lines.iter().map(Range::len).sum::<usize>().min(left);
        chosen.push(Shown { piece: number, lines });
    }
    chosen
}

/// At most `share` of a piece's lines: all, or the first and those of the starts.
fn of_piece(all: usize, share: usize, starts: &[usize]) -> Vec<Range<usize>> {
    if all <= share {
        return std::iter::once(0..all).collect();
    }
    // Up to a half for starts further on, two lines each.
    let mut first = share;
    let mut later: Vec<usize> = Vec::new();
    for &start in starts {
        let more = later.iter().copied().chain([start, start + 1]);
        let mut more: Vec<usize> = more.filter(|&line| line < all).collect();
        more.sort_unstable();
        more.dedup();
        let beyond = |first: usize| more.iter().filter(|&&line| line >= first).count();
        let room = share - beyond(share / 2).min(share);
        if room < share.div_ceil(2) {
            break;
        }
        first = room;
        later = more;
    }
    let lines = (0..first).chain(later.into_iter().filter(|&line| line >= first));
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for line in lines {
        match ranges.last_mut() {
            Some(last) if last.end == line => last.end += 1,
            // A single line is not worth a note.
            Some(last) if last.end + 1 == line => last.end += 2,
            _ => ranges.push(line..line + 1),
        }
    }
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First lines and those after the last.
    fn lines(all: usize, share: usize, starts: &[usize]) -> Vec<(usize, usize)> {
        of_piece(all, share, starts).into_iter().map(|lines| (lines.start, lines.end)).collect()
    }

    #[test]
    fn what_fits_is_shown_whole() {
        assert_eq!(lines(7, 8, &[0]), [(0, 7)]);
        assert_eq!(lines(0, 8, &[0]), [(0, 0)]);
    }

    #[test]
    fn starts_of_runs_are_shown() {
        assert_eq!(lines(1000, 8, &[0]), [(0, 8)]);
        assert_eq!(lines(1000, 12, &[0, 400, 800]), [(0, 8), (400, 402), (800, 802)]);
        // Not all where they are many.
        let some = lines(100_000, 12, &(0..24).map(|n| n * 4000).collect::<Vec<_>>());
        assert_eq!(some, [(0, 6), (4000, 4002), (8000, 8002), (12_000, 12_002)]);
        // The last line may be the start of a run.
        assert_eq!(lines(100, 8, &[0, 99]), [(0, 7), (99, 100)]);
    }
}
