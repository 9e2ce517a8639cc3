//! A layout names the members that are seen where it is written.
use allotrope::prelude::*;

mod grid {
    use allotrope::prelude::*;

    #[derive(Record, Clone, Copy, Default)]
    pub struct Node {
        pub v: Vec2,
        m: f32,
    }
}

type Parts = layout!(grid::Node: dense(ij).place([v], [m])); //~ E0451

fn main() {}
