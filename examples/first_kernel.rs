//! A first kernel: heat spreads over a plate. `cargo run --release --example first_kernel`

use allotrope::prelude::*;

/// What one element of the plate holds. A record is a plain struct of scalars, vectors, matrices and arrays.
#[derive(Record, Clone, Copy, Default)]
struct Plate {
    heat: f32,
    conductivity: f32,
}

/// One step from `old` to `new`; returns the largest change. `_` stands for any layout, `Ij` for two axes.
#[kernel]
fn spread(old: &Field<Plate, _, Ij>, new: &mut Field<Plate, _, Ij>) -> f32 {
    let mut change = 0.0_f32;
    // The outermost loop runs in parallel, here over all of `new` but a border of width 1. It may write `new` at its own index
    // alone, and read `old` anywhere: whatever could race does not compile.
    for (i, j) in new.interior(1) {
        let heat = old.heat[(i, j)];
        let around = old.heat[(i - 1, j)] + old.heat[(i + 1, j)] + old.heat[(i, j - 1)] + old.heat[(i, j + 1)];
        let warmer = old.conductivity[(i, j)] * (0.25 * around - heat);
        new.heat[(i, j)] = heat + warmer;
        change.max_assign(warmer.abs()); // a reduction: the same bits for any number of threads
    }
    change
}

fn main() {
    // The layout is chosen where a field is made: here all heats, then all conductivities. Try `Aos` or `Blocked<8>`.
    let mut old = Field::<Plate, Soa>::new([64, 64]);
    old.members_mut().conductivity.fill(0.9);
    for i in 0..64 {
        old.set([i, 0], Plate { heat: 100.0, conductivity: 0.0 }); // one edge is kept hot
    }
    let mut new = old.clone();
    for step in 1..=5000 {
        let change = spread(&old, &mut new); // a kernel is called as any function
        std::mem::swap(&mut old, &mut new);
        if step % 1000 == 0 {
            println!("step {step}: {:.2} degrees in the middle, last change {change:.5}", old.get([32, 32]).heat);
        }
    }
}
