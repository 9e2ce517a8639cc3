//! `#[kernel(contract)]`: which sums are contracted.

/// How many sums of a kernel with one loop over `y` are contracted.
fn contracted(options: &str, body: &str) -> usize {
    let kernel = format!("fn k(x: &Field<f32, _>, y: &mut Field<f32, _>, a: f32) {{ for i in y {{ {body} }} }}");
    let expansion = super::super::expand(options.parse().unwrap(), kernel.parse().unwrap()).to_string();
    assert!(!expansion.contains("compile_error"), "{expansion}");
    expansion.matches("Contracted").count()
}

#[test]
fn products_in_sums_are_contracted() {
    for (body, count) in [
        ("y[i] = a * x[i] + 1.0;", 1),
        ("y[i] = 1.0 + a * x[i];", 1),
        ("y[i] = a * x[i] - 1.0;", 1),
        ("y[i] = 1.0 - (a * x[i]);", 1),
        // Of two products one is rounded with the other.
        ("y[i] = a * x[i] + x[i] * x[i];", 1),
        ("y[i] = (a * x[i] + 1.0) * a + x[i];", 2),
        ("let mut s = 0.0; s += a * x[i]; s -= x[i] * a; y[i] = s;", 2),
        ("y[i] += a * x[i];", 1),
        ("y[i] -= a * x[i];", 1),
        // Nothing to contract.
        ("y[i] = a + x[i];", 0),
        ("y[i] = a * x[i];", 0),
        ("y[i] *= a + x[i];", 0),
        ("y[i] = -(a * x[i]) / 2.0;", 0),
    ] {
        assert_eq!(contracted("contract", body), count, "{body}");
        assert_eq!(contracted("", body), 0, "{body}");
    }
}

#[test]
fn what_runs_on_the_host_is_as_it_is() {
    let kernel = "fn k(y: &mut Field<f32, _>, a: f32) -> f32 { for i in y { y[i] = a; } a * a + 1.0 }";
    let expansion = super::super::expand("contract".parse().unwrap(), kernel.parse().unwrap()).to_string();
    assert!(!expansion.contains("Contracted"), "{expansion}");
}
