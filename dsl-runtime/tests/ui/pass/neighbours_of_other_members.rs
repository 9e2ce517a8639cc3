//! What is written and what is read at neighbours may be members of one field.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Cell {
    heat: i32,
    flow: i32,
    marks: i32,
}

#[kernel]
fn spread(cells: &mut Field<Cell, _>) {
    for p in cells {
        cells.flow[p] = cells.heat.clamped(p - 1) + cells.heat.wrapped(p + 1);
        cells.marks[0] += cells.heat[p];
    }
    for p in cells {
        cells.heat[p] = cells.flow[p] + cells.marks[0];
    }
}

fn main() {
    let mut cells = Field::<Cell, Soa>::new([3]);
    (0..3).for_each(|i| cells.set(i, Cell { heat: i as i32, ..Cell::default() }));
    spread(&mut cells);
    assert_eq!(cells.members().heat.to_vec(), [1 + 3, 2 + 3, 1 + 3]);
}
