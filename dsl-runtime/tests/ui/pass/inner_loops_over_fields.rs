//! An inner loop runs over any field, and reads all of it.
use allotrope::prelude::*;

#[kernel]
fn forces(bodies: &Field<f32, _>, grid: &Field<f32, _, Ij>, force: &mut Field<f32, _>) {
    for p in bodies {
        for q in bodies {
            if q != p {
                force[p] += bodies[q] - bodies[p];
            }
        }
        for (i, j) in grid.interior(1) {
            force[p] += grid[(i, j)] + grid[(i - 1, j + 1)];
        }
        for k in 0..bodies.len() {
            force[p] += 0.0 * bodies[k];
        }
    }
}

fn main() {
    let (mut bodies, mut grid) = (Field::<f32, Soa>::new([3]), Field::<f32, Blocked<2>>::new([3, 3]));
    (0..3).for_each(|i| bodies.set(i, i as f32));
    grid.fill(10.0);
    let mut force = Field::<f32, Soa>::new([3]);
    forces(&bodies, &grid, &mut force);
    assert_eq!(force.to_vec(), [23.0, 20.0, 17.0]);
}
