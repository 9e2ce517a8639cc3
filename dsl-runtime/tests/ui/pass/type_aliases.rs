//! Types may have other names: the axes, the records, the vectors.
use allotrope::prelude::*;

type Real = f32;
type Plane = Ij;
type Index = IVec2;

#[kernel]
fn smooth(u: &Field<Real, _, Plane>, v: &mut Field<Real, Layers, Plane>, width: u32) {
    for ij in v.interior(width) {
        v[ij] = u[ij + Index::X] + u[ij - ivec2(0, 1)];
    }
    for (i, j) in v.border(1) {
        v[(i, j)] = -1.0;
    }
}

type Layers = layout!(dense(ij).dense(ij, 2).soa);

fn main() {
    let mut u = Field::<Real, Soa>::new([3, 3]);
    let mut v = Field::<Real, Layers>::new([3, 3]);
    u.fill(2.0);
    smooth(&u, &mut v, 1);
    assert_eq!(v.to_vec(), [-1.0, -1.0, -1.0, -1.0, 4.0, -1.0, -1.0, -1.0, -1.0]);
}
