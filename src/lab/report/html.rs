//! Pieces of a page. Whatever is text is escaped here, and nowhere else.

use std::fmt::Write;

use crate::lab::map::escaped;

/// A piece of a page: HTML in which each element that begins ends too.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::lab) struct Html(String);

/// A table: a headline, and rows of as many cells.
#[derive(Clone, Debug, Default)]
pub(in crate::lab) struct Table {
    /// What it shows, for those who cannot see it.
    pub(in crate::lab) caption: String,
    /// The names of its columns.
    pub(in crate::lab) headline: Vec<String>,
    /// How many of the first columns are words; the others are numbers.
    pub(in crate::lab) words: usize,
    /// Rows, and whether they stand out.
    pub(in crate::lab) rows: Vec<(Vec<String>, bool)>,
}

impl Html {
    /// A paragraph. What stands between a pair of back quotes is code.
    pub(in crate::lab) fn paragraph(self, text: &str) -> Self {
        self.line(&format!("<p>{}</p>", inline(text)))
    }

    /// A paragraph that stands out.
    pub(in crate::lab) fn verdict(self, text: &str) -> Self {
        self.line(&format!("<p class=\"verdict\">{}</p>", inline(text)))
    }

    /// A headline in a section.
    pub(in crate::lab) fn heading(self, text: &str) -> Self {
        self.line(&format!("<h3>{}</h3>", inline(text)))
    }

    /// A list of items.
    pub(in crate::lab) fn list(self, items: &[String]) -> Self {
        let items: String = items.iter().map(|item| format!("<li>{}</li>\n", inline(item))).collect();
        self.line(&format!("<ul>\n{items}</ul>"))
    }

    /// Names with what is said about them.
    pub(in crate::lab) fn terms(self, terms: &[(String, String)]) -> Self {
        let terms: String = terms
            .iter()
            .map(|(name, about)| format!("<div><dt>{}</dt><dd>{}</dd></div>\n", inline(name), inline(about)))
            .collect();
        self.line(&format!("<dl>\n{terms}</dl>"))
    }

    /// A table, in a box of its own that scrolls where the screen is narrow.
    pub(in crate::lab) fn table(self, table: &Table) -> Self {
        let cell = |column: usize, tag: &str, scope: &str, text: &str| {
            let class = if column < table.words { "" } else { " class=\"number\"" };
            format!("<{tag}{scope}{class}>{}</{tag}>", inline(text))
        };
        let mut html = format!(
            "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n<table>\n<caption>{}</caption>\n<thead><tr>",
            escaped(&table.caption.replace('`', "")),
            inline(&table.caption)
        );
        for (column, name) in table.headline.iter().enumerate() {
            html += &cell(column, "th", " scope=\"col\"", name);
        }
        html += "</tr></thead>\n<tbody>\n";
        for (cells, stands_out) in &table.rows {
            html += if *stands_out { "<tr class=\"best\">" } else { "<tr>" };
            for (column, text) in cells.iter().enumerate() {
                html += &if column == 0 {
                    cell(column, "th", " scope=\"row\"", text)
                } else {
                    cell(column, "td", "", text)
                };
            }
            html += "</tr>\n";
        }
        self.line(&(html + "</tbody>\n</table>\n</div>"))
    }

    /// A command, and what it is for. Its lines break before options alone.
    pub(in crate::lab) fn command(self, what: &str, command: &str) -> Self {
        let what = inline(what);
        let mut pieces = command.split(" --");
        let first = escaped(pieces.next().unwrap_or_default());
        let options = pieces.map(|option| format!(" <span>--{}</span>", escaped(option)));
        let command = options.fold(first, |command, option| command + &option);
        self.line(&format!(
            "<div class=\"command\"><p>{what}</p><pre tabindex=\"0\"><code>{command}</code></pre></div>"
        ))
    }

    /// A text as it stands, behind a headline that opens it.
    pub(in crate::lab) fn folded(self, headline: &str, text: &str) -> Self {
        let (headline, text) = (inline(headline), escaped(text));
        self.line(&format!("<details><summary>{headline}</summary><pre tabindex=\"0\">{text}</pre></details>"))
    }

    /// What is markup already: a picture, say.
    pub(in crate::lab) fn markup(self, markup: &str) -> Self {
        self.line(markup)
    }

    /// The text of the page.
    pub(in crate::lab) fn text(&self) -> &str {
        &self.0
    }

    fn line(mut self, line: &str) -> Self {
        // Writing into a text cannot fail.
        let _ = writeln!(self.0, "{line}");
        self
    }
}

/// Text as HTML, what stands between a pair of back quotes as code.
pub(in crate::lab) fn inline(text: &str) -> String {
    let pieces: Vec<&str> = text.split('`').collect();
    if pieces.len().is_multiple_of(2) {
        return escaped(text);
    }
    let pieces = pieces.iter().enumerate().map(|(n, piece)| match n % 2 {
        0 => escaped(piece),
        _ => format!("<code>{}</code>", escaped(piece)),
    });
    pieces.collect()
}

/// The text of an SVG file as a part of a page: names of its patterns are its own, by a number that no other picture has, and it tells no address.
pub(in crate::lab) fn svg_part(svg: &str, number: usize) -> String {
    let own = |text: &str, key: &str| text.replace(key, &format!("{key}picture{number}-"));
    own(&own(svg, "id=\""), "url(#").replace(" xmlns=\"http://www.w3.org/2000/svg\"", "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_and_code_is_marked() {
        assert_eq!(inline("a < `b & c`"), "a &lt; <code>b &amp; c</code>");
        assert_eq!(inline("one ` alone"), "one ` alone");
        let html = Html::default().command("x < y", "run 'a<b' --steps 9");
        let wanted = "<p>x &lt; y</p><pre tabindex=\"0\"><code>run 'a&lt;b' <span>--steps 9</span></code></pre>";
        assert!(html.text().contains(wanted), "{html:?}");
    }

    #[test]
    fn tables_have_headlines_for_columns_and_rows() {
        let rows = vec![(vec!["aos".into(), "1.5".into()], true), (vec!["soa".into(), "2".into()], false)];
        let table = Table { caption: "times".into(), headline: vec!["layout".into(), "ms".into()], words: 1, rows };
        let html = Html::default().table(&table);
        assert!(html.text().contains("<th scope=\"col\">layout</th><th scope=\"col\" class=\"number\">ms</th>"));
        assert!(
            html.text().contains("<tr class=\"best\"><th scope=\"row\">aos</th><td class=\"number\">1.5</td></tr>")
        );
    }

    #[test]
    fn pictures_do_not_share_names() {
        let svg = r##"<svg xmlns="http://www.w3.org/2000/svg"><pattern id="bits"/><rect fill="url(#bits)"/></svg>"##;
        let wanted = r##"<svg><pattern id="picture3-bits"/><rect fill="url(#picture3-bits)"/></svg>"##;
        assert_eq!(svg_part(svg, 3), wanted);
    }
}
