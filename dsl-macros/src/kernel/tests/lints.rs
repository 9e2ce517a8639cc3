//! Warnings.

use super::{diagnose, kernel};

/// Asserts that a body has these warnings and no errors.
#[track_caller]
fn warns(source: &str, expected: &[&str]) {
    // Both fields are written, so that their `&mut` is no matter.
    let found = diagnose(&kernel(&format!("{source} u[(0, 0)] = x; p[0] = x;")));
    let errors: Vec<String> = found.errors().iter().map(|error| error.text()).collect();
    let texts: Vec<String> = found.warnings().iter().map(|warning| warning.text()).collect();
    assert!(errors.is_empty(), "{source}\n{}", errors.join("\n"));
    let codes: Vec<&str> = found.warnings().iter().map(|warning| warning.code().text()).collect();
    assert_eq!(codes, expected, "{source}\n{}", texts.join("\n"));
}

#[test]
fn remainders_of_what_may_be_negative() {
    for index in ["(a - 1) % n", "(a - 2 + 1) % 5", "-a % n", "(1 - a) % n", "((a as i64) - 1) % 4"] {
        warns(&format!("for a in p {{ p[a] = q[{index}]; }}"), &["A0501"]);
        warns(&format!("for a in p {{ let left = {index}; p[a] = q[left]; }}"), &["A0501"]);
    }
    for index in [
        "(a + 1) % n",
        "a % n",
        "(a - 1 + 1) % n",
        "(a as usize - 1) % n",
        "(n - 1) % n",
        "(a - n) % 3",
        "(a - 1).rem_euclid(n)",
    ] {
        warns(&format!("for a in p {{ p[a] = q[{index}]; }}"), &[]);
    }
    warns("for a in p { for k in unroll!(-1..2) { p[a] = q[(a + k) % n]; } }", &["A0501"]);
    warns("for a in p { for k in unroll!(0..2) { p[a] = q[(a + k) % n] + q[(a + 1 - k) % n]; } }", &[]);
    warns(
        "for ij in u { u[ij] = v[(ij - ivec2(1, 0)) % n] + v[(ij + ivec2(0, -1)) % n] + v[(ij - IVec2::X) % n]; }",
        &["A0501"; 3],
    );
    warns("for ij in u { u[ij] = v[(ij + ivec2(1, 0)) % n]; }", &[]);
    warns("for a in p.interior(2) { p[a] = q[(a - 2) % 5] + q[(a - 3) % 5]; }", &["A0501"]);
    warns("for i in 1..n { p[i] = q[(i - 1) % 5] + q[(i - 2) % 5]; }", &["A0501"]);
    warns("for i in n..9 { p[i] = q[(i - 1) % 5]; }", &[]);
    warns("let a = 3; let b = (a - 5) % n;", &[]);
}

#[test]
fn large_unrolled_loops() {
    warns("for a in p { for k in unroll!(0..256) { f(k); } }", &[]);
    warns("for a in p { for k in unroll!(0..257) { f(k); } }", &["A0502"]);
    warns("#[serial] for k in [1] { for (i, j) in unroll!(0..17, 0..=16) { f(j); } }", &["A0502"]);
    warns(
        "for a in p { for k in unroll!(0..20) { for l in unroll!(-9..9) { for m in unroll!(0..2) { f(k); } } } }",
        &["A0502"],
    );
    warns("for a in p { for k in unroll!(0..20) { f(k); } for k in unroll!(0..20) { f(k); } }", &[]);
}

#[test]
fn equal_random_numbers() {
    warns("for a in p { p[a] = random::<f32>(s0, a) + random(s0, a); }", &["A0504"]);
    warns(
        "for a in p { p[a] = allotrope::random(7, (a, 0)) * self::random(7, (a, 0)) * random(7, (a, 0)); }",
        &["A0504"; 2],
    );
    warns("for a in p { p[a] = random(7, (a, 0)) + random(7, (a, 1)); } for a in p { p[a] = random(7, (a, 1)); }", &[]);
    warns("let random = |a, b| a; for a in p { p[a] = random(7, a) + random(7, a); }", &[]);
    warns("for a in p { p[a] = random(a) + random(a); }", &[]);
}

#[test]
fn fields_that_are_only_read() {
    let codes = |body: &str| -> Vec<&str> {
        diagnose(&kernel(body)).warnings().iter().map(|warning| warning.code().text()).collect()
    };
    assert_eq!(codes("for a in q { let y = p[a] + u[(a, 0)]; }"), ["A0503", "A0503"]);
    assert_eq!(codes("let y = p[0];"), ["A0503"]);
    for changed in [
        "p[0] = x;",
        "for a in q { p[n] += p0; }",
        "p.fill(x);",
        "f(&mut *p);",
        "f(p);",
        "m!(p);",
        "println!(\"{p:?}\");",
    ] {
        assert!(codes(&format!("let y = p[0]; {changed}")).is_empty(), "{changed}");
    }
    assert!(codes("").is_empty());
}
