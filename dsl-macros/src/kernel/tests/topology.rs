//! What loops may ask of the activity of fields, and do to it.

use super::{body, codes};

#[test]
fn calls_and_their_arguments() {
    body("for a in p { p.activate(a); p.deactivate(a + 1); let y = p.is_active(a); }", &[]);
    body("for a in p { p.m.activate(a); let y = q.m.is_active(a); }", &[]);
    body("for a in q { let k = p.append(a, x); if let Some(k) = p.try_append(n, x) {} p.remove(k); }", &[]);
    body(
        "for a in q { let y = p.len(a) + p.row_len(a) + p.len(); for e in p.row(a) {} for (e, f) in p.row(a) {} }",
        &[],
    );
    body("for a in q { p.append(x); p.activate(); p.deactivate(a, a); p.is_active(); }", &["A0208"; 4]);
    body("for a in q { p.remove(); p.len(a, a); for e in p.row() {} }", &["A0208"; 3]);
    body("for a in q { p.m.append(a, x); p.m.remove(a); for e in p.m.row(a) {} }", &["A0215"; 3]);
    body("for e in p.row(n) {}", &["A0113"]);
    body("#[serial] for e in p.row(n) {} let k = p.append(n, x); p.activate(n); p.remove(k); let y = p.len(n);", &[]);
    body("#[ordered] for t in 0..n { for e in p.row(t) {} }", &["A0113"]);
    for method in ["clear()", "prune()", "retain(f)", "truncate(n)", "reorder_by_key(f)", "fill(x)"] {
        body(&format!("p.{method}; for a in q {{ p.{method}; }}"), &["A0216"]);
    }
}

#[test]
fn changes_through_shared_references() {
    for call in ["append(a, x)", "try_append(a, x)", "remove(a)", "activate(a)", "deactivate(a)"] {
        body(&format!("for a in p {{ q.{call}; }}"), &["A0207"]);
    }
    body("for a in p { let y = q.is_active(a) && q.len(a) > 0; for e in q.row(a) {} }", &[]);
}

#[test]
fn accesses_beside_appends() {
    // Another field, the loop's own elements, and the iteration's own list.
    body("for a in q { p.append(a, q[a]); }", &[]);
    body("for a in p { p.append((), p[a]); p.v[a] = x; p.m[a] += x; }", &[]);
    body(
        "for a in q { u.append(a, x); let y = u[(a, 3)]; u[(a, n)] = x; for e in u.row(a) { let (i, k) = e; u[(a, k)] += x; } }",
        &[],
    );
    // What others may be appending.
    body("for a in p { p.append((), p[a + 1]); }", &["A0226"]);
    body("for a in p { p.append((), x); let y = p.v[n]; }", &["A0226"]);
    body("for a in q { p.append((), x); p[n] += x; }", &["A0226"]);
    body("for a in q { u.append(a, x); let y = u[(n, a)]; }", &["A0226"]);
    body("for a in q { u.append(n, x); let y = u[(a, n)]; }", &["A0226"]);
    body("for a in q { u.append(a, x); let y = u[(a, a)]; }", &["A0226"]);
    // The own list is told by the places of both variables.
    let volume = |body: &str| codes(&format!("fn k(t: &mut Field<R, _, Ijk>, n: i32, x: f32) {{ {body} }}"));
    assert!(volume("for (i, j) in ndrange!(0..n, 0..n) { t.append((i, j), x); let y = t[(i, j, n)]; }").is_empty());
    assert_eq!(volume("for (i, j) in ndrange!(0..n, 0..n) { t.append((j, i), x); let y = t[(i, j, n)]; }"), ["A0226"]);
    assert_eq!(volume("for (i, j) in ndrange!(0..n, 0..n) { t.append((i, n), x); let y = t[(i, j, n)]; }"), ["A0226"]);
    body("for a in q { u.append(a, f(u)); }", &["A0226"]);
    body("#[relaxed] for a in q { p.append((), x); let y = p[n]; }", &["A0226"]);
    body("#[serial] for a in q { p.append((), x); let y = p[n]; }", &[]);
}

#[test]
fn activity_that_others_change() {
    body("for a in p { if p.is_active(a) { p.activate(a + 1); } }", &[]);
    body("for a in p { p[a] = x; let y = p.is_active(a + 1); }", &[]);
    body("for a in p { p.deactivate(a); p.remove(n); let y = p.is_active(a + 1) && p.len(n) > 0; }", &[]);
    body("for a in q { u.append(a, x); let y = u.len(a); for e in u.row(a) {} }", &[]);
    body("for a in p { if p.is_active(a + 1) { p.activate(a); } }", &["A0227"]);
    body("for a in q { p[n] += x; let y = p.is_active(n); }", &["A0227"]);
    body("for a in q { p[a] = x; let y = p.is_active(n); }", &["A0227"]);
    body("for a in q { u.append(a, x); let y = u.len(n); }", &["A0227"]);
    body("for a in q { u.append(a, x); for e in u.row(a + 1) {} }", &["A0227"]);
    body("for a in q { p.activate(n); for b in p {} }", &["A0227"]);
    body("for a in q { p[n] += x; for b in p {} }", &["A0227"]);
    body("for a in q { p.deactivate(n); for b in p {} }", &[]);
}
