//! A member as a parameter names its values, its layout and its axes.
use allotrope::MemberMut;
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

#[kernel]
fn without_layout(u: &Member<f32>) {}

#[kernel]
fn with_record(u: &Member<'_, Node, Soa, Ij, 1>) {}

#[kernel]
fn of_the_host(u: &mut MemberMut<'_, Node, Soa, Ij, 1>) {}

#[kernel]
fn by_value(u: Member<f32, _, Ij>) {}

#[kernel]
fn any_values(u: &Member<_, _, Ij>) {}

#[kernel]
fn member_of_a_member(v: &mut Member<Vec2, _, Ij>, list: &mut [Vec2]) {
    for ij in v {
        v.x[ij] = 1.0;
    }
    for i in list {
        list.x[i] = 1.0;
    }
}

#[kernel]
fn stencil_in_place(u: &mut Member<f32, _, Ij>, list: &mut [f32]) {
    for (i, j) in u.interior(1) {
        u[(i, j)] = u[(i - 1, j)];
    }
    for i in list {
        list[i] = list[0];
    }
}

fn main() {}
