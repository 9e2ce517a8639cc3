//! Functions and parameters.

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
fn later_parameters_are_named() {
    assert_eq!(codes("fn k(u: &Member<f32, _, Ij>) {}"), ["A0107"]);
    assert_eq!(codes("fn k(#[field] u: &mut Grid) {}"), ["A0107"]);
}

#[test]
fn options_are_refused() {
    let text = |options: &str| super::super::expand(options.parse().unwrap(), "fn k() {}".parse().unwrap()).to_string();
    assert!(text("unchecked").contains("not available in this version [A0103]"));
    assert!(text("fast").contains("no option `fast` [A0103]"));
    assert!(!text("").contains("compile_error"));
}
