//! Fields whose memory follows what is active, beside hand-written twins and beside dense fields: `cargo bench --bench sparse [-- FILTER]`.
//!
//! `ALLOTROPE_CPU` chooses the instruction set; `ROUNDS`, `PAIRS` and `THREADS` are those of the harness.

#[allow(dead_code, reason = "two benches share it, and each uses a part")]
mod harness;
#[allow(dead_code, unreachable_pub, reason = "benches share it, and each uses a part")]
mod twins;

use std::hint::black_box;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

use allotrope::prelude::*;
use allotrope_lab::workloads::sparse::{SIDE, Two, append, halve, laplacian, scale, shell};
use allotrope_lab::workloads::transfer::{Mpm, Node, Point, grid_to_particle, particle_to_grid, sorted_points};
use harness::{Pairs, same};
use twins::shell::Shell;

/// The 7-point Laplacian of the shell of a sphere, and its scaling, beside lists of blocks.
fn shell_pairs(pairs: &Pairs) {
    let names = ["Laplacian of a shell in 512^3", "scaling a shell in 512^3"];
    if !names.iter().any(|name| pairs.wants(name)) {
        return;
    }
    let mut field = Field::<Two, layout!(pointer(ijk).bitmasked(ijk, 8).soa)>::new([SIDE; 3]);
    shell(&mut field);
    let blocks = field.blocks().len();
    let held = blocks * 8 * 8 * 8 * size_of::<Two>();
    println!(
        "shell: {} cells in {blocks} blocks, {} bytes, {:.3} of the active blocks'",
        field.active_len(),
        field.bytes(),
        field.bytes() as f64 / held as f64
    );
    let mut hand = Shell::new(field.active_iter().map(|(at, cell)| (at.to_array(), cell.u)));
    laplacian(&mut field);
    hand.laplacian(pairs.cpu, pairs.threads);
    for (at, cell) in field.active_iter() {
        assert!(cell.w == hand.laplacian_at(at.to_array()), "at {at}");
    }
    if pairs.wants(names[0]) {
        pairs.run(
            names[0],
            || laplacian(black_box(&mut field)),
            || black_box(&mut hand).laplacian(pairs.cpu, pairs.threads),
        );
    }
    if pairs.wants(names[1]) {
        pairs.run(
            names[1],
            || scale(black_box(&mut field), black_box(1.0001)),
            || black_box(&mut hand).scale(pairs.cpu, pairs.threads, black_box(1.0001)),
        );
    }
}

/// A full sparse field beside a dense one.
fn visit_pairs(pairs: &Pairs) {
    let n = 1024;
    let mut sparse = Field::<f32, Sparse<8>>::new([n, n]);
    (0..n * n).step_by(8).for_each(|at| sparse.activate([at / n, at % n]));
    assert_eq!(sparse.active_len(), n * n);
    visit_pair(
        pairs,
        "x * 0.5 + 1 over 2^20 cells, pointer and 8 x 8 beside rows",
        &mut sparse,
        Field::<f32, Aos>::new([n, n]),
    );
    visit_pair(
        pairs,
        "x * 0.5 + 1 over 2^20 cells, pointer and 8 x 8 beside blocks of 8 x 8",
        &mut sparse,
        Field::<f32, Blocked<8>>::new([n, n]),
    );
}

fn visit_pair<L: Layout<Ij>>(
    pairs: &Pairs,
    name: &str,
    sparse: &mut Field<f32, Sparse<8>, Ij>,
    mut dense: Field<f32, L, Ij>,
) {
    if !pairs.wants(name) {
        return;
    }
    sparse.fill(0.0);
    halve(sparse);
    halve(&mut dense);
    same(name, &sparse.iter().collect::<Vec<_>>(), &dense.to_vec(), 0.0);
    pairs.run(name, || halve(black_box(sparse)), || halve(black_box(&mut dense)));
}

/// Appending to one list beside a counter and an array that is there already.
fn append_pair(pairs: &Pairs) {
    const COUNT: usize = 1 << 18;
    let name = "append of 2^18 values to one list beside a counter and an array";
    if !pairs.wants(name) {
        return;
    }
    let values: Vec<u32> = (0..COUNT as u32).collect();
    let mut list = Field::<u32, layout!(dynamic(i, 300_000, chunk = 4096).aos)>::new([]);
    let (next, array) = (AtomicUsize::new(0), (0..COUNT).map(|_| AtomicU32::new(0)).collect::<Vec<_>>());
    let hand = || {
        next.store(0, Ordering::Relaxed);
        std::thread::scope(|scope| {
            let part = COUNT.div_ceil(pairs.threads);
            let put = |values: &[u32]| {
                for &value in values {
                    array[next.fetch_add(1, Ordering::Relaxed)].store(value, Ordering::Relaxed);
                }
            };
            let mut parts = values.chunks(part);
            let first = parts.next().unwrap_or_default();
            parts.for_each(|part| drop(scope.spawn(move || put(part))));
            put(first);
        });
    };
    append(&values, &mut list);
    hand();
    let mut ours: Vec<u32> = list.active_iter().map(|(_, value)| value).collect();
    let mut theirs: Vec<u32> = array.iter().map(|value| value.load(Ordering::Relaxed)).collect();
    ours.sort_unstable();
    theirs.sort_unstable();
    assert!(ours == values && theirs == values, "{name}");
    pairs.run(
        name,
        || {
            list.clear();
            append(black_box(&values), &mut list);
        },
        hand,
    );
}

/// First activation of blocks of 1 KiB beside memory from the system's allocator, zeroed.
fn activation_pair(pairs: &Pairs) {
    const BLOCKS: usize = 1 << 14;
    let name = "2^14 blocks of 1 KiB activated beside as many allocated and zeroed";
    if !pairs.wants(name) {
        return;
    }
    pairs.run(
        name,
        || {
            let mut field = Field::<f32, layout!(pointer(i).dense(i, 256).aos)>::new([BLOCKS * 256]);
            (0..BLOCKS).for_each(|block| field.activate(block * 256));
            black_box(&mut field);
        },
        || {
            let mut blocks = Vec::with_capacity(BLOCKS);
            for _ in 0..BLOCKS {
                let mut block = Vec::<u8>::with_capacity(1024);
                block.extend_from_slice(&[0; 1024]);
                blocks.push(black_box(block));
            }
            drop(black_box(blocks));
        },
    );
}

/// The transfers of the material point method on sparse grids beside rows.
fn transfer_pairs(pairs: &Pairs) {
    transfer_pair(pairs, "pointer and 4 x 4", || Field::<Node, Sparse<4>>::new([GRID, GRID]));
    transfer_pair(pairs, "pointer and 8 x 8", || Field::<Node, Sparse<8>>::new([GRID, GRID]));
    transfer_pair(pairs, "pointer and 16 x 16", || Field::<Node, Sparse<16>>::new([GRID, GRID]));
    transfer_pair(pairs, "hash and 16 x 16", Field::<Node, SparseHash<16>, Ij>::unbounded);
}

const GRID: usize = 512;

fn transfer_pair<L: Layout<Ij>>(pairs: &Pairs, label: &str, make: impl Fn() -> Field<Node, L, Ij>) {
    let names = ["P2G", "G2P"].map(|transfer| format!("{transfer} 2^18 on 512^2, {label} beside rows"));
    if !names.iter().any(|name| pairs.wants(name)) {
        return;
    }
    let (list, mpm) = (sorted_points(1 << 18, GRID), Mpm::new(GRID));
    let mut points = Field::<Point, Aos>::new([list.len()]);
    list.iter().enumerate().for_each(|(n, point)| points.set(n, *point));
    let (mut sparse, mut rows) = (make(), Field::<Node, Aos>::new([GRID, GRID]));
    particle_to_grid(&points, &mut sparse, &mpm);
    particle_to_grid(&points, &mut rows, &mpm);
    let tolerance = if pairs.threads == 1 { 0.0 } else { 1e-9 };
    let ours: Vec<f32> = rows.active_iter().map(|(at, _)| sparse.get(at).m).collect();
    same(&names[0], &ours, &rows.members().m.to_vec(), tolerance);
    if pairs.wants(&names[0]) {
        pairs.run(
            &names[0],
            || particle_to_grid(&points, &mut sparse, black_box(&mpm)),
            || particle_to_grid(&points, &mut rows, black_box(&mpm)),
        );
    }
    if pairs.wants(&names[1]) {
        // Grids at rest, so that the particles stay where they are.
        sparse.fill(Node::default());
        rows.fill(Node::default());
        let mut moved = points.clone();
        pairs.run(
            &names[1],
            || grid_to_particle(&mut points, &sparse, black_box(&mpm)),
            || grid_to_particle(&mut moved, &rows, black_box(&mpm)),
        );
    }
}

fn main() {
    harness::rounds(|pairs| {
        shell_pairs(pairs);
        visit_pairs(pairs);
        append_pair(pairs);
        activation_pair(pairs);
        transfer_pairs(pairs);
    });
}
