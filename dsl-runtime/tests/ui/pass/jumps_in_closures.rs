//! A closure may return, and use `?`.
use allotrope::prelude::*;

#[kernel]
fn parse(u: &mut Field<i32, _>, words: &[&str]) {
    for p in u {
        let number = |k: usize| -> Option<i32> {
            let word = words.get(k)?;
            if word.is_empty() {
                return Some(-1);
            }
            word.parse().ok()
        };
        u[p] = number(p as usize).unwrap_or(9);
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([4]);
    parse(&mut u, &["7", "", "x"]);
    assert_eq!(u.to_vec(), [7, -1, 9, 9]);
}
