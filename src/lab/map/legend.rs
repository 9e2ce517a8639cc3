//! What colours and patterns stand for.

use allotrope::Standing;

use super::colours::{self, Fill};
use super::lines::{LINE, Shown};
use super::paper::{INK, MARGIN, Paper, SIGN, Side, WIDTH};
use super::row::{PLAIN, border, filled, gaps};
use super::sums::plural;
use super::{Member, Piece, Span};

/// What a picture shows besides members.
pub(super) struct Signs {
    padding: bool,
    inactive: bool,
    beyond: bool,
    bits: bool,
    blocks: bool,
}

impl Signs {
    pub(super) fn of(pieces: &[Piece], shown: &[Shown], spans: &[Vec<Span>]) -> Self {
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

pub(super) fn legend(paper: &mut Paper, members: &[Member], signs: &Signs) {
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
