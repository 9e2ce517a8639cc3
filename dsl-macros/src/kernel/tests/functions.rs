//! `#[func]`.

use proc_macro2::TokenStream;

use crate::diagnostics::Code;

fn expansion(source: &str) -> String {
    super::super::func::expand(TokenStream::new(), source.parse().expect("tokens")).to_string()
}

#[track_caller]
fn codes(source: &str, expected: &[&str]) {
    let text = expansion(source);
    let mut found: Vec<(usize, &str)> = Code::ALL.iter().flat_map(|code| text.match_indices(code.text())).collect();
    found.sort_unstable();
    let found: Vec<&str> = found.into_iter().map(|(_, code)| code).collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn members_become_readable_and_indices_reads() {
    let text =
        expansion("fn f(q: Read<f32, _, Ij>, w: Read<f32, L>, a: [f32; 3]) -> f32 { q[(0, 1)] + w[w[2]] + a[1] }");
    assert!(text.contains("q : impl :: allotrope :: Readable < f32 , Ij >"), "{text}");
    assert!(text.contains("w : impl :: allotrope :: Readable < f32 , :: allotrope :: I , Layout = L >"), "{text}");
    assert!(text.contains("(* (& (q) . get ((0 , 1))))") && text.contains("a [1]"), "{text}");
    assert!(text.contains("(w) . get ((* (& (w) . get (2))))"), "{text}");
    let inline = "# [inline (always)]";
    assert!(text.contains(inline) && !expansion("#[inline] fn f(q: Read<f32, _>) {}").contains(inline));
}

#[test]
fn what_is_no_read_is_refused() {
    codes(
        "fn f(&self, q: Read<f32, _>, x: &Read) { assert!(q[0] > 0.0, \"{}\", q[1]); let r = q; g(q, |i| q[i]); }",
        &[],
    );
    codes("fn f(q: Read<f32>) {}", &["A0123"]);
    codes("fn f(q: &mut Read<f32, _>) {}", &["A0123"]);
    codes("fn f(q: Read<'_, f32, _>) {}", &["A0123"]);
    codes("fn f(q: Read<_, _, _>) {}", &["A0106", "A0106"]);
    codes("fn f((q): Read<f32, _>) {}", &["A0105"]);
    codes("fn f(q: Read<f32, _>) { q[0] = 1.0; q[1].x *= 2.0; q[2].min_assign(3.0); }", &["A0207", "A0207", "A0207"]);
    codes("fn f(q: Read<f32, _>) { let q = 1; if let Some(q) = r {} g(|q| q); match r { q => {} } }", &["A0120"; 4]);
    codes("fn f(q: Read<f32, _>) { mine!(q[0]); vec![q[0]; 3]; println!(\"{}\", x); }", &["A0121", "A0121"]);
    codes("fn f(q: Read<f32, _>);", &["A0101"]);
    codes("struct F;", &["A0101"]);
}
