//! Kernels as trees, and their text. What they mean is told by the interpreter, which shares nothing with the macro.

use std::fmt::{self, Display, Formatter};

/// A kernel's top level.
pub(super) struct Kernel(pub(super) Vec<Item>);

/// What stands at the top level.
pub(super) enum Item {
    Loop(Loop),
    /// Loops inside something serial, which opens with these words.
    Within(&'static str, Vec<Item>),
}

/// A loop; the outermost ones are parallel.
pub(super) struct Loop {
    pub(super) head: Head,
    pub(super) variables: Variables,
    pub(super) body: Vec<Statement>,
}

/// What a loop binds.
#[derive(Clone)]
pub(super) enum Variables {
    /// One name for the whole index.
    Whole(&'static str),
    /// A name an axis, or none.
    Tuple(Vec<Option<&'static str>>),
}

/// What a loop runs over.
#[derive(Clone)]
pub(super) enum Head {
    Field(usize, Part),
    Ranges(Vec<(i32, i32)>),
    /// Constants, unrolled.
    Unroll(Vec<(i32, i32)>),
}

/// A part of a field.
#[derive(Clone, Copy)]
pub(super) enum Part {
    All,
    Interior,
    Border,
    Checkerboard(i32),
    InteriorCheckerboard(i32),
    Colored(i32),
}

/// A field of the kernel.
pub(super) struct Field {
    pub(super) name: &'static str,
    pub(super) mutable: bool,
    /// The type of its axes as written.
    pub(super) axes: &'static str,
    pub(super) shape: &'static [i32],
}

/// The fields. Nobody tells the macro how many axes the last one has.
pub(super) const FIELDS: [Field; 7] = [
    Field { name: "u", mutable: true, axes: "Ij", shape: &[4, 4] },
    Field { name: "v", mutable: true, axes: "Ij", shape: &[4, 4] },
    Field { name: "w", mutable: false, axes: "Ij", shape: &[4, 4] },
    Field { name: "line", mutable: true, axes: "I", shape: &[5] },
    Field { name: "cube", mutable: true, axes: "Ijk", shape: &[3, 3, 3] },
    Field { name: "one", mutable: true, axes: "O", shape: &[] },
    Field { name: "plane", mutable: true, axes: "Plane", shape: &[4, 4] },
];

/// The paths of a record, with the members that lie below each.
pub(super) const PATHS: [(&str, &[u8]); 6] =
    [("", &[0, 1, 2, 3]), (".m", &[0]), (".v", &[1]), (".node", &[2, 3]), (".node.a", &[2]), (".node.b", &[3])];

/// One step of a body.
pub(super) enum Statement {
    Read(Access),
    /// The same as an argument of a macro of the standard library.
    Shown(Access),
    Write(Access, Vec<Access>),
    Update(Access, Operator, Vec<Access>),
    /// An accumulation into the top level's variable.
    Reduce(Operator),
    /// Its value, or an assignment.
    Sum(SumUse),
    Inner(Loop),
    /// Statements inside something that runs once, which opens and closes with these words.
    Within(&'static str, Vec<Statement>, &'static str),
    /// Statements for some iterations alone.
    When(Condition, Vec<Statement>),
    /// `continue` for some iterations.
    Skip(Condition),
}

/// What else is done with the top level's variable.
#[derive(Clone, Copy)]
pub(super) enum SumUse {
    Read,
    Assign,
}

/// Whether something is done, told by a variable.
pub(super) struct Condition(pub(super) Term, pub(super) i32);

/// The operators, and their groups; none for what accumulates nothing.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Operator(pub(super) &'static str, pub(super) Option<u8>);

pub(super) const OPERATORS: [Operator; 9] = [
    Operator("+=", Some(0)),
    Operator("-=", Some(0)),
    Operator("*=", Some(1)),
    Operator("min_assign", Some(2)),
    Operator("max_assign", Some(3)),
    Operator("|=", Some(4)),
    Operator("/=", None),
    Operator("<<=", None),
    FETCH,
];

/// It returns the old value: elements have it, and reductions have not.
pub(super) const FETCH: Operator = Operator("fetch_add", Some(5));

/// One element, or a component of one.
pub(super) struct Access {
    pub(super) field: usize,
    /// The number of its path.
    pub(super) path: usize,
    /// `.x` or nothing.
    pub(super) component: &'static str,
    pub(super) index: Index,
    /// For reads alone.
    pub(super) boundary: Boundary,
}

/// What an index outside of the field means.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Boundary {
    Checked,
    Clamped,
    Wrapped,
    Or,
}

/// An index.
pub(super) enum Index {
    /// A name that stands for a whole index, alone.
    Whole(&'static str),
    /// The same plus constants.
    Shifted(&'static str, Vec<i32>),
    /// Part by part, with the words around.
    Parts(Vec<Term>, Spelling),
}

#[derive(Clone, Copy)]
pub(super) enum Spelling {
    Tuple,
    Array,
    Call,
    New,
}

/// A part of an index.
#[derive(Clone)]
pub(super) enum Term {
    Name(&'static str),
    /// A component of a name that stands for a whole index.
    Component(&'static str, usize),
    Constant(i32),
    /// `name + c`, `c + name` or `name - c`.
    Plus(&'static str, i32),
    /// `a * name + b`.
    Affine(&'static str, i32, i32),
    Sum(&'static str, &'static str),
    /// A function that halves.
    Half(&'static str),
    /// A function that turns the numbers round.
    Turn(&'static str),
    /// `name as i32`.
    Cast(&'static str),
    Parentheses(&'static str),
}

/// The letters of components.
const LETTERS: [&str; 3] = ["x", "y", "z"];

fn list<T: Display>(f: &mut Formatter<'_>, items: impl IntoIterator<Item = T>) -> fmt::Result {
    items.into_iter().enumerate().try_for_each(|(place, item)| {
        if place > 0 {
            f.write_str(", ")?;
        }
        write!(f, "{item}")
    })
}

impl Display for Kernel {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("fn k(")?;
        for field in &FIELDS {
            let borrow = if field.mutable { "&mut " } else { "&" };
            write!(f, "{}: {borrow}Field<R, _, {}>, ", field.name, field.axes)?;
        }
        f.write_str("n: i32, x: f32, mut s: f32) { ")?;
        self.0.iter().try_for_each(|item| write!(f, "{item}"))?;
        f.write_str("}")
    }
}

impl Display for Item {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Item::Loop(repeat) => write!(f, "{repeat}"),
            Item::Within(open, items) => {
                write!(f, "{open} {{ ")?;
                items.iter().try_for_each(|item| write!(f, "{item}"))?;
                f.write_str("} ")
            }
        }
    }
}

impl Display for Loop {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str("for ")?;
        match &self.variables {
            Variables::Whole(name) => f.write_str(name)?,
            Variables::Tuple(names) => {
                f.write_str("(")?;
                names.iter().try_for_each(|name| write!(f, "{}, ", name.unwrap_or("_")))?;
                f.write_str(")")?;
            }
        }
        write!(f, " in {} {{ ", self.head)?;
        self.body.iter().try_for_each(|statement| write!(f, "{statement} "))?;
        f.write_str("} ")
    }
}

impl Display for Head {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let ranges = |f: &mut Formatter<'_>, ranges: &[(i32, i32)]| {
            list(f, ranges.iter().map(|(start, end)| format!("{start}..{end}")))
        };
        match self {
            Head::Field(field, part) => {
                f.write_str(FIELDS[*field].name)?;
                match part {
                    Part::All => Ok(()),
                    Part::Interior => f.write_str(".interior(1)"),
                    Part::Border => f.write_str(".border(1)"),
                    Part::Checkerboard(colour) => write!(f, ".checkerboard({colour})"),
                    Part::InteriorCheckerboard(colour) => write!(f, ".interior(1).checkerboard({colour})"),
                    Part::Colored(colour) => write!(f, ".colored(2, {colour})"),
                }
            }
            Head::Ranges(all) if all.len() == 1 => ranges(f, all),
            Head::Ranges(all) => {
                f.write_str("ndrange!(")?;
                ranges(f, all)?;
                f.write_str(")")
            }
            Head::Unroll(all) => {
                f.write_str("unroll!(")?;
                ranges(f, all)?;
                f.write_str(")")
            }
        }
    }
}

/// The right side of an assignment.
fn value(reads: &[Access]) -> String {
    reads.iter().fold("x".to_owned(), |text, read| format!("{text} + {read}"))
}

impl Display for Statement {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Statement::Read(access) => write!(f, "let y = {access};"),
            Statement::Shown(access) => write!(f, "assert!({access} > x, \"{{x}} {{}}\", n);"),
            Statement::Write(access, reads) => write!(f, "{access} = {};", value(reads)),
            Statement::Update(access, operator, reads) => update(f, access, *operator, &value(reads)),
            Statement::Reduce(operator) => update(f, &"s", *operator, "x"),
            Statement::Sum(SumUse::Read) => f.write_str("let z = s + x;"),
            Statement::Sum(SumUse::Assign) => f.write_str("s = x;"),
            Statement::Inner(repeat) => write!(f, "{repeat}"),
            Statement::Within(open, body, close) => {
                write!(f, "{open} {{ ")?;
                body.iter().try_for_each(|statement| write!(f, "{statement} "))?;
                write!(f, "{close}")
            }
            Statement::When(condition, body) => {
                write!(f, "if {condition} {{ ")?;
                body.iter().try_for_each(|statement| write!(f, "{statement} "))?;
                f.write_str("}")
            }
            Statement::Skip(condition) => write!(f, "if {condition} {{ continue; }}"),
        }
    }
}

fn update(f: &mut Formatter<'_>, target: &dyn Display, operator: Operator, value: &str) -> fmt::Result {
    if operator.0.ends_with('=') {
        write!(f, "{target} {} {value};", operator.0)
    } else {
        write!(f, "{target}.{}({value});", operator.0)
    }
}

impl Display for Condition {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} == {}", self.0, self.1)
    }
}

impl Display for Access {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (name, path) = (FIELDS[self.field].name, PATHS[self.path].0);
        let (index, component) = (&self.index, self.component);
        match self.boundary {
            Boundary::Checked => write!(f, "{name}{path}[{index}]{component}"),
            Boundary::Clamped => write!(f, "{name}{path}.clamped({index}){component}"),
            Boundary::Wrapped => write!(f, "{name}{path}.wrapped({index}){component}"),
            Boundary::Or => write!(f, "{name}{path}.or({index}, x){component}"),
        }
    }
}

impl Display for Index {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Index::Whole(name) => f.write_str(name),
            Index::Shifted(name, offset) => {
                write!(f, "{name} + ivec{}(", offset.len())?;
                list(f, offset)?;
                f.write_str(")")
            }
            Index::Parts(terms, _) if terms.is_empty() => f.write_str("()"),
            Index::Parts(terms, Spelling::Tuple) if terms.len() == 1 => write!(f, "{}", terms[0]),
            Index::Parts(terms, spelling) => {
                let size = terms.len();
                let (open, close) = match spelling {
                    Spelling::Call if size > 1 => (format!("ivec{size}("), ")"),
                    Spelling::New if size > 1 => (format!("IVec{size}::new("), ")"),
                    Spelling::Tuple => ("(".to_owned(), ")"),
                    _ => ("[".to_owned(), "]"),
                };
                f.write_str(&open)?;
                list(f, terms)?;
                f.write_str(close)
            }
        }
    }
}

impl Display for Term {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Term::Name(name) => f.write_str(name),
            Term::Component(name, axis) => write!(f, "{name}.{}", LETTERS[*axis]),
            Term::Constant(value) => write!(f, "{value}"),
            Term::Plus(name, offset) if *offset < 0 => write!(f, "{name} - {}", -offset),
            Term::Plus(name, offset) if offset % 2 == 0 => write!(f, "{offset} + {name}"),
            Term::Plus(name, offset) => write!(f, "{name} + {offset}"),
            Term::Affine(name, factor, offset) => write!(f, "{factor} * {name} + {offset}"),
            Term::Sum(a, b) => write!(f, "{a} + {b}"),
            Term::Half(name) => write!(f, "half({name})"),
            Term::Turn(name) => write!(f, "turn({name})"),
            Term::Cast(name) => write!(f, "{name} as i32"),
            Term::Parentheses(name) => write!(f, "({name})"),
        }
    }
}
