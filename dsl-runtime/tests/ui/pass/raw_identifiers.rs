//! Any name may be raw.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Node {
    r#type: i32,
    r#in: i32,
}

#[kernel]
fn r#move(r#struct: &mut Field<Node, _>, r#mut: i32) -> i32 {
    let mut r#else = 0;
    for r#loop in r#struct {
        r#struct.r#type[r#loop] = r#loop + r#mut;
        r#struct.r#in[r#loop] = r#struct.r#type[r#loop];
        r#else += r#struct.r#in[r#loop];
    }
    r#else
}

fn main() {
    let mut u = Field::<Node, Soa>::new([2]);
    assert_eq!(r#move(&mut u, 3), 7);
    assert_eq!(u.members().r#in.to_vec(), [3, 4]);
}
