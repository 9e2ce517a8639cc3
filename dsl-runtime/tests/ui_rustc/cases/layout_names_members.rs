//! A layout that names members names each of its record's, and no others.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Node {
    v: Vec2,
    m: f32,
}

type Missing = layout!(Node: dense(ij).place([v])); //~ E0063
type Unknown = layout!(Node: dense(ij).place([v, m], [mass])); //~ E0560
type Nobody = layout!(Nodes: dense(ij).place([v], [m])); //~ E0422 E0425
type Elsewhere = layout!(Nodes: dense(ij).aos); //~ E0425

fn main() {}
