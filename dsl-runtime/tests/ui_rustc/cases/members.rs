//! What is handed in as a member must hold such values over such axes, and may be changed where it was borrowed so.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn halve(u: &mut Member<f32, _, Ij>) {
    for ij in u {
        u[ij] *= 0.5;
    }
}

#[kernel]
fn total(u: &Member<f32, _, Ij>) -> f32 {
    let mut total = 0.0;
    for ij in u {
        total += u[ij];
    }
    total
}

#[kernel] //~ E0277 E0599
fn ids(list: &mut [usize]) { //~ E0277
    for i in list {
        list[i] = 0;
    }
}

fn main() {
    let mut grid = Field::<Node, Soa>::new([4, 4]);
    total(&grid.members().v); //~ E0271
    total(&Field::<f32, Soa>::new([4])); //~ E0271
    total(&grid); //~ E0271
    total(&"text"); //~ E0277
    halve(&mut grid.members().m); //~ E0277
}
