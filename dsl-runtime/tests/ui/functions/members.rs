//! A `#[func]` takes members as `Read<T, _, X>`, by value and by name, and reads them by index.
use allotrope::prelude::*;

#[func]
fn borrowed(q: &Read<f32, _>) -> f32 {
    q[0]
}

#[func]
fn without_layout(q: Read<f32>) -> f32 {
    q[0]
}

#[func]
fn any_values(q: Read<_, _, Ij>) -> f32 {
    q[(0, 0)]
}

#[func]
fn without_a_name(_: Read<f32, _>) -> f32 {
    0.0
}

#[func]
fn writes(q: Read<f32, _>, i: i32) {
    q[i] = 1.0;
    q[i] += 1.0;
    q[i].max_assign(2.0);
}

#[func]
fn rebinds(q: Read<Vec2, _>, i: i32) -> f32 {
    for q in 0..3 {}
    let q = q[i];
    q.x
}

#[func]
fn in_a_macro(q: Read<f32, _>, i: i32) -> f32 {
    mine!(q, i)
}

#[func(fast)]
fn options(x: f32) -> f32 {
    x
}

#[func]
struct NoFunction;

fn main() {}
