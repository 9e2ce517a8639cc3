//! A row of a picture: 64 bytes.

use std::ops::Range;

use allotrope::Standing;

use super::colours::{self, Fill};
use super::lines::LINE;
use super::paper::{FAINT, INK, MARGIN, Paper, SIGN, Side, WIDTH};
use super::{Member, Piece, Span};

/// Where bytes begin, right of their numbers.
pub(super) const LEFT: f64 = 56.0;
/// Units of a byte.
pub(super) const BYTE: f64 = (WIDTH - LEFT - MARGIN) / LINE as f64;
/// Units of the indices above a row.
const INDEX: f64 = 12.0;
/// Units of a row.
const BOX: f64 = 18.0;
/// Units between rows.
const GAP: f64 = 6.0;
/// Units of text in rows and above them.
pub(super) const SMALL: f64 = 9.5;
/// Of other text.
pub(super) const PLAIN: f64 = 11.5;

const EDGE: &str = r##"stroke="#ffffff" stroke-width="0.7""##;

/// A line of 64 bytes.
pub(super) fn row(paper: &mut Paper, piece: &Piece, line: usize, spans: &[Span], members: &[Member]) {
    let bytes = line * LINE..((line + 1) * LINE).min(piece.bytes);
    let top = paper.y + INDEX;
    let at = |byte: usize| LEFT + (byte - bytes.start) as f64 * BYTE;
    let area = |part: &Range<usize>| [at(part.start), top, part.len() as f64 * BYTE, BOX];
    let inside = |part: &Range<usize>| part.start.max(bytes.start)..part.end.min(bytes.end);
    // Of long numbers all digits are to be seen.
    let number = bytes.start.to_string();
    let size = SMALL.min((LEFT - 10.0) / (number.len() as f64 * SIGN));
    paper.text([LEFT - 6.0, top + 13.0], size, Side::Right, FAINT, &number);
    let (before, here) = within(spans, &bytes);
    for gap in gaps(piece, here, &bytes) {
        paper.rectangle(area(&gap), &format!(r##"fill="url(#padding)" {EDGE}"##));
    }
    let activity = inside(&piece.activity);
    if !activity.is_empty() {
        paper.rectangle(area(&activity), &format!(r##"fill="url(#bits)" {EDGE}"##));
    }
    for span in here {
        let part = inside(&span.bytes);
        value(paper, area(&part), &part, span, &members[span.member]);
    }
    indices(paper, here, &bytes, at);
    // Blocks last, over all else.
    // What is left out between the two is no border, and one that a line before has is not drawn again.
    let begins = |last: &Span, span: &Span| {
        last.node != span.node && last.bytes.end + LINE > span.bytes.start && span.bytes.start >= bytes.start
    };
    let mut last = before;
    for span in here {
        if let Some(last) = last.filter(|last| begins(last, span)) {
            let x = at(span.bytes.start);
            paper.line([x, top - INDEX + 1.0], [x, top + BOX + 3.0], &border(last.block != span.block));
        }
        last = Some(span);
    }
    paper.y = top + BOX + GAP;
}

/// The spans that have bytes in a range, and the one before them, of spans in order.
fn within<'a>(spans: &'a [Span], bytes: &Range<usize>) -> (Option<&'a Span>, &'a [Span]) {
    let from = spans.partition_point(|span| span.bytes.end <= bytes.start);
    let to = spans.partition_point(|span| span.bytes.start < bytes.end);
    (spans[..from].last(), &spans[from..to])
}

pub(super) fn border(thick: bool) -> String {
    format!(r#"stroke="{INK}" stroke-width="{}""#, if thick { 2.4 } else { 1.2 })
}

/// The box of a span or of the part of it that lies in a line, with its name where there is room.
fn value(paper: &mut Paper, area: [f64; 4], part: &Range<usize>, span: &Span, member: &Member) {
    let fill = colours::of(span.member);
    match span.standing {
        Standing::Beyond => {
            paper.rectangle(area, &format!(r##"fill="url(#beyond)" {EDGE}"##));
            return;
        }
        Standing::Active => filled(paper, area, fill, EDGE),
        Standing::Inactive => {
            filled(
                paper,
                area,
                fill,
                &format!(r##"fill-opacity="0.22" stroke="{}" stroke-width="0.7" stroke-dasharray="2 2""##, FAINT),
            );
        }
    }
    let [x, y, width, height] = area;
    // Where components begin.
    for start in span.bytes.clone().step_by(member.scalar_bytes).filter(|&start| start > part.start && start < part.end)
    {
        let x = x + (start - part.start) as f64 * BYTE;
        let style = format!(r#"stroke="{}" stroke-width="0.8""#, fill.ink);
        paper.line([x, y + height - 4.0], [x, y + height], &style);
    }
    let apart = span.components.len() < member.components;
    let name = match (member.name.as_str(), apart) {
        ("", false) => return,
        ("", true) => span.components.start.to_string(),
        (name, false) => name.to_string(),
        (name, true) => format!("{name}.{}", span.components.start),
    };
    let ink = if span.standing == Standing::Active { fill.ink } else { FAINT };
    if name.chars().count() as f64 * SMALL * SIGN + 2.0 <= width {
        paper.text([x + width / 2.0, y + 11.5], SMALL, Side::Middle, ink, &name);
    }
}

pub(super) fn filled(paper: &mut Paper, area: [f64; 4], fill: Fill, style: &str) {
    paper.rectangle(area, &format!(r#"fill="{}" {style}"#, fill.colour));
    if fill.stripes > 0 {
        paper.rectangle(area, &format!(r#"fill="url(#stripes{})""#, fill.stripes));
    }
}

/// The index of each element above where it begins, as many as there is room for.
fn indices(paper: &mut Paper, here: &[Span], bytes: &Range<usize>, at: impl Fn(usize) -> f64) {
    let mut free = 0.0;
    let mut last: Option<&Span> = None;
    for span in here {
        let goes_on = last.is_some_and(|last| last.index == span.index && last.node == span.node);
        last = Some(span);
        if goes_on || span.standing == Standing::Beyond || !bytes.contains(&span.bytes.start) {
            continue;
        }
        let (x, text) = (at(span.bytes.start), index(&span.index));
        let width = text.chars().count() as f64 * SMALL * SIGN;
        if x >= free && x + width <= WIDTH {
            paper.text([x + 1.5, paper.y + INDEX - 3.0], SMALL, Side::Left, INK, &text);
            free = x + width + 4.0;
        }
    }
}

/// The bytes of a range that hold neither elements nor activity.
pub(super) fn gaps(piece: &Piece, spans: &[Span], range: &Range<usize>) -> Vec<Range<usize>> {
    let (mut gaps, mut next) = (Vec::new(), range.start);
    let taken = spans.iter().map(|span| &span.bytes).chain([&piece.activity]);
    for taken in taken.filter(|taken| taken.end > range.start && taken.start < range.end) {
        if taken.start > next {
            gaps.push(next..taken.start);
        }
        next = next.max(taken.end);
    }
    if next < range.end {
        gaps.push(next..range.end);
    }
    gaps
}

/// An index as it is written above an element.
pub(super) fn index(at: &[i32]) -> String {
    at.iter().map(i32::to_string).collect::<Vec<_>>().join(",")
}
