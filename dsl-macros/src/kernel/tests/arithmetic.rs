//! Which bodies are nothing but arithmetic, and may run for elements that are none of the loop's.

use super::super::expand;

fn is_arithmetic(body: &str) -> bool {
    let kernel = format!(
        "fn k(u: &Field<V, _, Ij>, v: &mut Field<V, _, Ij>, n: i32, x: f32, list: &[f32]) {{ \
         let mut s = 0.0; for (i, j) in v {{ {body} }} s }}"
    );
    let expansion = expand("".parse().unwrap(), kernel.parse().unwrap()).to_string();
    assert!(!expansion.contains("compile_error"), "{expansion}");
    expansion.contains("each_or_all")
}

#[test]
fn arithmetic_of_rows() {
    for body in [
        "v[(i, j)] = u[(i - 1, j)] + u[(i + 1, j)] - 2.0 * u[(i, j)];",
        "v.m[(i, j)] *= x;",
        "v.m[(i, j)].y -= u.m[(i, j)].x;",
        "let (a, mut b) = (u[(i, j)].max(0.0).sqrt(), x); b += -a; v[(i, j)] = vec2(a, b).length();",
        "let y = i as f32; v[(i, j)] = y * (n / 2) as f32;",
    ] {
        assert!(is_arithmetic(body), "{body}");
    }
}

#[test]
fn what_could_panic_or_be_seen() {
    for body in [
        // Whole numbers that differ from element to element.
        "v[(i, j)] = (i * j) as f32;",
        "v[(i, j)] = (7 / i) as f32;",
        "v[(i, j)] = f(i);",
        "v[(i, j)] = u[(i, j)] as i32;",
        "v[(i, j)] = u[(i, j)] << 3;",
        // No element of the loop may come by what one of the others would divide by zero in.
        "v[(i, j)] = if u[(i, j)] > x { x } else { (7 / n) as f32 };",
        "if u[(i, j)] < 0.0 { v[(i, j)] = 0.0; }",
        "let y = u[(i, j)] > 0.0 && 7 / n > 3; v[(i, j)] = x;",
        // What is called could do anything.
        "v[(i, j)] = f(u[(i, j)]);",
        "v[(i, j)] = u[(i, j)].of_mine();",
        "assert!(u[(i, j)] > 0.0); v[(i, j)] = x;",
        "let f = |y: f32| y; v[(i, j)] = x;",
        // Other elements, sums, and loops.
        "v[(i, j)] = u[(j, i)];",
        "v[(i, j)] = u[(n, n)];",
        "v[(i, j)] = u.or((i - 1, j), 0.0);",
        "v[(i, j)] = x; s += u[(i, j)];",
        "v[(i, j)] = list[0];",
        "for k in 0..3 { v[(i, j)] = x; }",
        "if u[(i, j)] > x { continue; } v[(i, j)] = x;",
    ] {
        assert!(!is_arithmetic(body), "{body}");
    }
}

/// Whether whole runs are written out apart.
fn is_written_out(body: &str) -> bool {
    let kernel = format!(
        "fn k(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>, m: &M) {{ let mut s = 0; for at in v {{ {body} }} s }}"
    );
    let expansion = expand("".parse().unwrap(), kernel.parse().unwrap()).to_string();
    assert!(!expansion.contains("compile_error"), "{expansion}");
    let (rows, runs) = (expansion.contains(". rows ("), expansion.contains(". runs ("));
    assert!(rows != runs && runs == expansion.contains("each_of_pieces"), "{expansion}");
    rows
}

#[test]
fn calls_behind_branches_are_not_written_out() {
    for body in [
        "v[at] = m.own(u[at]);",
        "if m.own(u[at]) > 0.0 { v[at] = u[at].sqrt(); }",
        "v[at] = if u[at] > 0.0 { f32::from(3u8) } else { u[at].max(1.0) };",
        "s += u32::from(m.own(u[at]));",
    ] {
        assert!(is_written_out(body), "{body}");
    }
    for body in [
        "if u[at] > 0.0 { v[at] = m.own(u[at]); }",
        "if u[at] > 0.0 { v[at] = 0.0; } else { v[at] += own(u[at]); }",
        "v[at] = match u[at] > 0.0 { true => m.own(1.0), false => 0.0 };",
        "if u[at] > 0.0 { s += m.count(u[at]); }",
    ] {
        assert!(!is_written_out(body), "{body}");
    }
}
