//! Random loops against an interpreter that records who touches what: *accepted implies no conflict*.

use std::collections::BTreeMap;

use super::codes;

/// Elements along each axis of the interpreter's `u`.
const SIDES: [i32; 2] = [4, 5];

/// How much larger its `v` is.
const MORE: i32 = 3;

/// What a statement does to an element.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Touch {
    Read,
    Write,
    /// Accumulation, by the group of its operator.
    Accumulate(u8),
}

/// An index as it is written, and where it points for the loop's variables.
type Index = (&'static str, fn(i32, i32) -> (i32, i32));

const OWN: Index = ("(i, j)", |i, j| (i, j));

const INDICES: [Index; 15] = [
    ("(i + 2, j + 1)", |i, j| (i + 2, j + 1)),
    ("(i - 1, j + 1)", |i, j| (i - 1, j + 1)),
    ("(i, j - 3)", |i, j| (i, j - 3)),
    ("(i, j)", |i, j| (i, j)),
    ("(i, j)", |i, j| (i, j)),
    ("(j, i)", |i, j| (j, i)),
    ("(i + 1, j)", |i, j| (i + 1, j)),
    ("(i, j - 1)", |i, j| (i, j - 1)),
    ("(i, 0)", |i, _| (i, 0)),
    ("(n, j)", |_, j| (2, j)),
    ("(i + j, j)", |i, j| (i + j, j)),
    ("(i, i)", |i, _| (i, i)),
    ("(0, 0)", |_, _| (0, 0)),
    ("(perm(i), j)", |i, j| (i / 2, j)),
    ("ivec2(i, j)", |i, j| (i, j)),
];

/// A path, and which of two members it stands for.
const PATHS: [(&str, &[u8]); 3] = [("", &[0, 1]), (".m", &[0]), (".v", &[1])];

/// What follows an access, and what it means.
const ACTIONS: [(&str, Touch); 7] = [
    ("", Touch::Read),
    (" = x", Touch::Write),
    (" += x", Touch::Accumulate(0)),
    (" -= x", Touch::Accumulate(0)),
    (" *= x", Touch::Accumulate(1)),
    (".min_assign(x)", Touch::Accumulate(2)),
    (" /= x", Touch::Write),
];

/// A read with a rule for indices outside, and where it points along an axis of so many elements.
type Rule = (&'static str, fn(i32, i32) -> i32);

const RULES: [Rule; 3] = [
    ("or(INDEX, x)", |at, _| at),
    ("clamped(INDEX)", |at, side| at.clamp(0, side - 1)),
    ("wrapped(INDEX)", |at, side| at.rem_euclid(side)),
];

/// A loop's head and its elements.
struct Head {
    text: &'static str,
    /// Whether it has two variables (else `j` is an inner loop's).
    pairs: bool,
    /// Whether it is over `v`, which is larger than `u`.
    larger: bool,
    /// The border that is left out.
    border: i32,
    /// Whether it is over one colour.
    checkerboard: bool,
}

const HEADS: [Head; 8] = [
    head("for (i, j) in u", true, false, 0, false),
    head("for (i, j) in v", true, true, 0, false),
    head("for (i, j) in ndrange!(0..4, 0..4)", true, false, 0, false),
    head("for i in 0..4", false, false, 0, false),
    head("for (i, j) in u.checkerboard(n)", true, false, 0, true),
    head("for (i, j) in u.interior(1).checkerboard(0)", true, false, 1, true),
    head("for (i, j) in v.checkerboard(n)", true, true, 0, true),
    head("for (i, j) in u.checkerboard(1)", true, false, 0, true),
];

const fn head(text: &'static str, pairs: bool, larger: bool, border: i32, checkerboard: bool) -> Head {
    Head { text, pairs, larger, border, checkerboard }
}

/// A statement of the interpreter.
struct Statement {
    index: Index,
    rule: Option<Rule>,
    members: &'static [u8],
    touch: Touch,
}

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }
}

/// Whether iterations of a loop with these statements meet in an element in a way that depends on their order.
fn conflicts(statements: &[Statement], head: &Head, side: i32, colour: i32) -> bool {
    let mut touched: BTreeMap<(u8, i32, i32), Vec<(i32, Touch)>> = BTreeMap::new();
    let end = if head.larger { side + MORE } else { side };
    let inside = head.border..end - head.border;
    for (i, j) in inside.clone().flat_map(|i| inside.clone().map(move |j| (i, j))) {
        if head.checkerboard && (i + j) % 2 != colour {
            continue;
        }
        // With one loop variable, an iteration has all of its inner loop.
        let iteration = if head.pairs { i * end + j } else { i };
        for Statement { index, rule, members, touch } in statements {
            let (mut a, mut b) = (index.1)(i, j);
            if let Some((_, rule)) = rule {
                (a, b) = (rule(a, side), rule(b, side));
            }
            if (0..side).contains(&a) && (0..side).contains(&b) {
                for member in *members {
                    touched.entry((*member, a, b)).or_default().push((iteration, *touch));
                }
            }
        }
    }
    touched.values().any(|touches| {
        touches.iter().any(|(first, a)| {
            let clash = |b: Touch| match (*a, b) {
                (Touch::Read, Touch::Read) => false,
                (Touch::Accumulate(x), Touch::Accumulate(y)) => x != y,
                _ => true,
            };
            touches.iter().any(|(second, b)| first != second && clash(*b))
        })
    })
}

#[test]
fn accepted_loops_have_no_conflicts() {
    let mut random = Random(7);
    let (mut accepted, mut racing, mut beside) = (0, 0, 0);
    for _ in 0..12000 {
        let head = &HEADS[random.below(HEADS.len())];
        let (mut body, mut statements) = (String::new(), Vec::new());
        for number in 0..1 + random.below(3) {
            let mut index = INDICES[random.below(INDICES.len())];
            let (path, members) = PATHS[random.below(PATHS.len())];
            let mut action = ACTIONS[random.below(ACTIONS.len())];
            // A colour is of interest where its elements are written, and others read.
            if head.checkerboard && random.below(2) == 0 {
                (index, action) = if number == 0 { (OWN, ACTIONS[1]) } else { (index, ACTIONS[0]) };
            }
            let (text, touch) = action;
            let rule = (touch == Touch::Read).then(|| RULES.get(random.below(4)).copied()).flatten();
            let access = match rule {
                Some((rule, _)) => format!("u{path}.{};", rule.replace("INDEX", index.0)),
                None => format!("u{path}[{}]{text};", index.0),
            };
            body += &if touch == Touch::Read { format!("let y{number} = {access} ") } else { format!("{access} ") };
            statements.push(Statement { index, rule, members, touch });
        }
        let body = if head.pairs { body } else { format!("for j in 0..4 {{ {body} }}") };
        let text = head.text;
        let kernel =
            format!("fn k(u: &mut Field<R, _, Ij>, v: &Field<R, _, Ij>, n: i32, x: f32) {{ {text} {{ {body} }} }}");
        let wraps = |statement: &Statement| statement.rule.is_some_and(|rule| rule.0.starts_with("wrapped"));
        let is_accepted = codes(&kernel).is_empty();
        accepted += usize::from(is_accepted);
        for (side, colour) in SIDES.into_iter().flat_map(|side| [(side, 0), (side, 1)]) {
            let conflict = conflicts(&statements, head, side, colour);
            racing += usize::from(conflict);
            // What is wrapped under a checkerboard along an odd axis panics before the loop.
            let panics = head.checkerboard && side % 2 == 1 && statements.iter().any(wraps);
            assert!(!(is_accepted && conflict) || panics, "accepted, but iterations meet: {kernel}");
        }
        let shares = |s: &Statement| s.members.contains(&0);
        let reads_others = |s: &Statement| shares(s) && s.touch == Touch::Read && s.index.0.contains(['+', '-']);
        let writes_own = |s: &Statement| shares(s) && s.touch == Touch::Write && s.index.0 == OWN.0;
        let crosses = statements.iter().any(reads_others) && statements.iter().any(writes_own);
        beside += usize::from(is_accepted && crosses);
    }
    // The test says something only if it saw enough of all.
    assert!(
        accepted > 500 && racing > 500 && beside > 50,
        "{accepted} accepted, {racing} racing, {beside} beside writes"
    );
}
