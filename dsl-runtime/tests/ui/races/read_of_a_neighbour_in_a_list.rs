//! A member that is written at the own index is not read at computed ones.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Point {
    x: Vec2,
    near: u32,
}

#[kernel]
fn follow(points: &mut Field<Point, _>) {
    for p in points {
        points.x[p] = points.x[points.near[p]];
    }
}

fn main() {}
