//! A kernel is a function; inside a loop it runs on that thread.
use allotrope::prelude::*;

#[kernel]
fn total(u: &Field<i32, _>) -> i32 {
    let mut sum = 0;
    for p in u {
        sum += u[p];
    }
    sum
}

fn of_a_range(n: i32) -> i32 {
    let mut line = Field::<i32, Soa>::new([3]);
    line.fill(n);
    total(&line)
}

#[kernel]
fn all(u: &mut Field<i32, _>) -> i32 {
    for p in u {
        u[p] = of_a_range(p);
    }
    total(u)
}

fn main() {
    let mut u = Field::<i32, Soa>::new([4]);
    assert_eq!(all(&mut u), 18);
}
