//! The few colours of a frame of a GIF: chosen so that they lie where its colours are, and mixed by dots where they are
//! still too far apart.

type Colour = [i32; 3];

/// What differences of red, green and blue count: eyes see those of green best.
const WEIGHTS: Colour = [3, 4, 2];

/// A mix of two entries is worth its dots if they lie no further apart than by this: its square counts so many times
/// less than the square of what the mix is off by.
const ROUGHNESS: f32 = 0.15;

/// The thresholds of ordered dither (Bayer 1973) in 4 x 4 pixels, in sixteenths.
const THRESHOLDS: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

fn colour(rgb: u32) -> Colour {
    [rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255].map(|component| component as i32)
}

/// The weighted inner product of two differences.
fn product(a: Colour, b: Colour) -> i32 {
    (0..3).map(|c| WEIGHTS[c] * a[c] * b[c]).sum()
}

fn minus(a: Colour, b: Colour) -> Colour {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// How a colour is shown: by the first entry, or by the second where its share is above the threshold of a pixel.
#[derive(Clone, Copy, Debug)]
struct Mix {
    first: u8,
    second: u8,
    /// Of the second, up to a half.
    share: f32,
}

/// Colours with their weight, and how much they differ.
struct Group {
    colours: Vec<(u32, f64)>,
    spread: f64,
    axis: usize,
    middle: f64,
}

impl Group {
    fn new(colours: Vec<(u32, f64)>) -> Self {
        let total: f64 = colours.iter().map(|(_, weight)| weight).sum();
        let measure = |axis: usize| {
            let (mut sum, mut squares) = (0.0, 0.0);
            for &(rgb, weight) in &colours {
                let component = f64::from(colour(rgb)[axis]);
                sum += weight * component;
                squares += weight * component * component;
            }
            (f64::from(WEIGHTS[axis]) * (squares - sum * sum / total), sum / total)
        };
        let measures = [measure(0), measure(1), measure(2)];
        let axis = (0..3).max_by(|&a, &b| measures[a].0.total_cmp(&measures[b].0)).unwrap_or(0);
        let spread = if colours.len() > 1 { measures.iter().map(|(spread, _)| spread).sum() } else { 0.0 };
        Self { colours, spread, axis, middle: measures[axis].1 }
    }

    /// Its mean.
    fn mean(&self) -> [u8; 3] {
        let total: f64 = self.colours.iter().map(|(_, weight)| weight).sum();
        std::array::from_fn(|c| {
            let sum: f64 = self.colours.iter().map(|&(rgb, weight)| weight * f64::from(colour(rgb)[c])).sum();
            (sum / total).round() as u8
        })
    }

    fn halves(self) -> [Self; 2] {
        let (low, high) = self.colours.iter().partition(|(rgb, _)| f64::from(colour(*rgb)[self.axis]) <= self.middle);
        [Self::new(low), Self::new(high)]
    }
}

/// The entries of a palette, and how each colour of a frame is shown by them.
pub(super) struct Palette {
    pub(super) entries: Vec<[u8; 3]>,
    /// In the order of the colours.
    mixes: Vec<(u32, Mix)>,
}

impl Palette {
    /// At most `most` entries (up to 256) for the colours of pixels, `0xrrggbb`, which are sorted: the group of colours
    /// that differ most is halved at its mean until there are enough (after Heckbert 1982 and Wu 1991).
    pub(super) fn of(mut pixels: Vec<u32>, most: usize) -> Self {
        pixels.sort_unstable();
        // Rare colours count more than their pixels do: the little ground that something leaves behind is to look as
        // the ground around it, which was shown by the many entries of the first frame.
        let colours: Vec<(u32, f64)> =
            pixels.chunk_by(|a, b| a == b).map(|run| (run[0], (run.len() as f64).powf(0.7))).collect();
        let mut groups = vec![Group::new(colours.clone())];
        while groups.len() < most {
            let widest = (0..groups.len()).max_by(|&a, &b| groups[a].spread.total_cmp(&groups[b].spread));
            match widest {
                Some(widest) if groups[widest].spread > 0.0 => {
                    let halves = groups.swap_remove(widest).halves();
                    groups.extend(halves);
                }
                _ => break,
            }
        }
        let entries: Vec<[u8; 3]> = groups.iter().map(Group::mean).collect();
        let places: Vec<Colour> = entries.iter().map(|entry| entry.map(i32::from)).collect();
        let mixes = colours.into_iter().map(|(rgb, _)| (rgb, mix(&places, colour(rgb)))).collect();
        Self { entries, mixes }
    }

    /// The entry that shows a colour, which was among those that the palette was made of, at a pixel.
    pub(super) fn entry(&self, rgb: u32, column: usize, row: usize) -> u8 {
        let Ok(place) = self.mixes.binary_search_by_key(&rgb, |(known, _)| *known) else {
            return 0;
        };
        let Mix { first, second, share } = self.mixes[place].1;
        let threshold = (f32::from(THRESHOLDS[row % 4][column % 4]) + 0.5) / 16.0;
        if share > threshold { second } else { first }
    }
}

/// The nearest entry, and the one that together with it comes nearest.
fn mix(entries: &[Colour], wanted: Colour) -> Mix {
    let distance = |n: usize| {
        let off = minus(wanted, entries[n]);
        product(off, off)
    };
    let first = (0..entries.len()).min_by_key(|&n| distance(n)).unwrap_or(0);
    let mut best = (distance(first) as f32, Mix { first: first as u8, second: first as u8, share: 0.0 });
    if best.0 == 0.0 {
        return best.1;
    }
    let off = minus(wanted, entries[first]);
    for second in 0..entries.len() {
        let step = minus(entries[second], entries[first]);
        let (along, square) = (product(off, step) as f32, product(step, step) as f32);
        if along > 0.0 {
            let share = (along / square).min(0.5);
            let left = product(off, off) as f32 - 2.0 * share * along + share * share * square;
            let cost = left + ROUGHNESS * share * square;
            if cost < best.0 {
                best = (cost, Mix { first: first as u8, second: second as u8, share });
            }
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_exactly() {
        let colours: Vec<u32> = (0..200).map(|n| n * 0x01_03_05 % 0xff_ffff).collect();
        let palette = Palette::of(colours.repeat(3), 255);
        assert_eq!(palette.entries.len(), 200);
        for (n, &rgb) in colours.iter().enumerate() {
            let entry = palette.entries[usize::from(palette.entry(rgb, n, n / 7))];
            assert_eq!(entry.map(i32::from), colour(rgb));
        }
    }

    #[test]
    fn a_dark_gradient_is_shown_in_dots_whose_mean_is_right() {
        // 48 dark blues beside thousands of other colours.
        let dark = |column: usize| 0x0b0f1a + (column as u32 / 8) * 0x01_01_01;
        let other = (0..4096u32).map(|n| ((n % 16) << 20) | ((n / 16 % 16) << 12) | ((n / 256) << 4));
        let pixels: Vec<u32> = (0..384 * 64).map(|n| dark(n % 384)).chain(other).collect();
        let palette = Palette::of(pixels, 255);
        assert_eq!(palette.entries.len(), 255);
        for left in (0..384).step_by(8) {
            let mut sums = [0; 3];
            for n in 0..64 {
                let entry = palette.entries[usize::from(palette.entry(dark(left), left + n % 8, n / 8))];
                sums = std::array::from_fn(|c| sums[c] + i32::from(entry[c]));
            }
            let off = minus(colour(dark(left)), sums.map(|sum| sum / 64));
            assert!(off.iter().all(|off| off.abs() <= 3), "{left}: {off:?}");
        }
    }

    #[test]
    fn an_empty_frame_has_a_palette_too() {
        assert_eq!(Palette::of(Vec::new(), 255).entries.len(), 1);
    }
}
