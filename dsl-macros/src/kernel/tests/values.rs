//! Values of assignments, aliases, methods, and variables from outside.

use super::body;

#[test]
fn assignments_have_no_value() {
    body("for a in q { let old = (p[n] += 1); }", &["A0210"]);
    body("for a in q { f(p[n] += 1); }", &["A0210"]);
    body("for a in p { let y = p[a] = x; }", &["A0210"]);
    body("let y = u[(0, 0)].max_assign(3.0);", &["A0210"]);
    body(
        "for a in q { if x { p[n] += 1 } else { p[n] += 2 } match x { _ => p[n] += 1 } (p[n] += 1); let f = || p[n] += 1; }",
        &[],
    );
    body("for a in p { (p[a], s) = (x, x); }", &["A0221"]);
    body("[u[(0, 0)], u[(0, 1)]] = [x, x];", &["A0221"]);
}

#[test]
fn members_and_fields_are_no_values() {
    body("for a in p { let m = p.v; }", &["A0213"]);
    body("for a in p { let m = &mut p; }", &["A0213"]);
    body("let m = &u.v;", &["A0213"]);
    body("let g = u;", &["A0213"]);
    body("let y = u.v + 1.0;", &["A0213"]);
    body("for a in p { let y = p.v + x; }", &["A0213"]);
    body("for a in p { f(p.v, x); g(q); h.method(q.v, f(v)); }", &[""; 0]);
    body("for a in p { g(&q); h.method(&mut *p.v); f((q, 1)); }", &["A0214", "A0214", "A0214"]);
    body("for a in p { p.v[a] = f(q.v, p.w, p.v); }", &["A0214"]);
    body("for a in p { p.v[q[a]] += f(p.v, p); }", &["A0214", "A0214"]);
    body("for a in p { p[a] = f(p.w); }", &["A0214"]);
    body("f(p.v, x); f(p); #[serial] for a in p { p.v[a] = f(p.v); }", &[""; 0]);
    body("f(&p.v);", &["A0213"]);
    body("for a in p { let y = if x { q } else { q }; }", &["A0214", "A0214"]);
    body("for a in p { println!(\"{q:?}\"); }", &["A0214"]);
    body("f(u, &mut *p, &v); let y = v.members().v.to_vec();", &[]);
}

#[test]
fn methods_of_fields_and_elements() {
    for method in ["clamped()", "clamped(a, b)", "wrapped(a, b)", "or(a)", "or(a, x, x)"] {
        body(&format!("for a in p {{ p.{method}; }}"), &["A0208"]);
        body(&format!("p.m.{method};"), &["A0208"]);
    }
    body("for a in q { p[n].fetch_add(1); p[n].swap(1); }", &[]);
    body("for a in q { p[n].compare_exchange(1, 2); p.m[q[a]].fetch_or(1); }", &[]);
    body("for a in p { p[a].fetch_add(1); p[a] += 1; let y = p[a]; }", &[]);
    body("for a in q { p[n].fetch_add(1); p[n] += 1; }", &["A0224"]);
    body("for a in q { p.m[n].fetch_add(1); let y = p[q[a]]; }", &["A0224"]);
    body("for a in p { p[q[a]].swap(1); p[a] = 1; }", &["A0224"]);
    body("for a in p { p.m[q[a]].swap(1); p.v[a] = 1; }", &[]);
    body("for a in p { p[a].m = q[n].fetch_add(1); }", &["A0207"]);
    body("#[relaxed] for a in p { p[q[a]].swap(1); p[a] = 1; }", &[]);
    body("#[serial] for a in p { p[q[a]].swap(1); p[a] = 1; } let y = p[0].fetch_add(n);", &[]);
    body("for a in q { p[n].x.fetch_add(1); p[n].fetch_add(1, x); p[n].swap(); }", &["A0225", "A0225", "A0225"]);
    body("for a in q { p[n].compare_exchange(1); }", &["A0225"]);
    body("for a in p { p.fill(x); p.members(); }", &["A0216", "A0216"]);
    body("for a in p { p.m.fill(x); }", &["A0216"]);
    body("for a in p { p[a] = (p.len() + u.shape()[0]) as f32; p[a].swap(0, 1); }", &[]);
    body("p.fill(x); p.get(3).y();", &[]);
}

#[test]
fn reductions_are_only_accumulated() {
    body("for a in p { s += p[a]; s -= x; }", &[]);
    body("for a in p { s.max_assign(p[a]); } for a in p { s += 1.0; } s = 3.0; let y = s;", &[]);
    body("for a in p { s += p[a]; if s > x {} }", &["A0217"]);
    body("for a in p { println!(\"{s}\"); s += p[a]; }", &["A0217"]);
    body("for a in p { s += p[a]; println!(\"{s:?}\"); }", &["A0217"]);
    body("for a in p { s += s; }", &["A0217"]);
    body("for a in p { s += x; s *= x; }", &["A0218"]);
    body("for a in p { s.min_assign(x); s.max_assign(x); }", &["A0218"]);
}

#[test]
fn reductions_into_parts() {
    body("for a in p { s[q[a] as usize] += 1; s[0] -= 1; s.x += x; s += s0; s.y_axis[n] -= x; }", &[]);
    body("let mut t = y; for a in p { t.0 += 1; t.1.max_assign(x); t.2[n] *= 2; t.3.x |= 1; t.3 |= 2; }", &[]);
    body("for a in p { s[n] += 1; s.x *= 2; }", &["A0218"]);
    body("let mut t = y; for a in p { t.0 += 1; t.1 += t.0; }", &["A0217"]);
    body("let mut t = y; for a in p { t.0 += 1; t.0.1 += 2; }", &["A0220"]);
    body("let mut t = y; for a in p { t.0 += 1; t += y; }", &["A0220"]);
    body("for a in p { s[s[0]] += 1; }", &["A0217"]);
    body("for a in p { *s[0] += 1; (*s).x += 1; w.x += 1; }", &["A0219", "A0219", "A0219"]);
    body("for a in p { s[n] /= 2; s.x = 1; }", &["A0219", "A0219"]);
}

#[test]
fn variables_from_outside_are_not_assigned() {
    body("for a in p { s = p[a]; }", &["A0219"]);
    body("for a in p { s /= x; }", &["A0219"]);
    body("for a in p { *w += x; }", &["A0219"]);
    body("for a in p { *w = x; }", &["A0219"]);
    body("let mut t = [0; 3]; for a in p { t[0] = 1; }", &["A0219"]);
    body("for a in p { let mut t = [0; 3]; t[0] = 1; t[1] += 2; t = [1; 3]; let mut s = 0; s += 1; s = 2; }", &[]);
    body("#[serial] for a in p { s = p[a]; *w += s; }", &[]);
}

#[test]
fn move_closures_do_not_access() {
    body("for a in p { let f = move |k: f32| p[a] + k; }", &["A0223"]);
    body("for a in p { let f = move |k: f32| k + x; let g = |k: f32| p[a] + k; }", &[]);
    body("let f = move |k: f32| p[0] + k;", &[]);
}
