//! Fields are taken by reference and by name; only their layout is open.
use allotrope::prelude::*;

#[kernel]
fn by_value(u: Field<f32, _>) {}

#[kernel]
fn without_a_name(_: &Field<f32, _>) {}

#[kernel]
fn any_record(u: &Field<_, _>) {}

#[kernel]
fn any_axes(u: &Field<f32, _, _>) {}

type Heat<L> = Field<f32, L, Ij>;

#[kernel]
fn marked_by_value(#[field] u: Heat<Aos>) {}

#[kernel]
fn open_alias(#[field] u: &Heat<_>) {}

fn main() {}
