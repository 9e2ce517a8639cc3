//! `#[kernel(lanes = 16)]`: where bodies are cut.

use super::super::expand;

/// The expansion of a kernel with one loop over `y` in lanes, without spaces.
fn expansion(body: &str) -> String {
    let kernel = format!(
        "fn k(x: &Field<f32, _>, n: &Field<i32, _>, y: &mut Field<f32, _>, a: f32, m: i32) {{ for i in y {{ {body} }} }}"
    );
    let expansion = expand("lanes = 16".parse().unwrap(), kernel.parse().unwrap()).to_string();
    assert!(!expansion.contains("compile_error"), "{expansion}");
    expansion.replace(' ', "")
}

/// How many stretches a body is cut into, how many variables are kept, and how many masks there are.
fn cut(body: &str) -> (usize, usize, usize) {
    let expansion = expansion(body);
    let count = |text: &str| expansion.matches(text).count();
    (count("in__batch.cells()"), count("Lanes::new("), count("Mask::new("))
}

#[test]
fn bodies_are_cut_at_loops() {
    for (body, expected) in [
        ("let mut s = 0.0; for k in 0..m { s += x[k]; } y[i] = s;", (3, 1, 0)),
        // What is the same in all lanes is evaluated once, and not kept.
        ("let top = 2 * m; let mut s = 0.0; for k in 0..top { let b = x[k]; s += b; } y[i] = s;", (3, 1, 0)),
        // Nothing is kept that no later stretch mentions.
        ("let b = x[i]; let mut s = b; for k in 0..m { s += x[k]; } y[i] = s;", (3, 1, 0)),
        // The condition is evaluated before the loop, and with its body.
        ("let mut s = x[i]; while s > 1.0 { s *= 0.5; } y[i] = s;", (4, 1, 1)),
        // A range of each lane's own: its next and last number, two conditions, the body.
        ("let mut s = 0.0; for k in 0..n[i] { s += a; } y[i] = s;", (5, 3, 1)),
        // A branch around a loop, and its condition.
        ("let mut s = 0.0; if x[i] > a { for k in 0..m { s += x[k]; } } y[i] = s;", (4, 1, 1)),
        ("let mut s = 0.0; if x[i] > a { for k in 0..m { s += x[k]; } } else { s = a; } y[i] = s;", (5, 1, 2)),
        // The same for all lanes: no mask.
        ("let mut s = 0.0; if m > 3 { for k in 0..m { s += x[k]; } } y[i] = s;", (3, 1, 0)),
        // Loops that are left early run lane after lane, within a stretch.
        ("let mut s = 0.0; for k in 0..m { s += x[k]; } loop { if s < 1.0 { break; } s *= 0.5; } y[i] = s;", (3, 1, 0)),
    ] {
        assert_eq!(cut(body), expected, "{body}\n{}", expansion(body));
    }
}

#[test]
fn a_variable_that_is_hidden_is_another() {
    let expansion = expansion(
        "let mut s = 0.0; for k in 0..m { s += x[k]; let mut s = x[k] + s; for l in 0..m { s += x[l]; } y[i] += s; } y[i] = s;",
    );
    // The outer one and the inner one, and the value of the inner one.
    assert_eq!(expansion.matches("Lanes::new(").count(), 3, "{expansion}");
}
