//! The own index may be written in several ways.
use allotrope::prelude::*;

#[kernel]
fn spell(u: &mut Field<i32, _, Ij>, v: &mut Field<i32, _>) {
    for (i, j) in u {
        u[(i, j)] = 1;
        u[[i, j]] += 1;
        u[ivec2(i, j)] += u[IVec2::new(i, j)];
        u[((i), (j))] += 1;
        u[(i + 0, 0 + j)] += 1;
    }
    for p in v {
        v[(p)] = 1;
        v[p + 0] += 1;
        v[p - 0] += v[(p)];
    }
}

fn main() {
    let (mut u, mut v) = (Field::<i32, Soa>::new([2, 2]), Field::<i32, Soa>::new([2]));
    spell(&mut u, &mut v);
    assert_eq!((u.to_vec(), v.to_vec()), (vec![6; 4], vec![4; 2]));
}
