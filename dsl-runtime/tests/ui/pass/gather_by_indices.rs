//! Stored indices, of any integer type, read what the loop does not write.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Link {
    to: u32,
    at: IVec2,
}

#[kernel]
fn gather(links: &Field<Link, _>, values: &Field<i32, _>, grid: &Field<i32, _, Ij>, out: &mut Field<i32, _>) {
    for p in out {
        let base = links.at[p];
        out[p] = values[links.to[p]] + values[values[p]] + grid[base + ivec2(1, 0)] + grid[(base.x, p)];
    }
}

fn main() {
    let (mut links, mut values) = (Field::<Link, Soa>::new([2]), Field::<i32, Soa>::new([2]));
    links.set(0, Link { to: 1, at: ivec2(1, 1) });
    values.set(0, 1);
    let mut grid = Field::<i32, Aos>::new([3, 3]);
    grid.set([2, 1], 100);
    grid.set([1, 0], 1000);
    let mut out = Field::<i32, Soa>::new([2]);
    gather(&links, &values, &grid, &mut out);
    assert_eq!(out.to_vec(), [1100, 1002]);
}
