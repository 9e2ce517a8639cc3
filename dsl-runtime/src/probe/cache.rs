//! A model of caches: sets of lines, of which the one that was used longest ago goes first.

use super::LINE;

/// A cache: its bytes, and how many lines a set holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cache {
    /// Bytes in all.
    pub bytes: usize,
    /// Lines of a set.
    pub ways: usize,
}

/// The caches that a recording models: what misses the first is looked up in the second. Both hold lines of [`LINE`] bytes, and writes bring lines in as
/// reads do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caches {
    /// The first level.
    pub first: Cache,
    /// The second level.
    pub second: Cache,
}

impl Default for Caches {
    /// 32 KiB of 8 ways before 2 MiB of 16.
    fn default() -> Self {
        Self { first: Cache { bytes: 32 << 10, ways: 8 }, second: Cache { bytes: 2 << 20, ways: 16 } }
    }
}

/// What a cache holds.
#[derive(Debug)]
pub(super) struct Model {
    ways: usize,
    /// The lines of each set, the one used last first; a set is as long as it has ways.
    sets: Vec<Vec<u64>>,
}

impl Model {
    /// An empty cache.
    pub(super) fn new(cache: Cache) -> Result<Self, String> {
        let Cache { bytes, ways } = cache;
        let set = ways.saturating_mul(LINE);
        if ways == 0 || bytes == 0 || !bytes.is_multiple_of(set) {
            return Err(format!(
                "a cache of {bytes} bytes has no whole number of sets of {ways} lines of {LINE} bytes"
            ));
        }
        Ok(Self { ways, sets: vec![Vec::with_capacity(ways); bytes / set] })
    }

    /// Looks a line up, which is there from then on. Whether it was.
    pub(super) fn holds(&mut self, line: u64) -> bool {
        let count = self.sets.len() as u64;
        let set = &mut self.sets[(line % count) as usize];
        match set.iter().position(|&held| held == line) {
            Some(place) => {
                set[..=place].rotate_right(1);
                true
            }
            None => {
                set.truncate(self.ways - 1);
                set.insert(0, line);
                false
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Cache, Model};

    #[test]
    fn lines_used_longest_ago_go_first() {
        // Two sets of two lines: even lines share the first.
        let mut model = Model::new(Cache { bytes: 256, ways: 2 }).unwrap();
        let found: Vec<bool> = [0, 2, 0, 4, 0, 2, 1, 1].into_iter().map(|line| model.holds(line)).collect();
        assert_eq!(found, [false, false, true, false, true, false, false, true]);
    }

    #[test]
    fn a_stream_larger_than_the_cache_misses_every_line() {
        let mut model = Model::new(Cache { bytes: 1 << 12, ways: 8 }).unwrap();
        let misses = (0..2).flat_map(|_| 0..65).filter(|&line| !model.holds(line)).count();
        // Only the one set that five and more streams of nine lines share never holds what comes next.
        assert_eq!(misses, 65 + 9);
    }

    #[test]
    fn caches_have_whole_sets() {
        for (bytes, ways) in [(0, 8), (1000, 8), (4096, 0)] {
            assert!(Model::new(Cache { bytes, ways }).is_err(), "{bytes} bytes, {ways} ways");
        }
    }
}
