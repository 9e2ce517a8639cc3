//! The picture of a map: bytes in rows of 64, a colour a member.

use std::ops::Range;

use allotrope::Standing;

use super::colours::{self, Fill};
use super::lines::{LINE, Shown, chosen};
use super::paper::{FAINT, INK, MARGIN, Paper, SIGN, Side, WIDTH};
use super::sums::{plural, size, summary};
use super::{Mapped, Member, Piece, Span};

/// What is drawn of a map, and what stands above it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawing {
    /// The headline: the record, say.
    pub title: String,
    /// Below it: the layout, say.
    pub subtitle: String,
    /// The most lines of 64 bytes that are drawn. Of longer layouts the first are, and those where the values of a member begin.
    pub lines: usize,
}

impl Default for Drawing {
    fn default() -> Self {
        Self { title: "Memory map".into(), subtitle: String::new(), lines: 24 }
    }
}

/// Where bytes begin, right of their numbers.
const LEFT: f64 = 56.0;
/// Units of a byte.
const BYTE: f64 = (WIDTH - LEFT - MARGIN) / LINE as f64;
/// Units of the indices above a row.
const INDEX: f64 = 11.0;
/// Units of a row.
const BOX: f64 = 18.0;
/// Units between rows.
const GAP: f64 = 6.0;
/// Units of text in rows and above them.
const SMALL: f64 = 9.5;
/// Of other text.
const PLAIN: f64 = 11.5;

const EDGE: &str = r##"stroke="#ffffff" stroke-width="0.7""##;

impl Drawing {
    /// The text of an SVG file, which is the same for equal maps.
    pub fn svg(&self, map: &dyn Mapped) -> String {
        let (members, pieces) = (map.members(), map.pieces());
        let shown = chosen(map, self.lines);
        let all = shown.iter().map(|shown| {
            let lines = shown.lines.iter();
            lines.flat_map(|lines| map.spans_in(shown.piece, lines.start * LINE..lines.end * LINE)).collect::<Vec<_>>()
        });
        let spans: Vec<Vec<Span>> = all.collect();
        let summary = summary(map);
        let mut paper = Paper::default();
        paper.y = 4.0;
        paper.paragraph(&self.title, 15.0, INK);
        paper.paragraph(&self.subtitle, 12.5, INK);
        paper.paragraph(&format!("{summary}. A row is a cache line; what stands above it are indices."), PLAIN, FAINT);
        paper.y += 8.0;
        legend(&mut paper, &members, &Signs::of(&pieces, &shown, &spans));
        ruler(&mut paper);
        for (shown, spans) in shown.iter().zip(&spans) {
            piece(&mut paper, &pieces[shown.piece], shown, spans, &members);
        }
        if shown.len() < pieces.len() {
            let left = &pieces[shown.len()..];
            note(
                &mut paper,
                &format!("{} not shown, {}", plural(left.len(), "block"), size(left)),
            );
        }
        let description = format!("{} {summary}", self.subtitle);
        paper.finish(&self.title, description.trim())
    }
}

/// What a picture shows besides members.
struct Signs {
    padding: bool,
    inactive: bool,
    beyond: bool,
    bits: bool,
    blocks: bool,
}

impl Signs {
    fn of(pieces: &[Piece], shown: &[Shown], spans: &[Vec<Span>]) -> Self {
        let all = || spans.iter().flatten();
        let padded = |(shown, spans): (&Shown, &Vec<Span>)| {
            let piece = &pieces[shown.piece];
            let mut lines = shown.lines.iter();
            lines
                .any(|lines| !gaps(piece, spans, &(lines.start * LINE..(lines.end * LINE).min(piece.bytes))).is_empty())
        };
        Self {
            padding: shown.iter().zip(spans).any(padded),
            inactive: all().any(|span| span.standing == Standing::Inactive),
            beyond: all().any(|span| span.standing == Standing::Beyond),
            bits: shown.iter().any(|shown| !pieces[shown.piece].activity.is_empty()),
            blocks: spans
                .iter()
                .any(|spans| spans.first().is_some_and(|first| spans.iter().any(|span| span.node != first.node))),
        }
    }
}

fn legend(paper: &mut Paper, members: &[Member], signs: &Signs) {
    let mut entries: Vec<(Option<Fill>, String, String)> = Vec::new();
    for (number, member) in members.iter().enumerate() {
        let Member { name, kind, .. } = member;
        let text = if name.is_empty() { kind.clone() } else { format!("{name}: {kind}") };
        entries.push((Some(colours::of(number)), String::new(), format!("{text}, {}", plural(member.bytes(), "byte"))));
    }
    for (is_there, fill, text) in [
        (signs.padding, r##"fill="url(#padding)""##, "padding"),
        (signs.beyond, r##"fill="url(#beyond)""##, "cells beyond the shape"),
        (signs.inactive, r##"fill="#ffffff" stroke="#4b5563" stroke-dasharray="2 2""##, "pale: inactive elements"),
        (signs.bits, r##"fill="url(#bits)""##, "activity bits"),
        (signs.blocks, "", "black lines: where blocks begin"),
    ] {
        if is_there {
            entries.push((None, fill.into(), text.into()));
        }
    }
    let half = (WIDTH - 2.0 * MARGIN) / 2.0;
    let fits = |text: &str| text.chars().count() as f64 * PLAIN * SIGN + 26.0 <= half;
    let columns = if entries.len() > 1 && entries.iter().all(|(.., text)| fits(text)) { 2 } else { 1 };
    let rows = entries.len().div_ceil(columns);
    for (n, (fill, style, text)) in entries.iter().enumerate() {
        let (x, y) = (MARGIN + (n / rows) as f64 * half, paper.y + (n % rows) as f64 * 17.0);
        let area = [x, y, 18.0, 12.0];
        match fill {
            Some(fill) => filled(paper, area, *fill, ""),
            None if style.is_empty() => paper.line([x + 9.0, y - 1.0], [x + 9.0, y + 13.0], &border(true)),
            None => paper.rectangle(area, style),
        }
        let signs = ((columns as f64).recip() * (WIDTH - 2.0 * MARGIN) - 26.0) / (PLAIN * SIGN);
        paper.text([x + 25.0, y + 10.0], PLAIN, Side::Left, INK, &cut(text, signs as usize));
    }
    paper.y += rows as f64 * 17.0 + 4.0;
}

/// A text of at most so many signs.
fn cut(text: &str, signs: usize) -> String {
    if text.chars().count() <= signs {
        return text.into();
    }
    text.chars().take(signs.saturating_sub(2)).chain("..".chars()).collect()
}

/// The numbers of bytes in a line.
fn ruler(paper: &mut Paper) {
    paper.y += 12.0;
    for byte in (0..=LINE).step_by(8) {
        let x = LEFT + byte as f64 * BYTE;
        if byte < LINE {
            paper.text([x, paper.y], SMALL, Side::Left, FAINT, &format!("+{byte}"));
        }
        paper.line([x, paper.y + 2.5], [x, paper.y + 6.0], &format!(r#"stroke="{FAINT}" stroke-width="0.8""#));
    }
    paper.text([LEFT - 6.0, paper.y], SMALL, Side::Right, FAINT, "byte");
    paper.y += 8.0;
}

fn piece(paper: &mut Paper, piece: &Piece, shown: &Shown, spans: &[Span], members: &[Member]) {
    if let Some(first) = &piece.block {
        paper.y += 4.0;
        paper.paragraph(&format!("Block from {}: {}", index(first), size(std::slice::from_ref(piece))), PLAIN, INK);
        paper.y += 3.0;
    }
    let all = piece.bytes.div_ceil(LINE);
    let mut next = 0;
    for lines in &shown.lines {
        left_out(paper, piece, next..lines.start);
        for line in lines.clone() {
            row(paper, piece, line, spans, members);
        }
        next = lines.end;
    }
    left_out(paper, piece, next..all);
}

fn left_out(paper: &mut Paper, piece: &Piece, lines: Range<usize>) {
    if !lines.is_empty() {
        let bytes = piece.bytes.min(lines.end * LINE) - lines.start * LINE;
        note(paper, &format!("{} not shown, {}", plural(lines.len(), "line"), plural(bytes, "byte")));
    }
}

fn note(paper: &mut Paper, text: &str) {
    paper.text([LEFT, paper.y + 12.0], PLAIN, Side::Left, FAINT, &format!("\u{22ee}  {text}"));
    paper.y += 20.0;
}

/// A line of 64 bytes.
fn row(paper: &mut Paper, piece: &Piece, line: usize, spans: &[Span], members: &[Member]) {
    let bytes = line * LINE..((line + 1) * LINE).min(piece.bytes);
    let top = paper.y + INDEX;
    let at = |byte: usize| LEFT + (byte - bytes.start) as f64 * BYTE;
    let area = |part: &Range<usize>| [at(part.start), top, part.len() as f64 * BYTE, BOX];
    let inside = |part: &Range<usize>| part.start.max(bytes.start)..part.end.min(bytes.end);
    paper.text([LEFT - 6.0, top + 13.0], SMALL, Side::Right, FAINT, &bytes.start.to_string());
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
            paper.line([x, top - 3.0], [x, top + BOX + 3.0], &border(before.block != span.block));
        }
    }
    paper.y = top + BOX + GAP;
}

fn border(thick: bool) -> String {
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

fn filled(paper: &mut Paper, area: [f64; 4], fill: Fill, style: &str) {
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
            paper.text([x, paper.y + INDEX - 2.5], SMALL, Side::Left, INK, &text);
            free = x + width + 4.0;
        }
    }
}

/// The bytes of a range that hold neither elements nor activity.
fn gaps(piece: &Piece, spans: &[Span], range: &Range<usize>) -> Vec<Range<usize>> {
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
fn index(at: &[i32]) -> String {
    at.iter().map(i32::to_string).collect::<Vec<_>>().join(",")
}
