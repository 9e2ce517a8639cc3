//! Random loops against an interpreter that records who touches what: *accepted implies no conflict*.

use std::collections::BTreeMap;

use super::codes;

/// Elements along each axis of the interpreter's fields.
const SIDE: i32 = 4;

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

const INDICES: [Index; 12] = [
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

/// A loop's head, whether it has two variables (else `j` is an inner loop's).
const HEADS: [(&str, bool); 4] = [
    ("for (i, j) in u", true),
    ("for (i, j) in v", true),
    ("for (i, j) in ndrange!(0..4, 0..4)", true),
    ("for i in 0..4", false),
];

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % n
    }
}

/// Whether iterations of a loop with these statements meet in an element in a way that depends on their order.
fn conflicts(statements: &[(Index, &[u8], Touch)], pairs: bool) -> bool {
    let mut touched: BTreeMap<(u8, i32, i32), Vec<(i32, Touch)>> = BTreeMap::new();
    for i in 0..SIDE {
        for j in 0..SIDE {
            // With one loop variable, an iteration has all of its inner loop.
            let iteration = if pairs { i * SIDE + j } else { i };
            for ((_, place), members, touch) in statements {
                let (a, b) = place(i, j);
                if (0..SIDE).contains(&a) && (0..SIDE).contains(&b) {
                    for member in *members {
                        touched.entry((*member, a, b)).or_default().push((iteration, *touch));
                    }
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
    let (mut accepted, mut racing) = (0, 0);
    for _ in 0..6000 {
        let (head, pairs) = HEADS[random.below(HEADS.len())];
        let (mut body, mut statements) = (String::new(), Vec::new());
        for number in 0..1 + random.below(3) {
            let index = INDICES[random.below(INDICES.len())];
            let (path, members) = PATHS[random.below(PATHS.len())];
            let (text, touch) = ACTIONS[random.below(ACTIONS.len())];
            let access = format!("u{path}[{}]{text};", index.0);
            body += &if touch == Touch::Read { format!("let y{number} = {access} ") } else { format!("{access} ") };
            statements.push((index, members, touch));
        }
        let body = if pairs { body } else { format!("for j in 0..4 {{ {body} }}") };
        let kernel =
            format!("fn k(u: &mut Field<R, _, Ij>, v: &Field<R, _, Ij>, n: i32, x: f32) {{ {head} {{ {body} }} }}");
        let conflict = conflicts(&statements, pairs);
        racing += usize::from(conflict);
        if codes(&kernel).is_empty() {
            accepted += 1;
            assert!(!conflict, "accepted, but iterations meet: {kernel}");
        }
    }
    // The test says something only if it saw enough of both.
    assert!(accepted > 500 && racing > 500, "{accepted} accepted, {racing} racing");
}
