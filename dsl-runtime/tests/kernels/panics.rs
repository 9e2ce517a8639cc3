//! Indices outside: the message names kernel, field, index and shape, and fields stay usable.

use std::panic::{AssertUnwindSafe, catch_unwind};

use allotrope::prelude::*;

use crate::Node;

/// The message of the panic that `run` ends in.
fn message(run: impl FnOnce()) -> String {
    let panic = catch_unwind(AssertUnwindSafe(run)).expect_err("a panic");
    panic.downcast_ref::<String>().expect("a formatted message").clone()
}

#[track_caller]
fn names(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "`{part}` is not in: {text}");
    }
}

/// The line that `gather` reads `u` in.
const LINE: u32 = line!() + 5;

#[kernel]
fn gather(u: &Field<f32, _>, at: &Field<i64, _>, v: &mut Field<f32, _>) {
    for p in v {
        v[p] = u[at[p]];
    }
}

#[kernel]
fn scatter(at: &Field<i64, _>, grid: &mut Field<Node, _>) {
    for p in at {
        grid.m[at[p]] += 1.0;
    }
}

#[kernel]
fn column(u: &mut Field<f32, _, Ij>, rows: i32, j: u64) {
    for i in 0..rows {
        u[(i, j)] = 1.0;
    }
}

#[kernel]
fn own_elsewhere(long: &Field<f32, _>, short: &mut Field<f32, _>) {
    for p in long {
        short[p] = long[p];
    }
}

#[test]
fn reads_accumulations_and_own_indices() {
    let (u, mut v, mut grid) =
        (Field::<f32, Aos>::new([8]), Field::<f32, Soa>::new([100]), Field::<Node, Soa>::new([8]));
    let mut at = Field::<i64, Aos>::new([100]);
    at.set(77, -3);
    names(&message(|| gather(&u, &at, &mut v)), &["`gather`", "`u`", "[-3]", "[8]"]);
    at.set(77, 1 << 40);
    names(&message(|| gather(&u, &at, &mut v)), &["`gather`", "`u`", "[1099511627776]", "[8]"]);
    names(&message(|| scatter(&at, &mut grid)), &["`scatter`", "`grid`", "[1099511627776]", "[8]"]);
    at.set(77, 7);
    grid.fill(Node::default());
    gather(&u, &at, &mut v);
    scatter(&at, &mut grid);
    assert_eq!((grid.get(0).m, grid.get(7).m), (99.0, 1.0));
}

#[test]
fn own_indices_in_other_fields() {
    let mut u = Field::<f32, Blocked<4>>::new([5, 6]);
    names(&message(|| column(&mut u, 6, 2)), &["`column`", "`u`", "[5, 2]", "[5, 6]"]);
    names(&message(|| column(&mut u, 5, u64::MAX)), &["`column`", "`u`", "[5, 6]"]);
    column(&mut u, 5, 3);
    assert!((0..5).all(|i| u.get((i, 3)) == 1.0));
    let (long, mut short) = (Field::<f32, Aos>::new([9]), Field::<f32, AoSoA<4>>::new([7]));
    names(&message(|| own_elsewhere(&long, &mut short)), &["`own_elsewhere`", "`short`", "[7]"]);
}

#[kernel]
fn top_level(u: &mut Field<f32, _, Ij>) {
    u[(0, 9)] = 1.0;
}

#[kernel]
fn serial(u: &mut Field<f32, _>) {
    #[serial]
    for p in u {
        u[p] = u[p + 1];
    }
}

#[test]
fn serial_accesses() {
    names(&message(|| top_level(&mut Field::<f32, Aos>::new([3, 4]))), &["[0, 9]", "[3, 4]"]);
    names(&message(|| serial(&mut Field::<f32, Aos>::new([3]))), &["[3]"]);
}

#[test]
fn the_source_line_is_the_user_s() {
    let line = std::sync::Arc::new(std::sync::Mutex::new(0));
    let seen = line.clone();
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        if info.to_string().contains("`gather`") && info.to_string().contains("[11]") {
            *seen.lock().unwrap() = info.location().map_or(0, |location| location.line());
        }
    }));
    let (u, mut v, mut at) = (Field::<f32, Aos>::new([4]), Field::<f32, Soa>::new([1]), Field::<i64, Aos>::new([1]));
    at.set(0, 11);
    message(|| gather(&u, &at, &mut v));
    std::panic::set_hook(before);
    assert_eq!(*line.lock().unwrap(), LINE);
}
