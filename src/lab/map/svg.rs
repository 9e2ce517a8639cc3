//! The picture of a map: bytes in rows of 64, a colour a member.

use std::ops::Range;

use super::legend::{Signs, legend};
use super::lines::{LINE, Shown, chosen};
use super::overview::Overview;
use super::paper::{FAINT, INK, Paper, Side};
use super::row::{BYTE, LEFT, PLAIN, SMALL, index, row};
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
        if let Some(overview) = Overview::of(map, &pieces) {
            overview.draw(&mut paper, PLAIN);
        }
        ruler(&mut paper);
        for (shown, spans) in shown.iter().zip(&spans) {
            piece(&mut paper, &pieces[shown.piece], shown, spans, &members);
        }
        if shown.len() < pieces.len() {
            let left = &pieces[shown.len()..];
            note(&mut paper, &format!("{} not shown, {}", plural(left.len(), "block"), size(left)));
        }
        let description = format!("{} {summary}", self.subtitle);
        paper.finish(&self.title, description.trim())
    }
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
