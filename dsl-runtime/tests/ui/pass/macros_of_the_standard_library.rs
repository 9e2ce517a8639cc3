//! Known macros are expressions, inline captures included.
use allotrope::prelude::*;

#[kernel]
fn show(u: &mut Field<i32, _>, name: &str) -> i32 {
    let mut length = 0;
    for p in u {
        assert!(u[p] >= 0, "{name} at {p}: {}", u[p]);
        let text = format!("{p}: {value:>width$} {name}", value = u[p], width = 4);
        length += text.len() as i32;
        debug_assert_ne!(p, -1);
        u[p] = vec![u[p]; 3].len() as i32 + i32::from(matches!(u[p], x if x > 1));
    }
    length
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    u.set(1, 5);
    assert_eq!(show(&mut u, "u"), 18);
    assert_eq!(u.to_vec(), [3, 4]);
}
