//! Times of the kernels and their hand-written twins, each by itself: `cargo bench --bench kernels`.
//!
//! `ratios` compares them in interleaved pairs, which is what counts on a machine that others use too; this one keeps a
//! history of each kernel, so that a change that slows one down is seen.

#[allow(dead_code, unreachable_pub, reason = "two benches share it, and each uses a part")]
mod twins;

use std::hint::black_box;

use allotrope::prelude::*;
use allotrope_lab::workloads::stencils::ramp;
use allotrope_lab::workloads::transfer::{Mpm, Node, Point, sorted_points};
use allotrope_lab::workloads::{stencils, streams, transfer};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use twins::transfer::{Interleaved, NodeRecords};
use twins::{Aligned, stencils as hand_stencils, streams as hand_streams, transfer as hand};

/// The schedule of all benches: one thread, and the instruction set that `ALLOTROPE_CPU` chooses.
fn schedule() -> Schedule {
    Schedule { threads: 1, ..Schedule::default() }
}

fn stream_benches(c: &mut Criterion) {
    let size = 1 << 22;
    let cpu = schedule().instruction_set();
    let input = Aligned::new(&ramp(size));
    let mut x = Field::<f32, Aos>::new([size]);
    x.copy_from_slice(&input);
    let mut y = Field::<f32, Aos>::new([size]);
    let mut hand = Aligned::new(&vec![0.0; size]);

    let mut group = c.benchmark_group("saxpy 2^22");
    group.throughput(Throughput::Bytes(12 * size as u64));
    group.bench_function("kernel", |b| schedule().run(|| b.iter(|| streams::saxpy(black_box(1e-9), &x, &mut y))));
    group.bench_function("twin", |b| b.iter(|| hand_streams::saxpy(cpu, black_box(1e-9), &input, &mut hand)));
    group.finish();

    let mut group = c.benchmark_group("sum 2^22");
    group.throughput(Throughput::Bytes(4 * size as u64));
    group.bench_function("kernel", |b| schedule().run(|| b.iter(|| streams::sum(black_box(&x)))));
    group.bench_function("twin", |b| b.iter(|| hand_streams::sum(cpu, black_box(&input))));
    group.finish();
}

fn stencil_benches(c: &mut Criterion) {
    let cpu = schedule().instruction_set();
    let n = 1024;
    let input = Aligned::new(&ramp(n * n));
    let mut u = Field::<f32, Aos>::new([n, n]);
    u.copy_from_slice(&input);
    let mut v = Field::<f32, Aos>::new([n, n]);
    let mut hand = Aligned::new(&vec![0.0; n * n]);
    let mut group = c.benchmark_group("Jacobi 1024^2");
    group.throughput(Throughput::Elements((n * n) as u64));
    group.bench_function("kernel", |b| schedule().run(|| b.iter(|| stencils::jacobi(black_box(0.25), &u, &mut v))));
    let tiles = u.relayout::<Blocked<8>>();
    let mut into = v.relayout::<Blocked<8>>();
    group.bench_function("kernel, 8 x 8 blocks", |b| {
        schedule().run(|| b.iter(|| stencils::jacobi(black_box(0.25), &tiles, &mut into)));
    });
    group.bench_function("twin", |b| b.iter(|| hand_stencils::jacobi_rows(cpu, n, black_box(0.25), &input, &mut hand)));
    group.finish();

    let n = 96;
    let input = Aligned::new(&ramp(n * n * n));
    let mut p = Field::<f32, Aos>::new([n, n, n]);
    p.copy_from_slice(&input);
    let mut q = Field::<f32, Aos>::new([n, n, n]);
    let mut hand = Aligned::new(&vec![0.0; n * n * n]);
    let mut group = c.benchmark_group("7-point Laplacian 96^3");
    group.throughput(Throughput::Elements((n * n * n) as u64));
    group.bench_function("kernel", |b| schedule().run(|| b.iter(|| stencils::laplacian(black_box(&p), &mut q))));
    group.bench_function("twin", |b| b.iter(|| hand_stencils::laplacian_rows(cpu, n, black_box(&input), &mut hand)));
    group.finish();
}

fn transfer_benches(c: &mut Criterion) {
    let cpu = schedule().instruction_set();
    let side = 256;
    let mpm = Mpm::new(side);
    let list = sorted_points(1 << 16, side);
    let mut points = Field::<Point, Aos>::new([list.len()]);
    for (n, &point) in list.iter().enumerate() {
        points.set(n, point);
    }
    let mut grid = Field::<Node, Aos>::new([side, side]);
    let flat = |p: &Point| {
        let c = p.c.to_cols_array();
        [p.x.x, p.x.y, p.v.x, p.v.y, c[0], c[1], c[2], c[3], p.j]
    };
    let hand_points = Interleaved(list.iter().map(flat).collect());
    let mut hand_grid = NodeRecords(vec![[0.0; 3]; side * side]);

    let mut group = c.benchmark_group("P2G 2^16 on 256^2");
    group.throughput(Throughput::Elements(list.len() as u64));
    group.bench_function("kernel", |b| {
        schedule().run(|| b.iter(|| transfer::particle_to_grid(&points, &mut grid, black_box(&mpm))));
    });
    group.bench_function("twin", |b| {
        b.iter(|| hand::particle_to_grid(cpu, &hand_points, &mut hand_grid, side, black_box(&mpm)));
    });
    group.finish();

    // A grid at rest, so that the particles stay where they are.
    grid.fill(Node::default());
    let hand_grid = NodeRecords(vec![[0.0; 3]; side * side]);
    let mut moved = hand_points.clone();
    let mut group = c.benchmark_group("G2P 2^16 on 256^2");
    group.throughput(Throughput::Elements(list.len() as u64));
    group.bench_function("kernel", |b| {
        schedule().run(|| b.iter(|| transfer::grid_to_particle(&mut points, &grid, black_box(&mpm))));
    });
    group.bench_function("twin", |b| {
        b.iter(|| hand::grid_to_particle(cpu, &mut moved, &hand_grid, side, black_box(&mpm)));
    });
    group.finish();
}

criterion_group!(benches, stream_benches, stencil_benches, transfer_benches);
criterion_main!(benches);
