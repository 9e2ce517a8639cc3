//! A recording as it grows.

use std::collections::HashMap;

use super::cache::Model;
use super::{Access, Caches, Heat, Index, LINE, LoopCounts, MemberCounts, Recording};

/// A piece of memory that a field lies in: all of a dense field, a block of a sparse one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Region {
    pub(crate) start: usize,
    pub(crate) bytes: usize,
}

/// An access to a member of a field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    pub(crate) field: &'static str,
    pub(crate) member: &'static str,
    pub(crate) access: Access,
    pub(crate) index: Index,
    pub(crate) region: Region,
    /// Where the member's first component lies.
    pub(crate) address: usize,
    /// How many components there are, of how many bytes, and how far apart.
    pub(crate) components: usize,
    pub(crate) scalar: usize,
    pub(crate) step: usize,
}

/// Accesses that are counted together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Kind {
    field: &'static str,
    member: &'static str,
    access: Access,
    index: Index,
}

/// The bytes of lines that were touched in a launch, a bit each.
type Lines = HashMap<u64, u64>;

#[derive(Debug)]
struct Loop {
    counts: LoopCounts,
    places: HashMap<Kind, usize>,
    /// Member by member.
    lines: Vec<Lines>,
    /// Which halves of the loop have written a line.
    written: HashMap<u64, u8>,
}

/// Memory as it is told: addresses are those of a machine on which fields lie in the order in which they are first touched.
#[derive(Debug)]
struct Told {
    field: &'static str,
    /// Where it begins, and where it really does.
    first: u64,
    bytes: usize,
    touches: Vec<u32>,
}

/// What fields begin at a multiple of, as far as the model is told: a page.
const PAGE: u64 = 4096;

#[derive(Debug)]
pub(super) struct Trace {
    loops: Vec<Loop>,
    numbers: HashMap<(&'static str, usize), usize>,
    /// The loops that run, the innermost last.
    running: Vec<usize>,
    /// Which half of its blocks a loop is at.
    pub(super) half: u8,
    told: Vec<Told>,
    /// The last piece of memory that begins at an address.
    regions: HashMap<usize, usize>,
    next: u64,
    caches: [Model; 2],
}

impl Trace {
    pub(super) fn new(caches: &Caches) -> Result<Self, String> {
        Ok(Self {
            loops: Vec::new(),
            numbers: HashMap::new(),
            running: Vec::new(),
            half: 0,
            told: Vec::new(),
            regions: HashMap::new(),
            next: PAGE,
            caches: [Model::new(caches.first)?, Model::new(caches.second)?],
        })
    }

    /// A loop begins.
    pub(super) fn enter(&mut self, kernel: &'static str, number: usize) {
        let place = *self.numbers.entry((kernel, number)).or_insert_with(|| {
            let counts = LoopCounts { kernel, number, launches: 0, shared_lines: 0, members: Vec::new() };
            self.loops.push(Loop { counts, places: HashMap::new(), lines: Vec::new(), written: HashMap::new() });
            self.loops.len() - 1
        });
        self.loops[place].counts.launches += 1;
        self.running.push(place);
        self.half = 0;
    }

    /// The loop that began last ends.
    pub(super) fn leave(&mut self) {
        let Some(place) = self.running.pop() else { return };
        let Loop { counts, lines, written, .. } = &mut self.loops[place];
        counts.shared_lines += written.drain().filter(|&(_, halves)| halves == 3).count() as u64;
        for (member, lines) in counts.members.iter_mut().zip(lines) {
            member.lines += lines.len() as u64;
            member.useful_bytes += lines.drain().map(|(_, bytes)| u64::from(bytes.count_ones())).sum::<u64>();
        }
    }

    /// The number of a piece of memory.
    fn region(&mut self, field: &'static str, region: Region) -> usize {
        match self.regions.get(&region.start) {
            Some(&known) if self.told[known].bytes >= region.bytes => known,
            _ => {
                // Blocks of sparse fields lie side by side, as in the slabs that they come from; fields begin at pages.
                let (lines, bytes) = (region.bytes.div_ceil(LINE), region.bytes as u64);
                let unit = if bytes < PAGE { LINE as u64 } else { PAGE };
                let first = self.next.next_multiple_of(unit);
                self.told.push(Told { field, first, bytes: region.bytes, touches: vec![0; lines] });
                self.next = first + bytes.next_multiple_of(unit);
                self.regions.insert(region.start, self.told.len() - 1);
                self.told.len() - 1
            }
        }
    }

    /// A value is touched.
    pub(super) fn touch(&mut self, touch: &Touch) {
        let Some(&running) = self.running.last() else { return };
        let Touch { field, member, access, index, region, address, components, scalar, step } = *touch;
        let told = self.region(field, region);
        let row = &mut self.loops[running];
        let place = *row.places.entry(Kind { field, member, access, index }).or_insert_with(|| {
            let (count, bytes, lines, useful_bytes, misses) = (0, 0, 0, 0, [0; 2]);
            row.counts.members.push(MemberCounts {
                field,
                member,
                access,
                index,
                count,
                bytes,
                lines,
                useful_bytes,
                misses,
            });
            row.lines.push(Lines::new());
            row.counts.members.len() - 1
        });
        let counts = &mut row.counts.members[place];
        counts.count += 1;
        counts.bytes += (components * scalar) as u64;
        let Told { first, touches, .. } = &mut self.told[told];
        for component in 0..components {
            let offset = (address + component * step).wrapping_sub(region.start);
            let end = offset + scalar;
            // Where records are packed a component may lie in two lines.
            for line in offset / LINE..=(end - 1) / LINE {
                let (begin, last) = (offset.max(line * LINE) % LINE, (end - 1).min(line * LINE + LINE - 1) % LINE);
                let told = *first / LINE as u64 + line as u64;
                *row.lines[place].entry(told).or_insert(0) |= u64::MAX >> (LINE - 1 - last) & u64::MAX << begin;
                if let Some(touches) = touches.get_mut(line) {
                    *touches = touches.saturating_add(1);
                }
                if access != Access::Read {
                    *row.written.entry(told).or_insert(0) |= 1 << self.half;
                }
                if !self.caches[0].holds(told) {
                    counts.misses[0] += 1;
                    counts.misses[1] += u64::from(!self.caches[1].holds(told));
                }
            }
        }
    }

    /// What was recorded.
    pub(super) fn finish(mut self) -> Recording {
        while !self.running.is_empty() {
            self.leave();
        }
        let mut heat: Vec<Heat> = Vec::new();
        for told in self.told {
            match heat.iter_mut().find(|known| known.field == told.field) {
                Some(known) => known.touches.extend(told.touches),
                None => heat.push(Heat { field: told.field, touches: told.touches }),
            }
        }
        Recording { loops: self.loops.into_iter().map(|row| row.counts).collect(), heat }
    }
}
