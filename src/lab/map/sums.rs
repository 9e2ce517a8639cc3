//! What a map amounts to.

use super::lines::LINE;
use super::{Mapped, Piece};

/// In a few words: cache lines and bytes, and how many of these hold elements; of a sparse layout, how many blocks there are.
///
/// ```
/// use allotrope_lab::lab::map::{TextMap, summary};
///
/// let map = TextMap::new("x: f64, m: f32", "Aos", Some(&[100]), None).unwrap();
/// assert_eq!(summary(&map), "25 lines, 1,600 bytes, of which 75.0 % hold elements");
/// ```
pub fn summary(map: &dyn Mapped) -> String {
    let pieces = map.pieces();
    let bytes: usize = pieces.iter().map(|piece| piece.bytes).sum();
    let blocks = pieces.iter().filter(|piece| piece.block.is_some()).count();
    if map.is_sparse() {
        let dense = if pieces.len() > blocks { "dense memory and " } else { "" };
        return format!("{} in {dense}{}", size(&pieces), plural(blocks, "allocated block"));
    }
    let record: usize = map.members().iter().map(super::Member::bytes).sum();
    let elements = map.shape().iter().map(|&extent| extent as f64).product::<f64>();
    match bytes {
        0 => size(&pieces),
        _ => {
            // Rounded down: all of them are 100 % alone.
            let share = (1000.0 * elements * record as f64 / bytes as f64).floor() / 10.0;
            format!("{}, of which {share:.1} % hold elements", size(&pieces))
        }
    }
}

/// The lines and bytes of some pieces.
pub(super) fn size(pieces: &[Piece]) -> String {
    let lines: usize = pieces.iter().map(|piece| piece.bytes.div_ceil(LINE)).sum();
    let bytes: usize = pieces.iter().map(|piece| piece.bytes).sum();
    format!("{}, {}", plural(lines, "line"), plural(bytes, "byte"))
}

/// `1 line`, `2,048 lines`
pub(super) fn plural(count: usize, what: &str) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    format!("{text} {what}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::plural;

    #[test]
    fn numbers_are_read_in_threes() {
        let words = [0, 1, 999, 1000, 1_048_576].map(|count| plural(count, "byte"));
        assert_eq!(words, ["0 bytes", "1 byte", "999 bytes", "1,000 bytes", "1,048,576 bytes"]);
    }
}
