//! A field takes its record.
use allotrope::prelude::*;

fn set(u: &mut Field<f32, Soa>) {
    u.set(0, 1u8); //~ E0308
}

fn main() {}
