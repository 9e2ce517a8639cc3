//! The signs of an SVG picture.

use std::fmt::Write;

/// Units across: a phone's screen is about 360 pixels wide, so that a unit is 0.7 of a pixel there.
pub(super) const WIDTH: f64 = 512.0;

/// Units of a sign of a text of that height, at most on average: who draws the picture chooses the font.
pub(super) const SIGN: f64 = 0.62;

pub(super) const INK: &str = "#111827";
pub(super) const FAINT: &str = "#4b5563";

/// A picture that grows downwards.
#[derive(Debug, Default)]
pub(super) struct Paper {
    body: String,
    /// Where the next thing begins.
    pub(super) y: f64,
}

/// From where a text goes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Side {
    /// To the right.
    Left,
    /// To both sides.
    Middle,
    /// To the left.
    Right,
}

impl Paper {
    /// A rectangle. `style` is attributes.
    pub(super) fn rectangle(&mut self, [x, y, width, height]: [f64; 4], style: &str) {
        let [x, y, width, height] = [x, y, width, height].map(number);
        let _ = writeln!(self.body, r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {style}/>"#);
    }

    /// A line.
    pub(super) fn line(&mut self, from: [f64; 2], to: [f64; 2], style: &str) {
        let [[x1, y1], [x2, y2]] = [from, to].map(|end| end.map(number));
        let _ = writeln!(self.body, r#"<line x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" {style}/>"#);
    }

    /// A line of text on a base line.
    pub(super) fn text(&mut self, [x, y]: [f64; 2], size: f64, side: Side, colour: &str, text: &str) {
        let anchor = match side {
            Side::Left => "",
            Side::Middle => r#" text-anchor="middle""#,
            Side::Right => r#" text-anchor="end""#,
        };
        let [x, y, size] = [x, y, size].map(number);
        let text = escaped(text);
        let _ =
            writeln!(self.body, r#"<text x="{x}" y="{y}" font-size="{size}" fill="{colour}"{anchor}>{text}</text>"#);
    }

    /// Lines of text that break where they are too long, from the left border on. `bold` is of the first.
    pub(super) fn paragraph(&mut self, text: &str, size: f64, colour: &str) {
        for line in broken(text, ((WIDTH - 2.0 * MARGIN) / (size * SIGN)) as usize) {
            self.y += (size * 1.3).round();
            self.text([MARGIN, self.y], size, Side::Left, colour, &line);
        }
    }

    /// The file, with what its title and its description say to who cannot see it.
    pub(super) fn finish(self, title: &str, description: &str) -> String {
        let Self { body, y } = self;
        let (height, title, description) = (number((y + MARGIN).ceil()), escaped(title), escaped(description));
        format!(
            r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{}" style="max-width:100%;height:auto" role="img" font-family="'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif">
<title>{title}</title>
<desc>{description}</desc>
<defs>
<pattern id="padding" width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="5" height="5" fill="#ffffff"/><path d="M0 0V5" stroke="#6b7280" stroke-width="2"/></pattern>
<pattern id="beyond" width="5" height="5" patternUnits="userSpaceOnUse"><rect width="5" height="5" fill="#e5e7eb"/><circle cx="2.5" cy="2.5" r="1" fill="#6b7280"/></pattern>
<pattern id="bits" width="4" height="4" patternUnits="userSpaceOnUse"><rect width="4" height="4" fill="#ffffff"/><path d="M0 0H4M0 0V4" stroke="#111827" stroke-width="1.4"/></pattern>
<pattern id="stripes1" width="6" height="6" patternUnits="userSpaceOnUse"><path d="M0 3H6" stroke="#ffffff" stroke-width="1.6" stroke-opacity="0.75"/></pattern>
<pattern id="stripes2" width="4" height="6" patternUnits="userSpaceOnUse"><path d="M2 0V6" stroke="#111827" stroke-width="1.2" stroke-opacity="0.55"/></pattern>
</defs>
<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>
{body}</svg>
"##,
            number(WIDTH * 1.5)
        )
    }
}

/// Units of the border.
pub(super) const MARGIN: f64 = 12.0;

/// A number without digits that say nothing.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// Text as SVG and HTML write it.
pub(in crate::lab) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A text in lines of so many signs, broken at spaces and behind dots and commas where that is possible.
pub(super) fn broken(text: &str, signs: usize) -> Vec<String> {
    let (mut lines, mut line) = (Vec::new(), String::new());
    let count = |text: &str| text.chars().count();
    for piece in text.split_inclusive([' ', ',', '.']) {
        if !line.is_empty() && count(&line) + count(piece.trim_end()) > signs {
            lines.push(std::mem::take(&mut line).trim_end().to_string());
        }
        line.push_str(piece);
        while count(&line) > signs {
            let rest: String = line.chars().skip(signs).collect();
            line.truncate(line.len() - rest.len());
            lines.push(std::mem::replace(&mut line, rest));
        }
    }
    lines.push(line.trim_end().to_string());
    lines.retain(|line| !line.is_empty());
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([1.0, 2.5, 0.126, -3.0, 100.0].map(number), ["1", "2.5", "0.13", "-3", "100"]);
    }

    #[test]
    fn long_texts_break() {
        assert_eq!(broken("dense(ij).dense(ji, 4).aos", 12), ["dense(ij).", "dense(ji,", "4).aos"]);
        assert_eq!(broken("one two three", 8), ["one two", "three"]);
        assert_eq!(broken("abcdefghij", 4), ["abcd", "efgh", "ij"]);
        assert!(broken("", 4).is_empty());
    }
}
