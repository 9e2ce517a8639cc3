//! A colour of a field is written; what is read elsewhere is another member.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Cell {
    p: i32,
    b: i32,
}

#[kernel]
fn relax(cells: &mut Field<Cell, _, Ij>, colour: i32) {
    for (i, j) in cells.interior(1).checkerboard(colour) {
        cells.p[(i, j)] = cells.b[(i - 1, j)] + cells.b[(i, j + 1)] + cells.p[(i, j)];
    }
    for ij in cells.colored(2, 3) {
        cells.p[ij] += 100;
    }
}

fn main() {
    let mut cells = Field::<Cell, Soa>::new([4, 4]);
    cells.fill(Cell { p: 1, b: 5 });
    relax(&mut cells, 0);
    let p = cells.members().p.to_vec();
    assert_eq!((p[5], p[6], p[10], p[15], p[0]), (111, 1, 11, 101, 1));
}
