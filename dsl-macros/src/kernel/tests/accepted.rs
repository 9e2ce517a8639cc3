//! Kernels without errors.

use super::body;

#[test]
fn the_top_level_is_plain_rust() {
    body(
        "let y = u[(0, 1)] + x; u[(0, 1)] = u[(1, 1)]; u.m[(0, 0)] += 1.0; if y > x { for a in p { p[a] = y; } }",
        &[],
    );
    body("let f = |k: i32| { for a in p { p[a] = 1.0; p[k] += p[a - 1]; } };", &[]);
    body("match n { 0 => for a in p { p[a] = x; }, _ => {} }", &[]);
    body("loop { for a in p { p[a] = x; } break; }", &[]);
}

#[test]
fn serial_loops_take_anything() {
    body("#[serial] for a in p { p[a] = p[a - 1]; p[n] = x; p[n] /= x; s = x; if s > x { break; } return; }", &[]);
    body("#[serial] for a in ids.iter() { p[*a] = x; }", &[]);
    body("#[serial] for t in 0..n { for a in p { p[a] = p[a + 1]; } }", &[]);
}

#[test]
fn reads_with_a_boundary_rule() {
    body("for (i, j) in u { u[(i, j)] = v.clamped((i - 1, j)) + v.wrapped((i, j + 7)) + v.or((i, j * j), x); }", &[]);
    body("for (i, j) in u { u.m[(i, j)] = u.w.clamped((i - 1, j)) + u.w.or(ivec2(i, n), u.w[(i, j)]); }", &[]);
    body("for a in p { for b in unroll!(-1..2) { p[a] += q.wrapped(a + b); } }", &[]);
    body("let y = u.or((0, n), x) + u.m.clamped((n, n)); #[serial] for a in p { p[a] = p.wrapped(a + 1); }", &[]);
    // They are reads of other iterations' elements.
    body("for (i, j) in u { u[(i, j)] = u.clamped((i - 1, j)); }", &["A0201"]);
    body("for (i, j) in u { u[(i, j)] = u.clamped((i, j)); }", &["A0201"]);
    body("for (i, j) in u { u.m[(i, j)] = u.m.wrapped((i, j + 1)); let y = u.or((0, 0), x); }", &["A0201", "A0201"]);
    body("for a in q { p[n] += q.or(a + 1, p.or(0, x)); }", &["A0203"]);
}

#[test]
fn inner_loops_are_plain() {
    body(
        "for a in p { for b in q { p[a] += q[b]; } for b in ids.iter() { p[a] -= q[*b]; } while x { p[a] = x; } }",
        &[],
    );
    body("for i in 0..n { for (j, k) in ndrange!(0..n, 0..n) { u[(i, j)] += v[(i, k)] * v[(k, j)]; } }", &[]);
    body("for a in p { for (i, j) in unroll!(0..3, 0..3) { u[base + ivec2(i, j)] += q[a]; } }", &[]);
}
