//! The members of a field are seen where those of the record are.
use allotrope::prelude::*;

mod grid {
    use allotrope::prelude::*;

    #[derive(Record, Clone, Copy, Default)]
    pub struct Node {
        pub v: Vec2,
        m: f32,
    }
}

fn main() {
    let grid = Field::<grid::Node, Soa>::new([4, 4]);
    grid.members().v.to_vec();
    grid.members().m.to_vec(); //~ E0616
}
