//! What memory can do: loops that do hardly anything but move bytes, in plain Rust.

use std::hint::black_box;
use std::thread;

/// How a loop moves bytes, each useful one once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stream {
    /// Reads one array.
    Read,
    /// Reads one array and writes another.
    Scale,
    /// Reads one array, reads and writes another.
    Update,
}

/// Fewer bytes would fit caches that the workload's own may not fit, and threads would take longer to start than to run.
const LEAST: usize = 1 << 26;

/// A loop with its memory.
pub(super) struct Loop {
    stream: Stream,
    threads: usize,
    from: Vec<f32>,
    into: Vec<f32>,
}

impl Loop {
    /// A loop that moves about so many bytes on so many threads.
    pub(super) fn new(stream: Stream, bytes: usize, threads: usize) -> Self {
        let bytes = bytes.max(LEAST);
        let (from, into) = match stream {
            Stream::Read => (bytes / 4, 0),
            Stream::Scale => (bytes / 8, bytes / 8),
            Stream::Update => (bytes / 12, bytes / 12),
        };
        Self { stream, threads, from: vec![0.5; from], into: vec![0.25; into] }
    }

    /// The useful bytes that a run moves.
    pub(super) fn bytes(&self) -> usize {
        let written = if self.stream == Stream::Update { 2 } else { 1 };
        4 * (self.from.len() + written * self.into.len())
    }

    /// Moves them once.
    pub(super) fn run(&mut self) {
        let (factor, stream) = (black_box(1e-9f32), self.stream);
        let part = self.from.len().div_ceil(self.threads);
        let part = part.next_multiple_of(16);
        let (from, into) = (&self.from, &mut self.into);
        if stream == Stream::Read {
            let sum = |values: &[f32]| {
                let mut sums = [0.0f32; 64];
                for values in values.chunks_exact(64) {
                    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
                }
                black_box(sums);
            };
            each(from.chunks(part), sum);
        } else {
            let scale = |(into, from): (&mut [f32], &[f32])| {
                into.iter_mut().zip(from).for_each(|(into, from)| *into = factor * from);
            };
            let update = |(into, from): (&mut [f32], &[f32])| {
                into.iter_mut().zip(from).for_each(|(into, from)| *into += factor * from);
            };
            let parts = into.chunks_mut(part).zip(from.chunks(part));
            if stream == Stream::Scale { each(parts, scale) } else { each(parts, update) }
        }
        black_box(&mut self.into);
    }
}

/// Does something to each part on a thread of its own, the first on this one.
fn each<P: Send>(mut parts: impl Iterator<Item = P>, run: impl Fn(P) + Sync) {
    let Some(first) = parts.next() else { return };
    let run = &run;
    thread::scope(|scope| {
        parts.for_each(|part| drop(scope.spawn(move || run(part))));
        run(first);
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_move_what_they_say() {
        for (stream, arrays) in [(Stream::Read, 1), (Stream::Scale, 2), (Stream::Update, 3)] {
            let mut moved = Loop::new(stream, 0, 3);
            moved.run();
            assert_eq!(moved.bytes() / 4 / arrays, moved.from.len());
            let wanted = if stream == Stream::Scale { 0.5e-9 } else { 0.25 };
            assert!(moved.into.iter().all(|&value| value == wanted), "{stream:?}");
        }
    }
}
