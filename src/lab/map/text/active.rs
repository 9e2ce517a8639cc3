//! What is active in a sparse layout: a pattern, or boxes of indices.

use super::levels::Place;
use super::scan::{Kind, Text, Tokens, nearest};
use crate::lab::errors::LabError;

/// The most elements that a pattern looks at.
const MOST: usize = 1 << 22;

/// The most elements that are active.
const MOST_ACTIVE: usize = 1 << 20;

/// The patterns that have a name.
const NAMED: [&str; 5] = ["all", "none", "diagonal", "disc", "random"];

/// Which elements are active.
#[derive(Clone, Debug, PartialEq)]
enum Pattern {
    All,
    None,
    /// From the first corner to the last.
    Diagonal,
    /// What lies within an ellipse or ellipsoid in the middle.
    Disc,
    /// So many of a thousand, the same each time.
    Random(u64),
    /// From the first index to before the last, along each axis.
    Boxes(Vec<Vec<(i64, i64)>>),
}

/// The places of the active elements, in no order: within the shape, or anywhere where there are no bounds.
pub(super) fn elements(text: &str, shape: &[usize], bounded: bool) -> Result<Vec<Place>, LabError> {
    let text = Text { what: "activity", text };
    let all = 0..text.text.len();
    let pattern = parse(text, shape.len())?;
    let boxes = match &pattern {
        Pattern::Boxes(boxes) => boxes.clone(),
        Pattern::None => Vec::new(),
        _ => vec![shape.iter().map(|&extent| (0, extent as i64)).collect()],
    };
    let most = if matches!(pattern, Pattern::Boxes(_) | Pattern::All) { MOST_ACTIVE } else { MOST };
    let cells = boxes.iter().map(|ranges| {
        ranges.iter().fold(1usize, |cells, (from, to)| cells.saturating_mul(usize::try_from(to - from).unwrap_or(0)))
    });
    let cells = cells.fold(0usize, usize::saturating_add);
    if cells > most {
        let message = format!(
            "{cells} elements are more than the {most} that can be looked at; write a smaller shape, or boxes: `0..8,0..8`"
        );
        return Err(text.error(&all, message));
    }
    let mut places = Vec::new();
    for ranges in &boxes {
        let outside = ranges.iter().zip(shape).position(|((from, to), &extent)| *from < 0 || *to > extent as i64);
        if let Some(axis) = outside.filter(|_| bounded) {
            let (from, to) = ranges[axis];
            let (letter, extent) = (super::nodes::AXES[axis], shape[axis]);
            let message = format!(
                "{from}..{to} along axis `{letter}` is outside of the shape; write indices from 0 to before {extent}"
            );
            return Err(text.error(&all, message));
        }
        let starts = ranges.iter().fold(vec![Vec::new()], |starts: Vec<Vec<i64>>, &(from, to)| {
            let with = |start: Vec<i64>| (from..to).map(move |n| start.iter().copied().chain([n]).collect());
            starts.into_iter().flat_map(with).collect()
        });
        let place = |index: Vec<i64>| std::array::from_fn(|axis| index.get(axis).copied().unwrap_or(0));
        places.extend(starts.into_iter().map(place).filter(|place| pattern.holds(place, shape)));
    }
    if places.len() > MOST_ACTIVE {
        let message = format!(
            "{} elements are more than the {MOST_ACTIVE} that can be active; write a smaller shape",
            places.len()
        );
        return Err(text.error(&all, message));
    }
    Ok(places)
}

impl Pattern {
    fn holds(&self, place: &Place, shape: &[usize]) -> bool {
        match self {
            Self::All | Self::None | Self::Boxes(_) => true,
            Self::Diagonal => {
                let shortest = shape.iter().copied().min().unwrap_or(1) as i64;
                let mut parts = shape.iter().zip(place).map(|(&extent, c)| c * shortest / extent.max(1) as i64);
                let first = parts.next();
                parts.all(|part| Some(part) == first)
            }
            Self::Disc => {
                let squares = shape.iter().zip(place).map(|(&extent, &c)| {
                    let from_middle = (c as f64 + 0.5) / extent as f64 - 0.5;
                    from_middle * from_middle
                });
                squares.sum::<f64>() <= 0.16
            }
            Self::Random(share) => {
                // SplitMix64 of the coordinates.
                let mixed = place.iter().fold(0u64, |mixed, &c| {
                    let mut z = mixed.wrapping_add(c as u64).wrapping_add(0x9e37_79b9_7f4a_7c15);
                    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
                    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
                    z ^ (z >> 31)
                });
                mixed % 1000 < *share
            }
        }
    }
}

fn parse(text: Text<'_>, rank: usize) -> Result<Pattern, LabError> {
    let mut tokens = text.tokens()?;
    if tokens.peek(0).kind != Kind::Word {
        return boxes(&mut tokens, rank);
    }
    let word = tokens.take();
    let pattern = match tokens.read(&word) {
        "all" => Pattern::All,
        "none" => Pattern::None,
        "diagonal" => Pattern::Diagonal,
        "disc" => Pattern::Disc,
        "random" => {
            let right = "a share in percent, from 1 to 100, is wanted: `random:10`";
            tokens.wants(':', right)?;
            match tokens.number(right)? {
                (share @ 1..=100, _) => Pattern::Random(share as u64 * 10),
                (_, at) => return Err(text.error(&at, right)),
            }
        }
        name => {
            let meant = match nearest(name, NAMED) {
                Some(near) => format!("did you mean `{near}`?"),
                None => {
                    "there are `all`, `none`, `diagonal`, `disc`, `random:10`, and boxes: `0..8,0..8; 20,30`".into()
                }
            };
            return Err(text.error(&word.at, format!("there is no pattern `{name}`; {meant}")));
        }
    };
    if tokens.peek(0).kind != Kind::End {
        return Err(tokens.error("nothing more is wanted here"));
    }
    Ok(pattern)
}

/// `0..8,0..8; 20,30`
fn boxes(tokens: &mut Tokens<'_>, rank: usize) -> Result<Pattern, LabError> {
    let mut boxes = Vec::new();
    loop {
        let start = tokens.peek(0).at.start;
        let mut ranges = vec![range(tokens)?];
        while tokens.sign(',') {
            ranges.push(range(tokens)?);
        }
        if ranges.len() != rank {
            let at = start..tokens.peek(0).at.start;
            let message = format!(
                "there are {} indices for {rank} axes; write an index or a range an axis: `0..8,3`",
                ranges.len()
            );
            return Err(tokens.text.error(&at, message));
        }
        boxes.push(ranges);
        if !tokens.sign(';') {
            break;
        }
    }
    if tokens.peek(0).kind != Kind::End {
        return Err(tokens.error("`,` and another range, `;` and another box, or nothing is wanted here"));
    }
    Ok(Pattern::Boxes(boxes))
}

/// `3` or `0..8`, the latter without its end.
fn range(tokens: &mut Tokens<'_>) -> Result<(i64, i64), LabError> {
    let start = tokens.peek(0).at.start;
    let from = index(tokens)?;
    if !(tokens.peek(0).kind == Kind::Sign('.') && tokens.peek(1).kind == Kind::Sign('.')) {
        return Ok((from, from + 1));
    }
    tokens.take();
    tokens.take();
    let to = index(tokens)?;
    if to <= from {
        let at = start..tokens.peek(0).at.start;
        return Err(tokens
            .text
            .error(&at, "the range is empty; its end, which is not in it, is larger than its start: `0..8`"));
    }
    Ok((from, to))
}

fn index(tokens: &mut Tokens<'_>) -> Result<i64, LabError> {
    let right = "an index is wanted, as in `0..8,3`, or one of `all`, `none`, `diagonal`, `disc`, `random:10`";
    let negative = tokens.sign('-');
    let (number, at) = tokens.number(right)?;
    let number = i64::try_from(number).ok().map(|number| if negative { -number } else { number });
    // The one after the last index is an `i32`, too.
    number
        .filter(|number| (i64::from(i32::MIN)..i64::from(i32::MAX)).contains(number))
        .ok_or_else(|| tokens.text.error(&at, "the index is no `i32`; write one from -2147483648 to 2147483646"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(text: &str, shape: &[usize]) -> usize {
        elements(text, shape, true).unwrap().len()
    }

    #[test]
    fn patterns_hold_what_they_say() {
        assert_eq!((count("all", &[8, 8]), count("none", &[8, 8]), count("diagonal", &[8, 8])), (64, 0, 8));
        assert_eq!(count("diagonal", &[4, 16]), 16);
        assert_eq!(count("0..2,3; 5,5..8", &[8, 8]), 5);
        let disc = count("disc", &[100, 100]) as f64;
        assert!((disc / (std::f64::consts::PI * 1600.0) - 1.0).abs() < 0.01, "{disc}");
        let random = count("random:10", &[100, 100]);
        assert!((900..1100).contains(&random) && count("random:10", &[100, 100]) == random, "{random}");
        assert_eq!(elements("-3,2147483646", &[4, 4], false).unwrap(), [[-3, 2_147_483_646, 0, 0]]);
    }

    #[test]
    fn what_is_wrong_is_told() {
        for (text, message) in [
            ("disk", "column 1, `disk`: there is no pattern `disk`; did you mean `disc`?"),
            ("0..8", "column 1, `0..8`: there are 1 indices for 2 axes; write an index or a range an axis: `0..8,3`"),
            (
                "0..9,1",
                "column 1, `0..9,1`: 0..9 along axis `i` is outside of the shape; write indices from 0 to before 8",
            ),
            ("4..4,1", "column 1, `4..4`: the range is empty; its end, which is not in it, is larger than its start"),
            ("random:0", "column 8, `0`: a share in percent, from 1 to 100, is wanted: `random:10`"),
            ("1,2 3", "column 5, `3`: `,` and another range, `;` and another box, or nothing is wanted here"),
            ("1,", "column 3: the activity ends here; an index is wanted, as in `0..8,3`"),
            ("9999999999,1", "column 1, `9999999999`: the index is no `i32`"),
        ] {
            let error = elements(text, &[8, 8], true).unwrap_err().to_string();
            assert!(error.starts_with(&format!("activity `{text}`: {message}")), "{error}");
        }
        let error = elements("all", &[2048, 2048], true).unwrap_err().to_string();
        assert!(error.contains("4194304 elements are more than the 1048576 that can be looked at"), "{error}");
    }
}
