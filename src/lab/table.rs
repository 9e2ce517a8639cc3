//! Tables of text.

/// Rows of text in aligned columns: the first columns to the left, numbers to the right.
#[derive(Clone, Debug, Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
    left: usize,
}

impl Table {
    /// A table with a headline, of which the first `left` columns are aligned to the left.
    pub fn new(headline: impl IntoIterator<Item = impl Into<String>>, left: usize) -> Self {
        Self { rows: vec![headline.into_iter().map(Into::into).collect()], left }
    }

    /// Appends a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }

    /// The headline, and the other rows.
    pub fn into_parts(mut self) -> (Vec<String>, Vec<Vec<String>>) {
        let rows = self.rows.split_off(1);
        (self.rows.remove(0), rows)
    }

    /// The table's lines, each ended.
    pub fn text(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width =
            |column: usize| self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
        let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
        let mut text = String::new();
        for row in &self.rows {
            let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
                if column < self.left { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            });
            text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
            text.push('\n');
        }
        text
    }
}

/// A number with four digits that count, so that columns of times can be compared at a glance.
pub fn four_digits(value: f64) -> String {
    let digits = (3 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 6);
    format!("{value:.*}", digits as usize)
}

/// Bytes in MiB.
pub fn mebibytes(bytes: u64) -> String {
    format!("{:.2}", bytes as f64 / f64::from(1 << 20))
}

/// A small difference by its size.
pub fn error_digits(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}

/// Rounded to six digits: more are noise, and make the line unreadable.
pub fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits() {
        assert_eq!(four_digits(0.312_345), "0.3123");
        assert_eq!(four_digits(41.238), "41.24");
        assert_eq!(four_digits(0.0), "0.000000");
    }

    #[test]
    fn errors_are_told_by_their_size() {
        assert_eq!((error_digits(0.0), error_digits(3.21e-7)), ("0".into(), "3.2e-7".into()));
    }

    #[test]
    fn six_digits_are_kept() {
        assert_eq!(six_digits(0.123_456_789), 0.123457);
    }

    #[test]
    fn columns_are_aligned() {
        let mut table = Table::new(["layout", "ms"], 1);
        table.row(["aos", "10.5"]);
        table.row(["aosoa16", "9"]);
        assert_eq!(table.text(), "layout     ms\naos      10.5\naosoa16     9\n");
    }
}
