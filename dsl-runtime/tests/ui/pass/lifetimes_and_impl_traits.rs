//! Parameters are any of Rust's.
use allotrope::prelude::*;

#[kernel]
pub fn apply<'a, F>(u: &'a mut Field<i32, _>, f: &F, g: impl Fn(i32) -> i32 + Sync, text: &'a str) -> &'a str
where
    F: Fn(i32) -> i32 + Sync,
{
    for p in u {
        u[p] = f(g(u[p]));
    }
    text
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    assert_eq!(apply(&mut u, &|x| x * 2, |x| x + 3, "done"), "done");
    assert_eq!(u.to_vec(), [6, 6]);
}
