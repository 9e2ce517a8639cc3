//! Chooses kernels: likely ones, whose indices are often the iteration's own, so that many are right and many are wrong.

use super::language::*;

/// Numbers that look random and are the same in every run.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }

    fn of<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }

    /// True so many times in a hundred.
    fn percent(&mut self, chance: usize) -> bool {
        self.below(100) < chance
    }
}

/// The names of outermost loops by the number of their axes, and those of the loops inside by depth.
const OUTER: [&str; 3] = ["i", "j", "k"];
const INNER: [[&str; 3]; 2] = [["a", "b", "c"], ["d", "e", "g"]];

/// What wraps loops at the top level; they are launches as before.
const TOP: [&str; 5] = ["if x > 0.0", "while s > x", "#[ordered] for t in 0..n", "if n > 0", "'block:"];

/// What wraps statements in a loop, once, and whether a `continue` inside is still the loop's.
const WRAPPERS: [(&str, &str, bool); 7] = [
    ("if x > 0.0", "}", true),
    ("", "}", true),
    ("match n { 0 => {} _ =>", "} }", true),
    ("let f = ||", "}; f();", false),
    ("let g = |_: f32|", "}; g(x);", false),
    ("while x > 0.0", "}", false),
    ("loop", "break; }", false),
];

/// Makes one kernel after another.
pub(super) struct Generator {
    random: Random,
    /// The two fields that most accesses of the present kernel go to.
    focus: [usize; 2],
    /// The members that most go to.
    path: usize,
    /// The names that the outermost loop binds, alone or together.
    own: Option<Variables>,
    /// All names of single numbers in scope.
    numbers: Vec<&'static str>,
    /// All names of whole indices in scope, with their number of axes.
    wholes: Vec<(&'static str, usize)>,
}

impl Generator {
    pub(super) fn new(seed: u64) -> Self {
        Self { random: Random(seed), focus: [0, 1], path: 0, own: None, numbers: Vec::new(), wholes: Vec::new() }
    }

    pub(super) fn kernel(&mut self) -> Kernel {
        self.focus = [self.random.below(FIELDS.len()), self.random.below(FIELDS.len())];
        self.path = self.random.below(PATHS.len());
        let count = if self.random.percent(30) { 2 } else { 1 };
        Kernel((0..count).map(|_| self.item()).collect())
    }

    fn item(&mut self) -> Item {
        let repeat = Item::Loop(self.outermost());
        if !self.random.percent(20) {
            return repeat;
        }
        let open: &'static str = TOP[self.random.below(TOP.len())];
        Item::Within(open, vec![repeat])
    }

    fn outermost(&mut self) -> Loop {
        (self.numbers, self.wholes) = (Vec::new(), Vec::new());
        let head = if self.random.percent(60) { self.field_head() } else { self.ranges() };
        let variables = self.variables(&head, &OUTER, "at");
        self.own = Some(variables.clone());
        let body = self.body(0, true);
        Loop { head, variables, body }
    }

    fn field(&mut self) -> usize {
        if self.random.percent(80) { *self.random.of(&self.focus.clone()) } else { self.random.below(FIELDS.len()) }
    }

    fn field_head(&mut self) -> Head {
        let field = self.field();
        let axes = FIELDS[field].shape.len();
        let part = match self.random.below(10) {
            _ if axes == 0 => Part::All,
            0 => Part::Interior,
            1 => Part::Border,
            2 => Part::Checkerboard(self.random.below(2) as i32),
            3 => Part::InteriorCheckerboard(self.random.below(2) as i32),
            4 => Part::Colored(self.random.below(1 << axes) as i32),
            _ => Part::All,
        };
        Head::Field(field, part)
    }

    fn range(&mut self) -> (i32, i32) {
        *self.random.of(&[(0, 4), (0, 3), (1, 4), (0, 5)])
    }

    fn ranges(&mut self) -> Head {
        let count = 1 + self.random.below(3);
        Head::Ranges((0..count).map(|_| self.range()).collect())
    }

    /// Names for a head, which come into scope.
    fn variables(&mut self, head: &Head, names: &[&'static str; 3], whole: &'static str) -> Variables {
        let axes = match head {
            Head::Field(field, _) => FIELDS[*field].shape.len(),
            Head::Ranges(ranges) | Head::Unroll(ranges) => ranges.len(),
        };
        let together = matches!(head, Head::Field(..)) && self.random.percent(40);
        if axes == 1 {
            self.numbers.push(names[0]);
            return Variables::Whole(names[0]);
        }
        if axes == 0 || together {
            self.wholes.push((whole, axes));
            return Variables::Whole(whole);
        }
        let mut all: Vec<_> = names[..axes].iter().map(|name| Some(*name)).collect();
        if self.random.percent(4) {
            all[self.random.below(axes)] = None;
        }
        self.numbers.extend(all.iter().flatten());
        Variables::Tuple(all)
    }

    fn body(&mut self, depth: usize, skips: bool) -> Vec<Statement> {
        let count = 1 + self.random.below(3);
        (0..count).map(|_| self.statement(depth, skips)).collect()
    }

    fn statement(&mut self, depth: usize, skips: bool) -> Statement {
        match self.random.below(100) {
            0..22 => Statement::Read(self.read()),
            22..25 => Statement::Shown(self.read()),
            25..50 => {
                let reads = self.reads();
                Statement::Write(self.change(), reads)
            }
            50..72 => {
                let (reads, operator) = (self.reads(), self.operator());
                Statement::Update(self.change(), operator, reads)
            }
            72..76 => {
                let operator = self.operator();
                Statement::Reduce(if operator == FETCH { OPERATORS[0] } else { operator })
            }
            76 => Statement::Sum(*self.random.of(&[SumUse::Read, SumUse::Assign])),
            77..87 if depth < 2 => self.inner(depth),
            87..94 if depth < 2 => {
                let (open, close, through) = *self.random.of(&WRAPPERS);
                Statement::Within(open, self.body(depth + 1, skips && through), close)
            }
            94..97 => match self.condition() {
                Some(condition) => Statement::When(condition, self.body(depth + 1, skips)),
                None => Statement::Read(self.read()),
            },
            97..99 if skips => match self.condition() {
                Some(condition) => Statement::Skip(condition),
                None => Statement::Read(self.read()),
            },
            _ => Statement::Read(self.read()),
        }
    }

    fn inner(&mut self, depth: usize) -> Statement {
        let known = (self.numbers.clone(), self.wholes.clone());
        let head = match self.random.below(3) {
            0 => self.field_head(),
            1 => self.ranges(),
            _ => {
                let count = 1 + self.random.below(2);
                Head::Unroll((0..count).map(|_| *self.random.of(&[(0, 2), (-1, 2)])).collect())
            }
        };
        let whole = ["all", "other"][depth];
        let variables = self.variables(&head, &INNER[depth], whole);
        let body = self.body(depth + 1, true);
        (self.numbers, self.wholes) = known;
        Statement::Inner(Loop { head, variables, body })
    }

    fn condition(&mut self) -> Option<Condition> {
        if self.numbers.is_empty() {
            return None;
        }
        let name = *self.random.of(&self.numbers.clone());
        Some(Condition(Term::Name(name), self.random.below(3) as i32))
    }

    fn operator(&mut self) -> Operator {
        if self.random.percent(60) { OPERATORS[0] } else { *self.random.of(&OPERATORS) }
    }

    fn reads(&mut self) -> Vec<Access> {
        let count = *self.random.of(&[0, 0, 1, 1, 2]);
        (0..count).map(|_| self.read()).collect()
    }

    fn read(&mut self) -> Access {
        let field = self.field();
        let mut access = self.access(field, 45);
        if !FIELDS[field].shape.is_empty() && self.random.percent(12) {
            access.boundary = *self.random.of(&[Boundary::Clamped, Boundary::Wrapped, Boundary::Or]);
        }
        access
    }

    fn change(&mut self) -> Access {
        let mut field = self.field();
        while !FIELDS[field].mutable {
            field = self.random.below(FIELDS.len());
        }
        self.access(field, 80)
    }

    /// An access, at an own index so many times in a hundred.
    fn access(&mut self, field: usize, own: usize) -> Access {
        let path = if self.random.percent(50) { self.path } else { self.random.below(PATHS.len()) };
        let component = if PATHS[path].0 == ".v" && self.random.percent(30) { ".x" } else { "" };
        let axes = FIELDS[field].shape.len();
        let index = if self.random.percent(own) { self.own_index(axes) } else { self.index(axes) };
        Access { field, path, component, index, boundary: Boundary::Checked }
    }

    fn spelling(&mut self) -> Spelling {
        *self.random.of(&[Spelling::Tuple, Spelling::Tuple, Spelling::Array, Spelling::Call, Spelling::New])
    }

    /// An index with the loop's variables in it, in order, and anything beside them.
    fn own_index(&mut self, axes: usize) -> Index {
        match self.own.clone() {
            Some(Variables::Whole(name)) if self.wholes.contains(&(name, axes)) => Index::Whole(name),
            Some(Variables::Whole(name)) if self.numbers.contains(&name) && axes > 0 => self.around(&[name], axes),
            Some(Variables::Tuple(names)) if names.len() <= axes => {
                let names: Vec<_> = names.into_iter().flatten().collect();
                self.around(&names, axes)
            }
            _ => self.index(axes),
        }
    }

    /// Names in their order, and other parts before, between or after them.
    fn around(&mut self, names: &[&'static str], axes: usize) -> Index {
        let mut terms: Vec<_> = names.iter().map(|name| Term::Name(name)).collect();
        if self.random.percent(5) {
            terms.reverse();
        }
        while terms.len() < axes {
            let place = if self.random.percent(85) { terms.len() } else { self.random.below(terms.len() + 1) };
            terms.insert(place, self.term());
        }
        if self.random.percent(5)
            && let Term::Name(name) = terms[0]
        {
            terms[0] = Term::Parentheses(name);
        }
        Index::Parts(terms, self.spelling())
    }

    /// Any index: near the iteration's own, or computed.
    fn index(&mut self, axes: usize) -> Index {
        let wholes: Vec<_> = self.wholes.iter().filter(|(_, found)| *found == axes).map(|(name, _)| *name).collect();
        if !wholes.is_empty() && self.random.percent(70) {
            let name = *self.random.of(&wholes);
            return match self.random.below(3) {
                0 => Index::Whole(name),
                1 if axes > 1 => Index::Shifted(name, (0..axes).map(|_| self.random.below(3) as i32 - 1).collect()),
                _ => Index::Parts((0..axes).map(|axis| Term::Component(name, axis)).collect(), self.spelling()),
            };
        }
        if axes > 0 && self.numbers.len() >= axes && self.random.percent(40) {
            let offset = |random: &mut Random| if random.percent(60) { 0 } else { random.below(5) as i32 - 2 };
            let first = self.random.below(self.numbers.len() - axes + 1);
            let near = (first..first + axes).map(|place| Term::Plus(self.numbers[place], offset(&mut self.random)));
            return Index::Parts(near.collect(), Spelling::Tuple);
        }
        Index::Parts((0..axes).map(|_| self.term()).collect(), self.spelling())
    }

    fn term(&mut self) -> Term {
        if self.numbers.is_empty() || self.random.percent(15) {
            return Term::Constant(self.random.below(3) as i32);
        }
        let (name, other) = (*self.random.of(&self.numbers.clone()), *self.random.of(&self.numbers.clone()));
        match self.random.below(14) {
            0 => Term::Plus(name, 1),
            1 => Term::Plus(name, -1),
            2 => Term::Plus(name, 2),
            3 => Term::Affine(name, 2, 1),
            4 => Term::Affine(name, 1, 0),
            5 => Term::Sum(name, other),
            6 => Term::Half(name),
            7 => Term::Turn(name),
            8 => Term::Cast(name),
            _ => Term::Name(name),
        }
    }
}
