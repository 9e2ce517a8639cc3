//! Functions and parameters.

use proc_macro2::TokenStream;

use super::codes;

#[test]
fn only_plain_functions_are_kernels() {
    assert_eq!(codes("struct A;"), ["A0101"]);
    assert_eq!(codes("fn k(u: &Field<f32, _>);"), ["A0101"]);
    assert_eq!(codes("async fn k() {}"), ["A0102"]);
    assert_eq!(codes("const fn k() {}"), ["A0102"]);
    assert_eq!(codes("unsafe fn k() {}"), ["A0102"]);
    assert_eq!(codes("extern \"C\" fn k() {}"), ["A0102"]);
    assert_eq!(codes("pub(crate) fn k<'a, T: Copy>(&'a self, t: T) -> T where T: Send { t }"), [""; 0]);
}

#[test]
fn fields_are_taken_by_reference_and_by_name() {
    assert_eq!(codes("fn k(u: Field<f32, _>) {}"), ["A0104"]);
    assert_eq!(codes("fn k(mut u: allotrope::Field<f32, _>) {}"), ["A0104"]);
    assert_eq!(codes("fn k(_: &Field<f32, _>) {}"), ["A0105"]);
    assert_eq!(codes("fn k(&(ref u): &Field<f32, _>) {}"), ["A0105"]);
    assert_eq!(codes("fn k(mut u: &mut Field<f32, _>) {}"), [""; 0]);
}

#[test]
fn only_layouts_are_open() {
    assert_eq!(codes("fn k(u: &Field<_, _>) {}"), ["A0106"]);
    assert_eq!(codes("fn k(u: &Field<f32, _, _>) {}"), ["A0106"]);
    assert_eq!(codes("fn k(u: &[Field<_, _, _>]) {}"), ["A0106", "A0106"]);
    assert_eq!(codes("fn k(u: &[Field<f32, _>], f: impl Fn(&[_]) -> f32) {}"), [""; 0]);
}

#[test]
fn members_name_values_layout_and_axes() {
    assert_eq!(codes("fn k(u: &Member<f32, _, Ij>, v: &mut Member<f32, L>) { for p in v { v[p] = 1.0; } }"), [""; 0]);
    assert_eq!(codes("fn k(u: &Member<f32>) {}"), ["A0107"]);
    assert_eq!(codes("fn k(u: &Member<'_, Node, Soa, Ij, 1>) {}"), ["A0107"]);
    assert_eq!(codes("fn k(u: &mut MemberMut<'_, Node, Soa, Ij, 1>) {}"), ["A0107"]);
    assert_eq!(codes("fn k(u: Member<f32, _, Ij>) {}"), ["A0104"]);
    assert_eq!(codes("fn k(_: &Member<f32, _, Ij>) {}"), ["A0105"]);
    assert_eq!(codes("fn k(u: &Member<_, _, _>) {}"), ["A0106", "A0106"]);
    assert_eq!(codes("fn k(u: &Member) {}"), [""; 0]);
    assert_eq!(codes("fn k(v: &mut Member<Vec2, _>) { for p in v { v.x[p] = v[p].y; } }"), ["A0108"]);
    assert_eq!(codes("fn k(v: &mut Member<f32, _, Ij>) { for p in v { v[p] = v[(1, 2)]; } }"), ["A0201"]);
    assert_eq!(codes("fn k(v: &Member<f32, _, Ij>) { for p in v { v[p] = 1.0; } }"), ["A0207"]);
    assert_eq!(codes("fn k(v: &Member<f32, _, Ij>) { for p in 0..3 { f(v[3]); } }"), ["A0208"]);
}

#[test]
fn slices_are_fields_where_loops_use_them_as_such() {
    // Read alone, they are what any other value is.
    assert_eq!(
        codes("fn k(s: &[f32], p: &mut Field<f32, _>) { for i in p { p[i] = f(s) + s[0] + s.len() as f32; } }"),
        [""; 0]
    );
    assert_eq!(
        codes("fn k(s: &mut [f32]) { s[1..4].fill(1.0); #[serial] for x in s.iter_mut() { *x = 1.0; } }"),
        [""; 0]
    );
    assert_eq!(codes("fn k(s: &mut [f32]) { let f = || for i in 0..3 { s[i] = s[0]; }; }"), [""; 0]);
    // An index that is no `usize` makes them fields, others do not.
    assert_eq!(codes("fn k(s: &[f32], p: &mut Field<f32, _>) { for i in p { p[i] = s[i - 1]; f(s); } }"), [""; 0]);
    assert_eq!(
        codes("fn k(s: &[f32], p: &mut Field<f32, _, Ij>) { for ij in p { p[ij] = s[(ij.x + 1) % 3] + f(&s); } }"),
        ["A0214"]
    );
    assert_eq!(
        codes("fn k(s: &[f32], p: &mut Field<f32, _>) { for i in p { p[i] = s[i as usize] + f(&s); } }"),
        [""; 0]
    );
    assert_eq!(codes("fn k(s: &[f32], p: &mut Field<f32, _>) { for i in 0..9 { p[i] = s[i] + f(&s); } }"), [""; 0]);
    // As fields they obey the rules of fields.
    assert_eq!(codes("fn k(s: &mut [f32]) { for i in s { s[i] = 1.0; } s[0..2].fill(2.0); }"), [""; 0]);
    assert_eq!(codes("fn k(s: &mut [f32]) { for i in 0..9 { s[i] = s[i + 1]; } }"), ["A0201"]);
    assert_eq!(codes("fn k(s: &mut [f32], q: &[usize]) { for i in 0..9 { s[q[i]] = 1.0; } }"), ["A0202"]);
    assert_eq!(codes("fn k(s: &mut [f32]) { for i in s.interior(1) { s[i - 1].max_assign(s[i]); } }"), ["A0203"]);
    assert_eq!(codes("fn k(s: &[f32]) { for i in 0..9 { s[i] += 1.0; } }"), ["A0207"]);
    assert_eq!(codes("fn k(s: &[f32]) { for i in s { f(&s[1..2]); } }"), ["A0214"]);
    assert_eq!(codes("fn k(#[field] s: &[f32]) { for i in 0..9 { f(s.iter()); } }"), ["A0216"]);
    assert_eq!(codes("fn k(s: &[Vec2]) { for i in s { f(s.x[i]); } }"), ["A0108"]);
    assert_eq!(codes("fn k(s: &[Vec2]) { for (i, j) in s { f(s[(i, j)]); } }"), ["A0208", "A0208"]);
}

#[test]
fn marked_parameters_are_fields() {
    assert_eq!(codes("fn k(#[field] u: &mut Grid) { for p in u { u.v[p] = u.v[p + 1]; } }"), ["A0201"]);
    assert_eq!(
        codes("fn k(#[field] u: &mut Grid<impl Layout<Ij>>) { for (i, j) in u { u.v[(i, j)] = 0.0; } }"),
        [""; 0]
    );
    assert_eq!(codes("fn k(#[field] u: Grid) {}"), ["A0104"]);
    assert_eq!(codes("fn k(#[field] (u): &Grid) {}"), ["A0105"]);
    assert_eq!(codes("fn k(#[field] u: &Grid<_>) {}"), ["A0106"]);
    assert_eq!(codes("fn k(#[field] u: &Field<f32, _>) {}"), [""; 0]);
}

#[test]
fn unchecked_kernels_are_unsafe_and_their_bodies_are_not() {
    let source = "fn k(u: &mut Field<f32, _>, at: &Field<u32, _>) { for i in u { u[i] = f(at[at[i]]); } }";
    let text = super::super::expand("unchecked".parse().unwrap(), source.parse().unwrap()).to_string();
    assert!(text.contains("# [forbid (unsafe_op_in_unsafe_fn)]") && text.contains("unsafe fn k"), "{text}");
    assert_eq!(text.matches("unsafe {").count(), 1, "{text}");
    assert!(text.contains("__unchecked . index"), "{text}");
    let text = super::super::expand(TokenStream::new(), source.parse().unwrap()).to_string();
    assert!(!text.contains("unsafe") && !text.contains("unchecked"), "{text}");
}

#[test]
fn unchecked_accesses_are_not_judged() {
    assert_eq!(
        codes(
            "fn k(u: &mut Field<R, _>, n: i32) { for i in u { unsafe { u.v.set_unchecked(i + n, u.v.get_unchecked(n)) } } }"
        ),
        [""; 0]
    );
    assert_eq!(codes("fn k(u: &mut Field<f32, _>) { unsafe { u.set_unchecked(0, u.get_unchecked(1)) } }"), [""; 0]);
    assert_eq!(codes("fn k(u: &Field<f32, _>) { for i in u { unsafe { u.set_unchecked(i, 1.0) } } }"), ["A0207"]);
    assert_eq!(
        codes("fn k(u: &mut Field<f32, _>) { for i in u { unsafe { u.set_unchecked(i); u.get_unchecked(i, i); } } }"),
        ["A0208", "A0208"]
    );
    assert_eq!(
        codes("fn k(u: &mut Field<f32, _>) { for i in u { u[i] = unsafe { u.get_unchecked(i) } + u[i + 1]; } }"),
        ["A0201"]
    );
    assert_eq!(
        codes("fn k(u: &Field<f32, _>) { for i in u { let f = move || unsafe { u.get_unchecked(i) }; } }"),
        ["A0223"]
    );
}

#[test]
fn options_are_refused() {
    let text = |options: &str| super::super::expand(options.parse().unwrap(), "fn k() {}".parse().unwrap()).to_string();
    assert!(text("grad").contains("not available in this version [A0103]"));
    assert!(text("unchecked, fast").contains("no option `fast` [A0103]"));
    for known in ["", "unchecked", "contract", "contract, unchecked", "unchecked,"] {
        assert!(!text(known).contains("compile_error"), "{known}");
    }
    assert!(text("unchecked = true").contains("no option `unchecked = true` [A0103]"));
    assert!(text("fast").contains("no option `fast` [A0103]"));
}
