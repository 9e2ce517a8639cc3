//! Which accesses may stand in one loop.

use super::{body, codes, diagnose};

#[test]
fn in_place_stencils() {
    body("for (i, j) in u { u[(i, j)] = u[(i - 1, j)] + u[(i + 1, j)]; }", &["A0201"]);
    body("for ij in u { u[ij] = u[ij + ivec2(1, 0)]; }", &["A0201"]);
    body("for a in p { p[a] += p[perm(a)]; }", &["A0201"]);
    body("for a in p { let y = p.m[a + 1]; p.m[a] *= y; }", &["A0201"]);
    body("for i in 0..n { for j in 0..n { u[(i, j)] = u[(i - 1, j)]; } }", &["A0201"]);
    body("for a in p { p[a].v = p[a - 1].v; }", &["A0201"]);
}

#[test]
fn the_other_colour_beside_writes() {
    let of = |statements: &str, codes: &[&str]| {
        for head in ["u.checkerboard(n)", "u.interior(9).checkerboard(0)", "u.border(n).checkerboard(1)"] {
            body(&format!("for (i, j) in {head} {{ {statements} }}"), codes);
        }
    };
    of("u[(i, j)] = u[(i - 1, j)] + u[(i + 2, j - 1)] + u.or((i, j + 7), x);", &[]);
    of("u[(i, j)] += u.clamped((i - 1, j)) + u.clamped((i, j + 1)) + u.wrapped((i - 1, j + 2));", &[]);
    of("u.m[(i, j)] /= u[(i - 1, j)].m; let y = u.m[(i, j)] + u.v[(n, j)];", &[]);
    of("u[(i, j)] = u[(i - 1, j + 1)];", &["A0201"]);
    of("u[(i, j)] = u.or((i - 2, j), x);", &["A0201"]);
    of("u[(i, j)] = u.wrapped((i, j + 2));", &["A0201"]);
    of("u[(i, j)] = u.clamped((i - 3, j));", &["A0201"]);
    of("u[(i, j)] = u.clamped((i - 2, j + 1));", &["A0201"]);
    of("u[(i, j)] = u.wrapped((i, j));", &["A0201"]);
    of("u[(i, j)] = u[(i + n, j)];", &["A0201"]);
    of("u[(i, j)] = u[(j + 1, i)];", &["A0201"]);
    of("u[(j, i)] = u[(i + 1, j)];", &["A0201"]);
    of("u[(n, n)] += u[(i + 1, j)];", &["A0203"]);
    of("u[(i + 1, j)] = x;", &["A0202"]);
    body("for (i, j) in v.checkerboard(0) { u[(i, j)] = u[(i - 1, j)] + u.or((i, j + 1), x); }", &[]);
    body("for (i, j) in v.checkerboard(0) { u[(i, j)] = u.clamped((i - 1, j)); }", &["A0201"]);
    body("for (i, j) in v.checkerboard(0) { u[(i, j)] = u.wrapped((i - 1, j)); }", &["A0201"]);
    body("for (i, j) in u.colored(2, n) { u[(i, j)] = u[(i - 1, j)]; }", &["A0201"]);
    body("for ij in u.interior(1).checkerboard(0) { u[ij] = u[ij - IVec2::X] + u.or(ij + ivec2(2, 1), x); }", &[]);
    body("for ij in u.checkerboard(0) { u[ij] = u[ij + IVec2::ONE]; }", &["A0201"]);
    body("for a in p.checkerboard(0) { p[a] = p[a + 1] + p.clamped(a - 1) + p.wrapped(a + 3); }", &[]);
}

#[test]
fn plain_scatters() {
    body("for a in q { p[perm[a]] = x; }", &["A0202"]);
    body("for a in q { p[q.id[a]] = x; }", &["A0202"]);
    body("for a in q { p[0] = x; p[n] = x; }", &["A0202", "A0202"]);
    body("for a in p { p[a + 1] = x; }", &["A0202"]);
    body("for (i, j) in u { p[i] = x; }", &["A0202"]);
    body("for (i, j) in u { u[(j, j)] = x; }", &["A0202"]);
    body("for a in p { p[a as usize] = x; }", &["A0202"]);
    body("for a in p { p.m[a * 1].y = x; }", &["A0202"]);
    body("for _ in p { p[0] = x; }", &["A0202"]);
    body("for ij in u { u[(ij.x, ij.y)] = x; }", &["A0202"]);
}

#[test]
fn accumulations_stand_alone() {
    body("for a in q { p[q[a]] += x; p[n] -= x; }", &[]);
    body("for a in p { p.m[q[a]] += x; p.v[a] = p.x[n]; }", &[]);
    body("for a in q { p.m[n] += p.m[0]; }", &["A0203"]);
    body("for a in p { let y = p.m[a]; p.m[n] += y; }", &["A0203"]);
    body("for a in p { p.m[n] += x; let y = p[a]; }", &["A0203"]);
    body("for a in q { p[n] += x; p[n] *= x; }", &["A0204"]);
    body("for a in q { p[n] += x; p[0].max_assign(x); }", &["A0204"]);
    body("for a in q { p[n].min_assign(x); p[0].max_assign(x); }", &["A0204"]);
    body("for a in p { p[n] += x; p[a] *= x; }", &["A0204"]);
    body("for a in p { p[a] = x; p[n] += x; }", &["A0206"]);
    body("for a in q { p[n].y += x; p[a].x_axis[n] -= x; }", &[]);
    body("for a in q { p[n].y += x; p[a].x *= x; }", &["A0204"]);
    body("for a in q { p[n].y += x; let y = p[n].x; }", &["A0203"]);
    body("for a in q { p[n] /= x; p[n] %= 2; p[n] <<= 1; }", &["A0212", "A0212", "A0212"]);
}

#[test]
fn own_accesses_mix() {
    body("for a in p { p[a] = q[a]; p[a] += x; p[a] /= x; p[a].y = p[a].z; p[a].min_assign(x); p.m[a] = x; }", &[]);
    body("for (i, j) in u { u[ivec2(i, j)] = v[[j, i]] + u[(i, j)]; }", &[]);
    body("for i in 0..n { u[(i, 0)] = x; u[(i, n)] = u[(i, q[i])]; }", &[]);
    body("for (i, j) in v { u[(j, i)] = v[(i, j)]; u[(j, i)] += x; }", &[]);
    body("for a in p { p[(a)] = x; p[a + 0] = x; }", &[]);
}

#[test]
fn variables_keep_their_places() {
    body("for (i, j) in u { u[(i, j)] = u[(j, i)]; }", &["A0205"]);
    body("for i in 0..n { u[(i, 0)] = x; u[(0, i)] = x; }", &["A0205"]);
    body("for i in 0..n { u[(i, i)] = x; u[(i, 0)] = x; u[(i, 1)] = x; }", &[]);
    body("for (i, j) in u { let y = v[(i, j)] + v[(j, i)]; }", &[]);
}

#[test]
fn paths_overlap_by_prefix() {
    body("for a in p { p.x[a] = x; let y = p.v[n]; }", &[]);
    body("for a in p { p.x[a] = x; let y = p[n]; }", &["A0201"]);
    body("for a in p { p.node.v[a] = x; let y = p.node[n]; }", &["A0201"]);
    body("for a in p { p.node.v[a] = x; let y = p.node.m[n]; }", &[]);
    body("for a in p { p[a] = r; p.x[n] += x; }", &["A0206"]);
    body("for a in p { let r = p[a]; p.v[a] = x; let y = p.m[n]; }", &[]);
    body("for a in p { p.x[a].y = x; let y = p.x[n].x; }", &["A0201"]);
}

#[test]
fn writes_need_mut_and_indices_their_axes() {
    body("for a in q { q[a] = x; q[a] += x; }", &["A0207"]);
    body("q[0] = x;", &["A0207"]);
    body("for (i, j) in v { v[(i, j)].min_assign(x); }", &["A0207"]);
    body("for a in p { let y = v[a]; }", &["A0208"]);
    body("for ij in u { let y = q[ij]; }", &["A0208"]);
    body("for (i, j) in u { let y = u[i]; }", &["A0208"]);
    body("let y = u[0] + u[(1, 2, 3)] + p[(0, 1)];", &["A0208", "A0208", "A0208"]);
    body("for (i, j, k) in u {}", &["A0208"]);
    body("for (i, j) in p {}", &["A0208"]);
    body("for (i, j) in ndrange!(0..3) {}", &["A0208"]);
    body("let y = u[at] + u[(1, 2)] + u[ivec2(0, 1)] + p[7usize];", &[]);
}

#[test]
fn offsets_stay_within_the_border() {
    body("for (i, j) in u.interior(1) { u[(i, j)] = v[(i - 2, j)]; }", &["A0209"]);
    body("for ij in u.interior(1) { u[ij] = v[ij + ivec2(1, -2)]; }", &["A0209"]);
    body("for (i, j) in u.interior(2) { u[(i, j)] = v[(i - 2, j)]; }", &[]);
    body("for (i, j) in u.interior(w) { u[(i, j)] = v[(i - 2, j)]; }", &[]);
    body("for (i, j) in u { u[(i, j)] = v[(i - 2, j)]; }", &[]);
}

#[test]
fn a_clash_names_the_other_access() {
    let found = diagnose("fn k(u: &mut Field<f32, _>) {\n for i in u {\n u[i] = 2.0;\n let y = u[i + 1];\n } }");
    insta::assert_snapshot!(found.errors()[0].text(), @r#"
`u[i + 1]` is read in a parallel loop that writes `u` [A0201]
= note: `u[i]` is written in line 3, by every iteration at its own index: whether this read comes before or after depends on the threads
= help: read from one field and write to another, and swap the two between calls
= help: or relax in place, one colour after the other: loop over `u.checkerboard(0)` and then `u.checkerboard(1)`
= help: or write `#[serial]` before the loop to run it on one thread
"#);
}

#[test]
fn all_errors_of_a_kernel_come_at_once() {
    body(
        "for a in q { p[n] = x; break; let a = 1; } for i in 0..=3 {} let u = 3;",
        &["A0116", "A0111", "A0120", "A0120", "A0202"],
    );
}

#[test]
fn fields_without_axes_are_one_element_to_all() {
    let of = |body: &str| codes(&format!("fn k(o: &mut Field<R, _, O>, q: &Field<R, _>, n: i32, x: f32) {{ {body} }}"));
    assert_eq!(of("for i in 0..n { o[()] = x; }"), ["A0202"]);
    assert_eq!(of("for a in q { o[()] = q[a]; }"), ["A0202"]);
    assert_eq!(of("for a in q { o.m[()] += q[a]; }"), [""; 0]);
    assert_eq!(of("for a in q { o[()] += q[a]; let y = o[()]; }"), ["A0203"]);
    assert_eq!(of("for at in o { o[at] = 2.0 * o[at]; } o[()] = x;"), [""; 0]);
    assert_eq!(of("o[0] = x; o[()] = x;"), ["A0208"]);
}

#[test]
fn four_ranges_are_the_most() {
    body("for (a, b, c, d) in ndrange!(0..n, 0..n, 0..n, 0..n) { p[a] += x; }", &[]);
    body("for (a, b, c, d, e) in ndrange!(0..n, 0..n, 0..n, 0..n, 0..n) { p[a] += x; }", &["A0111"]);
}
