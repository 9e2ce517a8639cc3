//! Rebinding, and macros that could rebind.

use super::body;

#[test]
fn loop_variables_are_not_bound_again() {
    for inner in [
        "let a = 0;",
        "let (a, b) = (0, 1);",
        "for a in 0..3 {}",
        "for (a, b) in unroll!(0..3, 0..3) {}",
        "let f = |a: i32| a;",
        "if let Some(a) = f() {}",
        "while let Some(a) = f() {}",
        "match f() { a => {} }",
        "match f() { P { a, .. } | Q(a @ 1, ..) => {} _ => {} }",
        "let Some(a) = f() else { continue };",
        "println!(\"{}\", { let a = 1; a });",
    ] {
        let count = if inner.contains("Q(a") { 2 } else { 1 };
        body(&format!("for a in p {{ {inner} }}"), &vec!["A0120"; count]);
    }
    body("for (i, j) in u { let j = 1; }", &["A0120"]);
    body("for a in p { let _ = matches!(f(), Some(a)); }", &["A0120"]);
    body("let a = 1; for a in p {} let a = 2;", &[]);
    body("for a in p { fn f(a: i32) -> i32 { let a = a; a } }", &[]);
}

#[test]
fn fields_and_reductions_are_not_bound_again() {
    body("let u = 1;", &["A0120"]);
    body("for u in p {}", &["A0120"]);
    body("for a in p { let q = q[a]; }", &["A0120"]);
    body("let mut t = 0.0; for a in p { t += 1.0; let t = 1; }", &["A0120"]);
    body("let mut t = 0.0; for a in p { t += 1.0; } let t = 1;", &[]);
}

#[test]
fn unknown_macros_get_no_names() {
    for call in [
        "skip!(a, 0);",
        "put! { p }",
        "let x = f(by!([a]));",
        "my!(\"{a}\");",
        "s += 1.0; show!(s);",
        "let bind!(a) = 1;",
        "f(|by!(a)| 1);",
    ] {
        body(&format!("for a in p {{ {call} }}"), &["A0121"]);
    }
    body("for a in p { macro_rules! m { () => { p[0] = 1.0 } } }", &["A0122"]);
    body("for a in p { macro_rules! m { () => { 1 } } let y = m!(); other!(x, y); }", &[]);
    body("my!(u); macro_rules! m { () => { u } }", &[]);
}

#[test]
fn known_macros_are_expressions() {
    body("for a in p { assert!(q[a] > 0.0, \"{a} {:?}\", q[a]); println!(\"{x:>n$}\"); }", &[]);
    body("for a in p { let y = vec![q[a]; 3]; let z = matches!(q[a], b if b > x); dbg!(q[a]); }", &[]);
    body("for a in p { p[a] = 1.0; println!(\"{}\", p[a + 1]); }", &["A0201"]);
    body("for a in p { p[a] = 1.0; assert_eq!(p[a + 1], x, \"why\"); }", &["A0201"]);
    body("for a in p { std::println!(\"{}\", { p[0] = 1.0; 3 }); }", &["A0202"]);
}
