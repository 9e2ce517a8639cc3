//! A layout at run time: its text is read, and a pen walks the whole tree and puts down one component after another.
//! Nothing here shares a line with the library, which computes addresses from types.

use std::collections::HashMap;

/// What the oracle needs to know of a record's member.
#[derive(Clone, Copy)]
pub(crate) struct Member {
    pub(crate) name: &'static str,
    pub(crate) components: usize,
    pub(crate) bytes: usize,
}

/// Where everything lies: bytes from the start of (element, member, component), and the bytes of it all.
pub(crate) struct Map {
    pub(crate) offsets: HashMap<(Vec<usize>, usize, usize), usize>,
    pub(crate) bytes: usize,
    /// What its start is a multiple of.
    line: usize,
}

/// The axes of a node as written, and the sizes that are.
type Axes = Vec<(usize, Option<usize>)>;

/// A node: its axes in the order of memory, and its size along each.
struct Level {
    axes: Vec<(usize, usize)>,
    /// Whether its cells lie in Z-order.
    curve: bool,
}

/// Members that lie together in a run.
enum Stream {
    Interleaved(Vec<usize>),
    /// A run for each component.
    Split(usize),
}

/// Interprets the text of a layout for a field of this shape.
pub(crate) fn map(text: &str, shape: &[usize], members: &[Member]) -> Map {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let chains = text.split_once(':').map_or(text.as_str(), |(_, chains)| chains);
    let branches: Vec<Map> = split(chains, '+').into_iter().map(|chain| branch(chain, shape, members)).collect();
    // Each branch begins at a cache line, or at what the widest padding asks for.
    let line = branches.iter().map(|branch| branch.line).max().expect("a branch");
    let mut all = Map { offsets: HashMap::new(), bytes: 0, line };
    for branch in branches {
        let start = all.bytes.next_multiple_of(line);
        all.offsets.extend(branch.offsets.into_iter().map(|(at, offset)| (at, start + offset)));
        all.bytes = start + branch.bytes;
    }
    all
}

/// One chain of nodes.
fn branch(chain: &str, shape: &[usize], members: &[Member]) -> Map {
    let mut words = split(chain, '.');
    let place = words.pop().expect("a place");
    let pad: usize = match words.last().and_then(|word| word.strip_prefix("pad")) {
        Some(bytes) => arguments(bytes)[0].parse().expect("bytes"),
        None => 1,
    };
    words.retain(|word| !word.starts_with("pad"));
    let mut nodes: Vec<(bool, Axes)> = words.iter().map(|word| (word.starts_with("morton"), node(word))).collect();
    if nodes[0].1.iter().any(|(_, size)| size.is_some()) {
        nodes.insert(0, (false, nodes[0].1.iter().map(|&(axis, _)| (axis, None)).collect()));
    }
    let inner: Vec<Level> = nodes[1..]
        .iter()
        .map(|(curve, node)| Level {
            axes: node.iter().map(|&(axis, size)| (axis, size.expect("a size"))).collect(),
            curve: *curve,
        })
        .collect();
    let block = |axis| {
        inner.iter().flat_map(|level| &level.axes).filter(|(a, _)| *a == axis).map(|(_, size)| size).product::<usize>()
    };
    let root = Level {
        axes: nodes[0].1.iter().map(|&(axis, _)| (axis, shape[axis].div_ceil(block(axis)))).collect(),
        curve: false,
    };
    let levels: Vec<Level> = std::iter::once(root).chain(inner).collect();
    let widest = members.iter().map(|member| member.bytes).max().expect("members");
    // Runs begin at multiples of the widest scalar; those of a field that is one run a stream, at cache lines.
    let align = if levels.len() == 1 { 64 } else { widest }.max(pad);
    // Interleaved records are padded each.
    let cell = if place == "aos" { pad } else { 1 };
    let mut pen =
        Pen { levels, shape, members, streams: streams(place, members), align, cell, at: 0, offsets: HashMap::new() };
    pen.node(0, vec![0; shape.len()]);
    Map { offsets: pen.offsets, bytes: pen.at, line: pad.max(64) }
}

/// Splits at a character that stands in no brackets.
fn split(text: &str, at: char) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0, 0);
    for (n, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            c if c == at && depth == 0 => {
                parts.push(&text[start..n]);
                start = n + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// What stands between the outermost brackets of a word.
fn arguments(word: &str) -> Vec<&str> {
    let (_, rest) = word.split_once(['(', '[']).expect("arguments");
    split(&rest[..rest.len() - 1], ',')
}

fn node(word: &str) -> Axes {
    let arguments = arguments(word);
    let sizes: Vec<usize> = match arguments.get(1) {
        None => Vec::new(),
        Some(sizes) => sizes.trim_matches(['(', ')']).split(',').map(|size| size.parse().expect("a size")).collect(),
    };
    let axes = arguments[0].chars().map(|letter| "ijkl".find(letter).expect("an axis"));
    axes.enumerate().map(|(n, axis)| (axis, sizes.get(n).or(sizes.first()).copied())).collect()
}

fn streams(place: &str, members: &[Member]) -> Vec<Stream> {
    let all = 0..members.len();
    let number = |name: &str| members.iter().position(|member| member.name == name).expect("a member");
    match place {
        "aos" => vec![Stream::Interleaved(all.collect())],
        "soa" => all.map(|member| Stream::Interleaved(vec![member])).collect(),
        "split" => all.map(Stream::Split).collect(),
        groups => {
            let mut streams = Vec::new();
            for group in arguments(groups) {
                let (apart, together): (Vec<&str>, Vec<&str>) =
                    arguments(group).into_iter().partition(|entry| entry.starts_with("split"));
                if !together.is_empty() {
                    streams.push(Stream::Interleaved(together.into_iter().map(number).collect()));
                }
                streams.extend(apart.into_iter().map(|entry| Stream::Split(number(arguments(entry)[0]))));
            }
            streams
        }
    }
}

struct Pen<'a> {
    levels: Vec<Level>,
    shape: &'a [usize],
    members: &'a [Member],
    streams: Vec<Stream>,
    /// What runs begin at.
    align: usize,
    /// What cells of interleaved members begin at, besides their widest scalar.
    cell: usize,
    at: usize,
    offsets: HashMap<(Vec<usize>, usize, usize), usize>,
}

impl Pen<'_> {
    /// The node of a level whose first element is `origin`.
    fn node(&mut self, level: usize, origin: Vec<usize>) {
        let mut cells = vec![origin];
        for (axis, size, step) in self.steps(level) {
            cells = cells
                .into_iter()
                .flat_map(|cell| {
                    (0..size).map(move |n| {
                        let mut cell = cell.clone();
                        cell[axis] += n * step;
                        cell
                    })
                })
                .collect();
        }
        if level + 1 == self.levels.len() {
            self.innermost(&cells);
        } else {
            for cell in cells {
                self.node(level + 1, cell);
            }
        }
    }

    /// The choices that lead to a cell of a level, the first the slowest: an axis, how many there are, and how far apart.
    fn steps(&self, level: usize) -> Vec<(usize, usize, usize)> {
        let Level { axes, curve } = &self.levels[level];
        let step = |axis: usize| {
            let below = self.levels[level + 1..].iter().flat_map(|level| &level.axes);
            below.filter(|(a, _)| *a == axis).map(|(_, size)| size).product::<usize>()
        };
        if !curve {
            return axes.iter().map(|&(axis, size)| (axis, size, step(axis))).collect();
        }
        // In Z-order each is a half: as many halvings as the longest axis takes, from the finest up.
        let mut halves = Vec::new();
        let mut width = 1;
        while axes.iter().any(|&(_, size)| width < size) {
            let halved = axes.iter().rev().filter(|&&(_, size)| width < size);
            halves.extend(halved.map(|&(axis, _)| (axis, 2, width * step(axis))));
            width *= 2;
        }
        halves.reverse();
        halves
    }

    fn innermost(&mut self, cells: &[Vec<usize>]) {
        let streams = std::mem::take(&mut self.streams);
        for stream in &streams {
            match stream {
                Stream::Interleaved(members) => {
                    let widest = members.iter().map(|&m| self.members[m].bytes).max().expect("a member");
                    for cell in cells {
                        for &m in members {
                            for component in 0..self.members[m].components {
                                self.component(cell, m, component);
                            }
                        }
                        self.at = self.at.next_multiple_of(widest).next_multiple_of(self.cell);
                    }
                    self.at = self.at.next_multiple_of(self.align);
                }
                &Stream::Split(m) => {
                    for component in 0..self.members[m].components {
                        for cell in cells {
                            self.component(cell, m, component);
                        }
                        self.at = self.at.next_multiple_of(self.align);
                    }
                }
            }
        }
        self.streams = streams;
    }

    /// Puts one component down; cells beyond the shape take their room but are no elements.
    fn component(&mut self, cell: &[usize], member: usize, component: usize) {
        if cell.iter().zip(self.shape).all(|(n, extent)| n < extent) {
            let before = self.offsets.insert((cell.to_vec(), member, component), self.at);
            assert_eq!(before, None, "an element lies twice");
        }
        self.at += self.members[member].bytes;
    }
}
