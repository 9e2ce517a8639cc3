//! Counts, for programs.

use allotrope::probe::{Cache, LINE, LoopCounts, MemberCounts, Recording};
use serde::{Deserialize, Serialize};

use super::{HeatMap, Plan};

/// What `--json` writes.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Report {
    /// The solver.
    pub solver: String,
    /// The scene.
    pub scene: String,
    /// Steps that were counted, from the scene's start.
    pub steps: u64,
    /// Bytes of a cache line.
    pub line: usize,
    /// Bytes and ways of the modelled caches, the first level first.
    pub caches: [[usize; 2]; 2],
    /// What was touched in each layout.
    pub layouts: Vec<Layout>,
}

/// What was touched in a layout.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Layout {
    /// Its name.
    pub layout: String,
    /// Bytes of all fields after the steps.
    pub bytes: usize,
    /// The loops, in the order in which they first ran.
    pub loops: Vec<Loop>,
    /// How often the lines of each field were touched.
    #[serde(default)]
    pub heat: Vec<HeatMap>,
}

/// What a loop touched, summed over its launches.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Loop {
    /// The kernel.
    pub kernel: String,
    /// The loop's number among the parallel loops of its kernel, from 0.
    pub number: usize,
    /// How many times it was launched.
    pub launches: u64,
    /// Cache lines that both halves of the loop write.
    pub shared_lines: u64,
    /// Member by member, each kind of access apart.
    pub members: Vec<Member>,
}

/// What a loop did to a member by one kind of access.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct Member {
    /// The field, as the kernel calls it.
    pub field: String,
    /// The member's path in the record; empty for a bare element.
    pub member: String,
    /// `read`, `write` or `accumulate`.
    pub access: String,
    /// `own`, `offset` or `computed`.
    pub index: String,
    /// How many times.
    pub count: u64,
    /// Bytes of the values.
    pub bytes: u64,
    /// Distinct cache lines, counted in each launch.
    pub lines: u64,
    /// Distinct bytes, counted in each launch.
    pub useful_bytes: u64,
    /// Misses of the modelled caches, the first level first.
    pub misses: [u64; 2],
}

impl Report {
    pub(super) fn new(plan: &Plan) -> Self {
        let cache = |cache: Cache| [cache.bytes, cache.ways];
        Self {
            solver: plan.solver.name.to_string(),
            scene: plan.name.clone(),
            steps: plan.steps,
            line: LINE,
            caches: [cache(plan.caches.first), cache(plan.caches.second)],
            layouts: Vec::new(),
        }
    }
}

impl Layout {
    /// The counts of a layout.
    pub fn new(layout: &str, bytes: usize, recording: &Recording) -> Self {
        let loops = recording.loops.iter().map(Loop::new).collect();
        Self { layout: layout.to_string(), bytes, loops, heat: recording.heat.iter().map(HeatMap::new).collect() }
    }

    /// The sum over all members of all loops.
    pub fn total(&self) -> Member {
        self.loops.iter().map(Loop::total).fold(Member::default(), Member::with)
    }

    /// Cache lines that both halves of a loop write.
    pub fn shared_lines(&self) -> u64 {
        self.loops.iter().map(|row| row.shared_lines).sum()
    }
}

impl Loop {
    fn new(counts: &LoopCounts) -> Self {
        let &LoopCounts { kernel, number, launches, shared_lines, ref members } = counts;
        let members = members.iter().map(Member::new).collect();
        Self { kernel: kernel.to_string(), number, launches, shared_lines, members }
    }

    /// The sum over all members.
    pub fn total(&self) -> Member {
        self.members.iter().fold(Member::default(), |sum, member| sum.with(member.clone()))
    }
}

impl Member {
    fn new(counts: &MemberCounts) -> Self {
        let &MemberCounts { field, member, access, index, count, bytes, lines, useful_bytes, misses } = counts;
        let (field, member) = (field.to_string(), member.to_string());
        Self {
            field,
            member,
            access: access.to_string(),
            index: index.to_string(),
            count,
            bytes,
            lines,
            useful_bytes,
            misses,
        }
    }

    /// The sum of both counts, which are no single member's.
    fn with(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            bytes: self.bytes + other.bytes,
            lines: self.lines + other.lines,
            useful_bytes: self.useful_bytes + other.useful_bytes,
            misses: [self.misses[0] + other.misses[0], self.misses[1] + other.misses[1]],
            ..Self::default()
        }
    }

    /// The field and the member: `grid.v`, or `u` where the field's elements are bare.
    pub fn path(&self) -> String {
        if self.member.is_empty() { self.field.clone() } else { format!("{}.{}", self.field, self.member) }
    }

    /// Bytes of use in a line; nothing was of use where no line was touched.
    pub fn useful_bytes_a_line(&self) -> f64 {
        if self.lines == 0 { 0.0 } else { self.useful_bytes as f64 / self.lines as f64 }
    }
}
