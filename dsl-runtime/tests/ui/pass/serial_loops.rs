//! A `#[serial]` loop may do anything.
use allotrope::prelude::*;

#[kernel]
fn walk(u: &mut Field<i32, _>, list: &mut Vec<i32>, perm: &[usize]) -> Option<i32> {
    let mut last = 0;
    #[serial]
    for p in u.interior(1) {
        u[p] = u[p - 1] + u[p + 1];
        list.push(u[p]);
        last = p;
        if u[p] > 3 {
            break;
        }
    }
    #[serial]
    for k in perm.iter().rev() {
        u[*k] = *perm.get(*k)? as i32;
        u[0] += u[*k];
    }
    Some(last)
}

fn main() {
    let mut u = Field::<i32, Soa>::new([5]);
    u.fill(1);
    let mut list = Vec::new();
    assert_eq!(walk(&mut u, &mut list, &[2, 0, 1]), Some(3));
    assert_eq!(list, [2, 3, 4]);
    assert_eq!(u.to_vec(), [4 + 1, 0, 1, 4, 1]);
}
