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
    let here: Vec<&Span> = spans.iter().filter(|span| !inside(&span.bytes).is_empty()).collect();
    for gap in gaps(piece, spans, &bytes) {
        paper.rectangle(area(&gap), &format!(r##"fill="url(#padding)" {EDGE}"##));
    }
    let activity = inside(&piece.activity);
    if !activity.is_empty() {
        paper.rectangle(area(&activity), &format!(r##"fill="url(#bits)" {EDGE}"##));
    }
    for span in &here {
        value(paper, area(&inside(&span.bytes)), span, &members[span.member], bytes.contains(&span.bytes.start));
    }
    indices(paper, &here, &bytes, at);
    // Blocks last, over all else.
    for span in here.iter().filter(|span| bytes.contains(&span.bytes.start)) {
        let before = spans.iter().take_while(|other| other.bytes.start < span.bytes.start).last();
        if let Some(before) =
            before.filter(|before| before.node != span.node && before.bytes.end + LINE > span.bytes.start)
        {
            let x = at(span.bytes.start);
            paper.line([x, top - INDEX + 1.0], [x, top + BOX + 3.0], &border(before.block != span.block));
        }
    }
    paper.y = top + BOX + GAP;
}

pub(super) fn border(thick: bool) -> String {
    format!(r#"stroke="{INK}" stroke-width="{}""#, if thick { 2.4 } else { 1.2 })
}

/// The box of a span or of the part of it that lies in a line, with its name where there is room.
fn value(paper: &mut Paper, area: [f64; 4], span: &Span, member: &Member, begins: bool) {
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
    let scalar = member.scalar_bytes as f64 * BYTE;
    let mut component = scalar;
    while begins && component < width - 0.01 {
        paper.line(
            [x + component, y + height - 4.0],
            [x + component, y + height],
            &format!(r#"stroke="{}" stroke-width="0.8""#, fill.ink),
        );
        component += scalar;
    }
    let apart = span.components.len() < member.components;
    let name = match (member.name.as_str(), apart) {
        ("", false) => return,
        ("", true) => span.components.start.to_string(),
        (name, false) => name.to_string(),
        (name, true) => format!("{name}.{}", span.components.start),
    };
    let ink = if span.standing == Standing::Active { fill.ink } else { FAINT };
    if begins && name.chars().count() as f64 * SMALL * SIGN + 2.0 <= width {
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
fn indices(paper: &mut Paper, here: &[&Span], bytes: &Range<usize>, at: impl Fn(usize) -> f64) {
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
