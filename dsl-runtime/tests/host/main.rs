//! What the host can do with a field: make it, read and write it, take its members apart, and the algorithms over its
//! records.

use std::panic::{AssertUnwindSafe, catch_unwind};

use allotrope::prelude::*;

mod algorithms;
mod fields;
mod files;

#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Point {
    x: Vec2,
    mass: f32,
    id: u32,
}

impl Point {
    fn numbered(n: u32) -> Self {
        Self { x: vec2(n as f32, -(n as f32)), mass: n as f32 + 0.5, id: n }
    }
}

/// What a call panics with.
fn panic_of<T>(call: impl FnOnce() -> T) -> String {
    let Err(payload) = catch_unwind(AssertUnwindSafe(call)) else { panic!("the call returns") };
    match payload.downcast::<String>() {
        Ok(text) => *text,
        Err(payload) => (*payload.downcast::<&str>().expect("a text")).to_owned(),
    }
}

/// Numbers that look random, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        self.0 >> 33
    }
    /// From 0 to 1.
    fn unit(&mut self) -> f64 {
        self.next() as f64 / (1u64 << 31) as f64
    }
}

/// Calls `work` on so many threads.
fn on<T>(threads: usize, work: impl FnOnce() -> T) -> T {
    Schedule { threads, ..Schedule::default() }.run(work)
}
