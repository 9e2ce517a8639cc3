//! Components of an own element are written one by one.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Point {
    x: Vec3,
    near: [i32; 3],
}

#[kernel]
fn step(points: &mut Field<Point, _>) {
    for p in points {
        points.x[p].y = 1.0;
        points.x[p].z += points.x[p].y;
        points.near[p][1] = p;
        points.near[p][(p % 2) as usize * 2] += 5;
        points[p].x.x = 3.0;
    }
}

fn main() {
    let mut points = Field::<Point, Soa>::new([2]);
    step(&mut points);
    assert_eq!(points.get(1).x, vec3(3.0, 1.0, 1.0));
    assert_eq!(points.members().near.to_vec(), [[5, 0, 0], [0, 1, 5]]);
}
