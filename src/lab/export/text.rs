//! Small text in pictures: a font of 5 x 8 dots, the lowest below the line, with the few signs that labels of pictures
//! need.

use crate::lab::render::Picture;

/// Dots between the left ends of two signs.
const ADVANCE: usize = 6;

/// Dots of a sign's height.
pub(super) const HEIGHT: usize = 8;

/// The rows of a sign from the top, five bits each, the left dot the highest. What is not known is a frame.
fn rows(sign: char) -> [u8; HEIGHT] {
    match sign {
        ' ' => [0; HEIGHT],
        '0' => [0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110, 0],
        '1' => [0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110, 0],
        '2' => [0b01110, 0b10001, 0b00001, 0b00010, 0b00100, 0b01000, 0b11111, 0],
        '3' => [0b11111, 0b00010, 0b00100, 0b00010, 0b00001, 0b10001, 0b01110, 0],
        '4' => [0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010, 0],
        '5' => [0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110, 0],
        '6' => [0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110, 0],
        '7' => [0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000, 0],
        '8' => [0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110, 0],
        '9' => [0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100, 0],
        '.' => [0, 0, 0, 0, 0, 0b01100, 0b01100, 0],
        ',' => [0, 0, 0, 0, 0, 0b01100, 0b00100, 0b01000],
        '-' => [0, 0, 0, 0b11111, 0, 0, 0, 0],
        '+' => [0, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0, 0],
        '=' => [0, 0, 0b11111, 0, 0b11111, 0, 0, 0],
        'e' => [0, 0, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110, 0],
        'i' => [0b00100, 0, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110, 0],
        'm' => [0, 0, 0b11010, 0b10101, 0b10101, 0b10001, 0b10001, 0],
        'n' => [0, 0, 0b10110, 0b11001, 0b10001, 0b10001, 0b10001, 0],
        'p' => [0, 0, 0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000],
        's' => [0, 0, 0b01110, 0b10000, 0b01110, 0b00001, 0b11110, 0],
        't' => [0b01000, 0b01000, 0b11100, 0b01000, 0b01000, 0b01001, 0b00110, 0],
        'u' => [0, 0, 0b10001, 0b10001, 0b10001, 0b10011, 0b01101, 0],
        _ => [0b11111, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11111, 0],
    }
}

/// Draws a line of text whose upper left corner is at a column and row, each dot `scale` pixels wide; what lies outside
/// of the picture is cut off.
pub(super) fn draw(picture: &mut Picture, text: &str, column: usize, row: usize, scale: usize, colour: [u8; 3]) {
    for (n, sign) in text.chars().enumerate() {
        for (down, bits) in rows(sign).into_iter().enumerate() {
            for across in (0..5).filter(|across| bits >> (4 - across) & 1 == 1) {
                for pixel in 0..scale * scale {
                    let x = column + (n * ADVANCE + across) * scale + pixel % scale;
                    let y = row + down * scale + pixel / scale;
                    if x < picture.width && y < picture.height {
                        picture.rgb[3 * (y * picture.width + x)..][..3].copy_from_slice(&colour);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_drawn_where_they_belong() {
        let mut picture = Picture { width: 14, height: 9, rgb: vec![0; 3 * 14 * 9] };
        draw(&mut picture, "1-7", 1, 1, 1, [255, 255, 255]);
        let drawn: Vec<String> = picture
            .rgb
            .chunks(3 * 14)
            .map(|row| row.chunks(3).map(|pixel| if pixel[0] > 0 { '#' } else { '.' }).collect())
            .collect();
        let wanted = [
            "..............",
            "...#.........#",
            "..##..........",
            "...#..........",
            "...#...#####..",
            "...#..........",
            "...#..........",
            "..###.........",
            "..............",
        ];
        assert_eq!(drawn, wanted);
    }

    #[test]
    fn all_signs_differ() {
        let signs: Vec<char> = " 0123456789.,-+=eimnpstu?".chars().collect();
        for (n, &sign) in signs.iter().enumerate() {
            assert!(signs[..n].iter().all(|&other| rows(other) != rows(sign)), "{sign}");
            assert!(rows(sign).into_iter().all(|row| row < 32), "{sign} is wider than five dots");
        }
    }
}
