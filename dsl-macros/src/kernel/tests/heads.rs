//! Loop heads, attributes and jumps.

use super::body;

#[test]
fn the_list_of_heads_is_closed() {
    for head in [
        "a in u",
        "ij in u",
        "(i, j) in u",
        "(i, j) in u.interior(1)",
        "i in 0..n",
        "i in 0..n as usize",
        "i in (0..3)",
    ] {
        body(&format!("for {head} {{ let _ = 1; }}"), &[]);
    }
    for head in [
        "i in (0..n).rev()",
        "i in [0, 1]",
        "i in ids.iter()",
        "i in u.iter()",
        "i in &u",
        "i in x",
        "i in u.interior()",
    ] {
        body(&format!("for {head} {{ let _ = 1; }}"), &["A0110"]);
    }
    body("for i in u.m { u.m[i] = 1; } for i in u.m.interior(1) { u.v[i] += v.m[i]; }", &[]);
    body("for i in unroll!(0..3) { let _ = 1; }", &["A0110"]);
    body("for i in ndrange!(0..3, 0..4) {}", &[]);
}

#[test]
fn ranges_are_half_open() {
    body("for i in 0..=n {}", &["A0111"]);
    body("for i in 0.. {}", &["A0111"]);
    body("for (i, j) in ndrange!(0..3, 0..=4) {}", &["A0111"]);
    body("for (i, j, k, l, m) in ndrange!(0..3, 0..4, 0..5, 0..6, 0..7) {}", &["A0111"]);
    body("#[serial] for i in 0..=n {}", &[]);
    body("for a in p { for b in 0..=n {} }", &[]);
    body("for a in p { for (b, c) in ndrange!(0..n, 1..) {} }", &["A0111"]);
}

#[test]
fn patterns_are_names() {
    for pattern in ["mut a", "ref a", "a @ _", "P { a }", "(a, mut b)", "(a, (b, c))", "&a", "[a, b]"] {
        body(&format!("for {pattern} in u {{}}"), &["A0112"]);
    }
    body("for _ in u {}", &[]);
    body("for (_, j) in u {}", &[]);
    body("for a in p { for (mut b, c) in v {} }", &[]);
}

#[test]
fn parts_of_fields() {
    let heads = [
        "u.border(1)",
        "u.border(n)",
        "u.checkerboard(0)",
        "u.checkerboard(n & 1)",
        "u.colored(2, 1)",
        "u.interior(1).checkerboard(0)",
        "u.interior(n).colored(n, n)",
        "u.border(2).checkerboard(1)",
    ];
    for head in heads {
        body(&format!("for (i, j) in {head} {{ u[(i, j)] += v[(i, j)]; }}"), &[]);
        body(&format!("#[serial] for (i, j) in {head} {{ u[(i, j)] = u.clamped((i - 1, j)); }}"), &[]);
        body(&format!("for a in p {{ for (i, j) in {head} {{ p[a] += v[(i, j)]; }} }}"), &[]);
    }
    for head in ["u.border()", "u.checkerboard()", "u.colored(2)", "u.checkerboard(0).checkerboard(1)"] {
        body(&format!("for (i, j) in {head} {{}}"), &["A0110"]);
    }
    body("for (i, j) in u.checkerboard(0).interior(1) {}", &["A0110"]);
    body("for (i, j) in u.m.checkerboard(0) {} for (i, j) in u.m.border(1).colored(2, n) {}", &[]);
    body("for (i, j) in u.interior(1).checkerboard(n) { u[(i, j)] = v[(i - 2, j)]; }", &["A0209"]);
    body("for (i, j) in u.border(1) { u[(i, j)] = v[(i - 2, j)]; }", &[]);
    body("for (i, j) in u.checkerboard(0) { u[(i, j)] = u[(i - 1, j - 1)]; }", &["A0201"]);
}

#[test]
fn the_body_of_an_ordered_loop_is_top_level() {
    body("#[ordered] for t in 0..n { for a in p { p[a] += 1.0; } for a in q { s += q[a]; } if s > x { break; } }", &[]);
    body("#[ordered] for t in (0..n).rev() { p[t] = p[t + 1]; for a in p { p[a] *= t as f32; } return; }", &[]);
    body("#[ordered] for t in 0..n { #[ordered] for a in p { p[a] = x; for i in 0..n { p[i] = x; } } }", &[]);
    body("#[ordered] for t in 0..n { for a in p { p[a] = p[a + 1]; } }", &["A0201"]);
    body("#[ordered] for t in 0..n { for a in p { break; } }", &["A0116"]);
    body("#[serial] for t in 0..n { #[ordered] for r in 0..n { for a in p { p[a] = p[a + 1]; } } }", &[]);
    body("for a in p { #[ordered] for t in 0..n { p[a] += q[t]; } }", &[]);
}

#[test]
fn scatter_names_a_schedule_of_a_parallel_loop() {
    for schedule in [
        "Serial",
        "Atomic",
        "Private",
        "Colored",
        "Auto",
        "Colored, key = q[a] as i32",
        "Colored, reach = 3",
        "Colored, reach = 0, key = a + 1,",
    ] {
        body(&format!("#[scatter({schedule})] for a in q {{ p[n] += q[a]; }}"), &[]);
    }
    for attribute in [
        "#[scatter]",
        "#[scatter(Fast)]",
        "#[scatter(Private, reach = 3)]",
        "#[scatter(Colored, key)]",
        "#[scatter(Colored, key = 1, key = 2)]",
        "#[scatter(Colored, tile = 8)]",
        "#[scatter(Colored, reach = n)]",
        "#[scatter(Colored, reach = -1)]",
        "#[scatter(Colored, key = { continue; a })]",
        "#[scatter = 1]",
    ] {
        body(&format!("{attribute} for a in q {{ p[n] += q[a]; }}"), &["A0115"]);
    }
    // Nothing is accumulated, and nothing is to be sorted.
    body("#[scatter(Colored, key = q[a] as i32)] for a in p { p[a] = q[a]; }", &[]);
    body("#[scatter(Atomic)] #[serial] for a in q { p[n] += q[a]; }", &["A0115"]);
    body("for a in q { #[scatter(Atomic)] for b in 0..3 { p[n] += q[a]; } }", &["A0115"]);
}

#[test]
fn nothing_leaves_a_parallel_loop() {
    for escape in ["break", "return", "return x", "f()?", "f().await", "if x { break }", "{ 'b: { return } }"] {
        body(&format!("for a in p {{ {escape}; }}"), &["A0116"]);
    }
    body("'a: while true { for a in p { break 'a; } }", &["A0116"]);
    body("'a: while true { for a in p { continue 'a; } }", &["A0116"]);
    body("'a: for a in p { for b in 0..3 { break 'a; } }", &["A0116"]);
    body("for a in p { loop { return; } }", &["A0116"]);
    body("for a in p { println!(\"{}\", f()?); }", &["A0116"]);
}

#[test]
fn jumps_inside_are_plain() {
    body("'a: for a in p { for b in 0..3 { continue 'a; } }", &[]);
    body("for a in p { loop { break; } while x { continue; } let y = 'b: { break 'b 1 }; }", &[]);
    body("for a in p { let f = || { return 1; }; let g = |x| Some(x?); }", &[]);
    body("for a in p { for b in unroll!(0..3) { if x { continue; } break; } }", &[]);
    body("if x { return; } for a in p {} f()?; #[serial] for a in p { break; } while x { break; }", &[]);
}

#[test]
fn jumps_cannot_leave_a_loop_over_unknown_axes() {
    body(
        "for a in p { for o in unroll!(X, 0..3) { if x { continue; } for k in 0..2 { break; } loop { break; } } }",
        &[],
    );
    body("for a in p { 'o: for o in unroll!(X, 0..3) { for k in 0..2 { continue 'o; } } }", &[]);
    body("for a in p { for o in unroll!(X, 0..3) { break; } }", &["A0117"]);
    body("'a: for a in p { for o in unroll!(X, 0..3) { continue 'a; } }", &["A0117"]);
    body("for a in p { 'k: for k in 0..2 { for o in unroll!(X, 0..3) { break 'k; } } }", &["A0117"]);
    body("for a in p { 'k: for k in unroll!(0..2) { for o in unroll!(X, 0..3) { continue 'k; } } }", &["A0117"]);
    body("for a in p { for o in unroll!(X, 0..3) { return; } }", &["A0116"]);
    body(
        "#[serial] for a in p { for o in unroll!(X, 0..3) { return; } for o in unroll!(X, 0..3) { f()?; } }",
        &["A0117"; 2],
    );
    body("let f = || { for o in unroll!(X, 0..3) { let g = || { return 3; }; } return 4; };", &[]);
}

#[test]
fn unroll_takes_literals() {
    body("for a in p { for b in unroll!(0..n) {} }", &["A0117"]);
    body("for a in p { for b in unroll!(N) {} }", &["A0118"]);
    body("for a in p { for b in unroll!(0..3, 0..3) {} }", &["A0117"]);
    body("for a in p { for (b, mut c) in unroll!(0..3, 0..3) {} }", &["A0117"]);
    body("for a in p { for b in unroll!(x, 0..3) {} }", &["A0118"]);
    body("for a in p { for (b, c) in unroll!(X, 0..3) {} }", &["A0117"]);
    body("for a in p { for b in unroll!() {} }", &["A0118"]);
    body("for a in p { let b = unroll!(0..3); }", &["A0118"]);
    body("for i in ndrange!(n) {}", &["A0118"]);
    body("for a in p { ndrange!(0..3); }", &["A0118"]);
    body("for a in p { for (b, c) in unroll!(-1..2, -1..=1) {} }", &[]);
}

#[test]
fn the_outermost_loop_is_the_parallel_one() {
    body("for t in 0..n { for a in p { p[a] += 1.0; } for a in q { p[a] = q[a]; } }", &["A0119"]);
    body("for t in 0..n { for i in 1..9 { for j in 1..9 { u[(i, j)] = v[(i - 1, j)]; } } }", &["A0119"]);
    body("let mut t = 0; while t < n { for a in p { p[a] += 1.0; } t += 1; }", &[]);
    body("for i in 0..n { for j in 0..n { u[(i, j)] = 1.0; } }", &[]);
    body("for i in 0..n { for j in 0..n { p[j] += 1.0; } }", &[]);
}
