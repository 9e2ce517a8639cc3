//! Runs a parallel loop, and records which iterations touch which cells, and how.

use std::collections::{BTreeMap, BTreeSet};

use super::language::*;

/// The values of names.
type Names = BTreeMap<&'static str, Vec<i32>>;

/// What iterations did to a cell, by what it does to others: reads, each group of operators, all else.
#[derive(Default)]
struct Cell {
    readers: BTreeSet<usize>,
    writers: BTreeSet<usize>,
    accumulators: BTreeMap<u8, BTreeSet<usize>>,
}

impl Cell {
    /// Whether what is left in the cell, or what is read from it, depends on the order of iterations.
    fn conflicts(&self) -> bool {
        let kinds = usize::from(!self.readers.is_empty()) + self.accumulators.len();
        let all: BTreeSet<_> =
            self.readers.iter().chain(&self.writers).chain(self.accumulators.values().flatten()).collect();
        all.len() > 1 && (!self.writers.is_empty() || kinds > 1)
    }
}

/// How a cell is touched.
enum Touch {
    Read,
    Write,
    Accumulate(u8),
}

/// Whether to go on with an element.
#[derive(PartialEq, Eq)]
enum Flow {
    On,
    Skip,
}

/// A loop under way.
#[derive(Default)]
struct Run {
    names: Names,
    iteration: usize,
    /// By field, member and place.
    cells: BTreeMap<(usize, u8, Vec<i32>), Cell>,
    /// The top level's variable.
    sum: Cell,
}

/// Whether iterations of a kernel's parallel loops meet in an element in a way that depends on their order.
pub(super) fn conflicts(kernel: &Kernel) -> bool {
    kernel.0.iter().any(item)
}

fn item(item: &Item) -> bool {
    match item {
        Item::Loop(repeat) => parallel(repeat),
        Item::Within(_, items) => items.iter().any(self::item),
    }
}

fn parallel(repeat: &Loop) -> bool {
    let mut run = Run::default();
    for (iteration, place) in places(&repeat.head).into_iter().enumerate() {
        run.iteration = iteration;
        run.bind(&repeat.variables, &place);
        run.all(&repeat.body);
    }
    run.sum.conflicts() || run.cells.values().any(Cell::conflicts)
}

/// The indices of a head.
fn places(head: &Head) -> Vec<Vec<i32>> {
    match head {
        Head::Ranges(ranges) | Head::Unroll(ranges) => boxed(ranges),
        Head::Field(field, part) => {
            let shape = FIELDS[*field].shape;
            let mut places = boxed(&shape.iter().map(|extent| (0, *extent)).collect::<Vec<_>>());
            let inside = |place: &[i32]| place.iter().zip(shape).all(|(at, extent)| 0 < *at && *at < extent - 1);
            places.retain(|place| {
                let parity = place.iter().sum::<i32>() % 2;
                match part {
                    Part::All => true,
                    Part::Interior => inside(place),
                    Part::Border => !inside(place),
                    Part::Checkerboard(colour) => parity == *colour,
                    Part::InteriorCheckerboard(colour) => inside(place) && parity == *colour,
                    Part::Colored(colour) => place.iter().fold(0, |digits, at| 2 * digits + at % 2) == *colour,
                }
            });
            places
        }
    }
}

/// All places in a box.
fn boxed(ranges: &[(i32, i32)]) -> Vec<Vec<i32>> {
    ranges.iter().fold(vec![Vec::new()], |places, (start, end)| {
        let longer = |place: Vec<i32>| (*start..*end).map(move |at| [place.as_slice(), &[at]].concat());
        places.into_iter().flat_map(longer).collect()
    })
}

impl Run {
    fn bind(&mut self, variables: &Variables, place: &[i32]) {
        match variables {
            Variables::Whole(name) => {
                self.names.insert(name, place.to_vec());
            }
            Variables::Tuple(names) => names.iter().zip(place).for_each(|(name, at)| {
                if let Some(name) = name {
                    self.names.insert(name, vec![*at]);
                }
            }),
        }
    }

    fn all(&mut self, body: &[Statement]) -> Flow {
        for statement in body {
            if self.statement(statement) == Flow::Skip {
                return Flow::Skip;
            }
        }
        Flow::On
    }

    fn statement(&mut self, statement: &Statement) -> Flow {
        match statement {
            Statement::Read(access) | Statement::Shown(access) => self.touch(access, &Touch::Read),
            Statement::Write(access, reads) => {
                reads.iter().for_each(|read| self.touch(read, &Touch::Read));
                self.touch(access, &Touch::Write);
            }
            Statement::Update(access, operator, reads) => {
                reads.iter().for_each(|read| self.touch(read, &Touch::Read));
                self.touch(access, &operator.1.map_or(Touch::Write, Touch::Accumulate));
            }
            Statement::Reduce(Operator(_, Some(group))) => {
                self.sum.accumulators.entry(*group).or_default().insert(self.iteration);
            }
            Statement::Reduce(Operator(_, None)) | Statement::Sum(SumUse::Assign) => {
                self.sum.writers.insert(self.iteration);
            }
            Statement::Sum(SumUse::Read) => {
                self.sum.readers.insert(self.iteration);
            }
            Statement::Inner(repeat) => {
                for place in places(&repeat.head) {
                    self.bind(&repeat.variables, &place);
                    // `continue` in an inner loop is of that loop.
                    self.all(&repeat.body);
                }
            }
            Statement::Within(_, body, _) => return self.all(body),
            Statement::When(condition, body) if self.holds(condition) => return self.all(body),
            Statement::Skip(condition) if self.holds(condition) => return Flow::Skip,
            Statement::When(..) | Statement::Skip(_) => {}
        }
        Flow::On
    }

    fn holds(&self, condition: &Condition) -> bool {
        self.term(&condition.0) == condition.1
    }

    fn touch(&mut self, access: &Access, touch: &Touch) {
        let shape = FIELDS[access.field].shape;
        let mut place = self.place(&access.index);
        for (at, extent) in place.iter_mut().zip(shape) {
            match access.boundary {
                Boundary::Checked | Boundary::Or => {}
                Boundary::Clamped => *at = (*at).clamp(0, extent - 1),
                Boundary::Wrapped => *at = at.rem_euclid(*extent),
            }
        }
        // An index outside of the field panics, or gives another value: it touches nothing.
        if !place.iter().zip(shape).all(|(at, extent)| (0..*extent).contains(at)) {
            return;
        }
        // A component is changed by reading and writing its member.
        for member in PATHS[access.path].1 {
            let cell = self.cells.entry((access.field, *member, place.clone())).or_default();
            match touch {
                Touch::Read => cell.readers.insert(self.iteration),
                Touch::Write => cell.writers.insert(self.iteration),
                Touch::Accumulate(group) => cell.accumulators.entry(*group).or_default().insert(self.iteration),
            };
        }
    }

    fn place(&self, index: &Index) -> Vec<i32> {
        match index {
            Index::Whole(name) => self.names[name].clone(),
            Index::Shifted(name, offset) => {
                self.names[name].iter().zip(offset).map(|(at, offset)| at + offset).collect()
            }
            Index::Parts(terms, _) => terms.iter().map(|term| self.term(term)).collect(),
        }
    }

    fn term(&self, term: &Term) -> i32 {
        let of = |name: &'static str| self.names[name][0];
        match *term {
            Term::Name(name) | Term::Cast(name) | Term::Parentheses(name) => of(name),
            Term::Component(name, axis) => self.names[name][axis],
            Term::Constant(value) => value,
            Term::Plus(name, offset) => of(name) + offset,
            Term::Affine(name, factor, offset) => factor * of(name) + offset,
            Term::Sum(a, b) => of(a) + of(b),
            Term::Half(name) => of(name) / 2,
            Term::Turn(name) => 3 - of(name),
        }
    }
}
