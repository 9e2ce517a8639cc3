//! Each kernel beside its hand-written twin: same layout, threads and instruction set, in interleaved pairs.
//!
//! `cargo bench --bench ratios [-- FILTER]` prints, for each pair, the median times, and the median of the paired ratios with its
//! 95 % bootstrap interval. `ALLOTROPE_CPU` chooses the instruction set, `ROUNDS` how often all is allocated anew (5 unless told),
//! `PAIRS` the pairs a round (13), `THREADS` the threads of kernels (1; twins have one).
//! In every round both results are compared.

#[allow(dead_code, reason = "two benches share it, and each uses a part")]
mod harness;
#[allow(dead_code, unreachable_pub, reason = "benches share it, and each uses a part")]
mod twins;

use std::hint::black_box;

use allotrope::prelude::*;
use allotrope_lab::workloads::stencils::{Four, ramp};
use allotrope_lab::workloads::transfer::{Mpm, Node, Point, drawn_points, sorted_points};
use allotrope_lab::workloads::{bodies, stencils, streams, transfer};
use allotrope_solvers::linear::{Laplacian, Operator};
use allotrope_solvers::mass_spring::{List, MassSpring, SpringsSetup};
use harness::{Pairs, same};
use twins::Aligned;
use twins::transfer::{Apart, Block, Blocks, Interleaved, NodeLists, NodeRecords};
use twins::{
    bodies as hand_bodies, springs as hand_springs, stencils as hand_stencils, streams as hand_streams,
    transfer as hand,
};

fn stream_pairs(pairs: &Pairs) {
    for (size, label) in [(1 << 24, "2^24"), (1 << 20, "2^20"), (1 << 17, "2^17"), (1 << 14, "2^14")] {
        let input = Aligned::new(&ramp(size));
        let mut x = Field::<f32, Aos>::new([size]);
        x.copy_from_slice(&input);
        let name = format!("saxpy {label}, row-major");
        if pairs.wants(&name) {
            let mut y = Field::<f32, Aos>::new([size]);
            let mut hand = Aligned::new(&vec![0.0; size]);
            streams::saxpy(0.5, &x, &mut y);
            hand_streams::saxpy(pairs.cpu, 0.5, &input, &mut hand);
            same(&name, &y.to_vec(), &hand, 0.0);
            pairs.run(
                &name,
                || streams::saxpy(black_box(1e-9), &x, &mut y),
                || hand_streams::saxpy(pairs.cpu, black_box(1e-9), &input, &mut hand),
            );
        }
        let name = format!("sum {label}, row-major");
        if pairs.wants(&name) {
            let (ours, theirs) = (streams::sum(&x), hand_streams::sum(pairs.cpu, &input));
            assert!((ours - theirs).abs() <= 1e-3 * theirs, "{name}: {ours} and {theirs}");
            pairs.run(
                &name,
                || {
                    black_box(streams::sum(black_box(&x)));
                },
                || {
                    black_box(hand_streams::sum(pairs.cpu, black_box(&input)));
                },
            );
        }
    }
}

/// Rows out of the caches and in them.
fn jacobi_row_pairs(pairs: &Pairs) {
    for n in [2048, 1024, 256] {
        let name = format!("Jacobi {n}^2, row-major");
        if !pairs.wants(&name) {
            continue;
        }
        let input = Aligned::new(&ramp(n * n));
        let mut rows = Field::<f32, Aos>::new([n, n]);
        rows.copy_from_slice(&input);
        let mut v = Field::<f32, Aos>::new([n, n]);
        let mut hand = Aligned::new(&vec![0.0; n * n]);
        stencils::jacobi(0.25, &rows, &mut v);
        hand_stencils::jacobi_rows(pairs.cpu, n, 0.25, &input, &mut hand);
        same(&name, &v.to_vec(), &hand, 0.0);
        pairs.run(
            &name,
            || stencils::jacobi(black_box(0.25), &rows, &mut v),
            || hand_stencils::jacobi_rows(pairs.cpu, n, black_box(0.25), &input, &mut hand),
        );
    }
}

fn jacobi_pairs(pairs: &Pairs) {
    jacobi_row_pairs(pairs);
    let n = 2048;
    let input = Aligned::new(&ramp(n * n));
    let mut rows = Field::<f32, Aos>::new([n, n]);
    rows.copy_from_slice(&input);
    let mut right = vec![0.0; n * n];
    hand_stencils::jacobi_rows(pairs.cpu, n, 0.25, &input, &mut right);

    let name = "Jacobi 2048^2, SoA of 4";
    if pairs.wants(name) {
        let mut u = Field::<Four, Soa, Ij>::from_shape(n);
        u.members_mut().u.copy_from_slice(&input);
        let mut v = Field::<Four, Soa, Ij>::from_shape(n);
        stencils::jacobi_member(0.25, &u, &mut v);
        same(name, &v.members().u.to_vec(), &right, 0.0);
        let mut hand = Aligned::new(&vec![0.0; n * n]);
        pairs.run(
            name,
            || stencils::jacobi_member(black_box(0.25), &u, &mut v),
            || hand_stencils::jacobi_rows(pairs.cpu, n, black_box(0.25), &input, &mut hand),
        );
    }
    let name = "Jacobi 2048^2, AoS of 4";
    if pairs.wants(name) {
        let mut u = Field::<Four, Aos, Ij>::from_shape(n);
        u.members_mut().u.copy_from_slice(&input);
        let mut v = Field::<Four, Aos, Ij>::from_shape(n);
        stencils::jacobi_member(0.25, &u, &mut v);
        same(name, &v.members().u.to_vec(), &right, 0.0);
        let records: Vec<[f32; 4]> = input.iter().map(|&u| [u, 0.0, 0.0, 0.0]).collect();
        let records = Aligned::new(&records);
        let mut hand = Aligned::new(&vec![[0.0; 4]; n * n]);
        pairs.run(
            name,
            || stencils::jacobi_member(black_box(0.25), &u, &mut v),
            || hand_stencils::jacobi_records(pairs.cpu, n, black_box(0.25), &records, &mut hand),
        );
    }
    blocked_pair::<4>(pairs, n, &rows, &right);
    blocked_pair::<8>(pairs, n, &rows, &right);
}

fn blocked_pair<const B: usize>(pairs: &Pairs, n: usize, rows: &Field<f32, Aos, Ij>, right: &[f32]) {
    let name = format!("Jacobi 2048^2, {B} x {B} blocks");
    if !pairs.wants(&name) {
        return;
    }
    let u = rows.relayout::<Blocked<B>>();
    let mut v = Field::<f32, Blocked<B>>::new([n, n]);
    stencils::jacobi(0.25, &u, &mut v);
    same(&name, &v.to_vec(), right, 0.0);
    let place = |i: usize, j: usize| ((i / B) * (n / B) + j / B) * B * B + (i % B) * B + j % B;
    let mut input = Aligned::new(&vec![0.0; n * n]);
    let mut hand = Aligned::new(&vec![0.0; n * n]);
    for (at, value) in rows.iter().enumerate() {
        input[place(at / n, at % n)] = value;
    }
    hand_stencils::jacobi_blocks::<B>(pairs.cpu, n, 0.25, &input, &mut hand);
    let unfolded: Vec<f32> = (0..n * n).map(|at| hand[place(at / n, at % n)]).collect();
    same(&name, &unfolded, right, 0.0);
    pairs.run(
        &name,
        || stencils::jacobi(black_box(0.25), &u, &mut v),
        || hand_stencils::jacobi_blocks::<B>(pairs.cpu, n, black_box(0.25), &input, &mut hand),
    );
}

fn laplacian_pairs(pairs: &Pairs) {
    for n in [192, 96, 48] {
        laplacian_pair(pairs, n);
    }
}

fn laplacian_pair(pairs: &Pairs, n: usize) {
    let name = &*format!("7-point Laplacian {n}^3, row-major");
    if !pairs.wants(name) {
        return;
    }
    let input = Aligned::new(&ramp(n * n * n));
    let mut p = Field::<f32, Aos>::new([n, n, n]);
    p.copy_from_slice(&input);
    let mut q = Field::<f32, Aos>::new([n, n, n]);
    let mut hand = Aligned::new(&vec![0.0; n * n * n]);
    stencils::laplacian(&p, &mut q);
    hand_stencils::laplacian_rows(pairs.cpu, n, &input, &mut hand);
    same(name, &q.to_vec(), &hand, 0.0);
    pairs.run(
        name,
        || stencils::laplacian(black_box(&p), &mut q),
        || hand_stencils::laplacian_rows(pairs.cpu, n, black_box(&input), &mut hand),
    );
}

/// Loops that compute more than they move.
fn body_pairs(pairs: &Pairs) {
    let name = "n-body 4096, direct";
    if pairs.wants(name) {
        let places: Vec<[f32; 3]> =
            (0..4096usize).map(|n| [n * 37 % 4096, n * 91 % 4096, n].map(|n| n as f32 / 4096.0)).collect();
        let mut x = Field::<Vec3, Soa>::new([places.len()]);
        places.iter().enumerate().for_each(|(n, &place)| x.set(n, Vec3::from_array(place)));
        let mut a = Field::<Vec3, Soa>::new([places.len()]);
        let mut hand = vec![[0.0; 3]; places.len()];
        bodies::gravitate(&x, &mut a);
        hand_bodies::gravitate(pairs.cpu, &places, &mut hand);
        let ours: Vec<f32> = a.iter().flat_map(|a| a.to_array()).collect();
        let largest = ours.iter().fold(0.0f32, |largest, a| largest.max(a.abs()));
        same(name, &ours, hand.as_flattened(), 1e-4 * largest);
        pairs.run(
            name,
            || bodies::gravitate(black_box(&x), &mut a),
            || hand_bodies::gravitate(pairs.cpu, black_box(&places), &mut hand),
        );
    }
    let name = "Julia 640 x 320, 50 iterations";
    if pairs.wants(name) {
        let mut counts = Field::<u32, Aos>::new([640, 320]);
        let mut hand = vec![0; 640 * 320];
        bodies::julia(&mut counts, 0.19);
        hand_bodies::julia(pairs.cpu, 640, 320, 0.19, &mut hand);
        let differ = counts.iter().zip(&hand).filter(|(ours, theirs)| ours != *theirs).count();
        // Where products are contracted, a point in a thousand may leave an iteration earlier or later.
        assert!(differ <= 640 * 320 / 1000, "{name}: {differ} points differ");
        pairs.run(
            name,
            || bodies::julia(&mut counts, black_box(0.19)),
            || hand_bodies::julia(pairs.cpu, 640, 320, black_box(0.19), &mut hand),
        );
    }
    let name = "histogram 2^22 keys to 256";
    if pairs.wants(name) {
        let list: Vec<i32> = (0..1u32 << 22).map(|n| (n.wrapping_mul(2_654_435_761) >> 24) as i32).collect();
        let mut keys = Field::<i32, Aos>::new([list.len()]);
        keys.copy_from_slice(&list);
        let mut counts = Field::<i32, Aos>::new([256]);
        let mut hand = vec![0; 256];
        bodies::histogram(&keys, &mut counts);
        hand_bodies::histogram(pairs.cpu, &list, &mut hand);
        assert_eq!(counts.to_vec(), hand, "{name}");
        pairs.run(
            name,
            || bodies::histogram(black_box(&keys), &mut counts),
            || hand_bodies::histogram(pairs.cpu, black_box(&list), &mut hand),
        );
    }
    let name = "empty launch";
    if pairs.wants(name) {
        let mut one = Field::<f32, Aos>::new([1]);
        let mut hand = [0.0f32];
        bodies::empty(&mut one);
        assert_eq!(one.to_vec(), [1.0]);
        pairs.run(name, || bodies::empty(black_box(&mut one)), || *black_box(&mut hand) = [1.0]);
    }
}

const SIDE: usize = 512;

fn transfer_pairs(pairs: &Pairs) {
    let list = sorted_points(1 << 18, SIDE);
    let flat = |p: &Point| {
        let c = p.c.to_cols_array();
        [p.x.x, p.x.y, p.v.x, p.v.y, c[0], c[1], c[2], c[3], p.j]
    };
    let interleaved = Interleaved(list.iter().map(flat).collect());
    let apart = Apart {
        x: list.iter().map(|p| p.x.to_array()).collect(),
        v: list.iter().map(|p| p.v.to_array()).collect(),
        c: list.iter().map(|p| p.c.to_cols_array()).collect(),
        j: list.iter().map(|p| p.j).collect(),
    };
    let blocks = Blocks(
        list.as_chunks::<16>()
            .0
            .iter()
            .map(|block| Block {
                x: block.map(|p| p.x.to_array()),
                v: block.map(|p| p.v.to_array()),
                c: block.map(|p| p.c.to_cols_array()),
                j: block.map(|p| p.j),
            })
            .collect(),
    );
    transfer_pair::<Aos, Aos, _, _>(pairs, "AoS x AoS", &list, &interleaved, NodeRecords(vec![[0.0; 3]; SIDE * SIDE]));
    transfer_pair::<Soa, Aos, _, _>(pairs, "SoA x AoS", &list, &apart, NodeRecords(vec![[0.0; 3]; SIDE * SIDE]));
    transfer_pair::<AoSoA<16>, Aos, _, _>(
        pairs,
        "AoSoA16 x AoS",
        &list,
        &blocks,
        NodeRecords(vec![[0.0; 3]; SIDE * SIDE]),
    );
    let lists = || NodeLists { v: vec![[0.0; 2]; SIDE * SIDE], m: vec![0.0; SIDE * SIDE] };
    transfer_pair::<Aos, Soa, _, _>(pairs, "AoS x SoA", &list, &interleaved, lists());
    transfer_pair::<Soa, Soa, _, _>(pairs, "SoA x SoA", &list, &apart, lists());
    transfer_pair::<AoSoA<16>, Soa, _, _>(pairs, "AoSoA16 x SoA", &list, &blocks, lists());
}

fn transfer_pair<LP: Layout<I>, LG: Layout<Ij>, P: hand::Points + Clone, N: hand::Nodes>(
    pairs: &Pairs,
    label: &str,
    list: &[Point],
    hand_points: &P,
    mut hand_grid: N,
) {
    let mpm = Mpm::new(SIDE);
    let mut points = Field::<Point, LP>::new([list.len()]);
    for (n, &point) in list.iter().enumerate() {
        points.set(n, point);
    }
    let mut grid = Field::<Node, LG>::new([SIDE, SIDE]);
    let velocities = |grid: &Field<Node, LG, Ij>| grid.iter().flat_map(|n| n.v.to_array()).collect::<Vec<_>>();

    transfer::particle_to_grid(&points, &mut grid, &mpm);
    hand::particle_to_grid(pairs.cpu, hand_points, &mut hand_grid, SIDE, &mpm);
    let theirs: Vec<f32> = (0..SIDE * SIDE).flat_map(|n| hand_grid.v(n).to_array()).collect();
    same(label, &velocities(&grid), &theirs, 1e-9);
    let name = format!("P2G 2^18 on 512^2, {label}");
    if pairs.wants(&name) {
        pairs.run(
            &name,
            || transfer::particle_to_grid(&points, &mut grid, black_box(&mpm)),
            || hand::particle_to_grid(pairs.cpu, hand_points, &mut hand_grid, SIDE, black_box(&mpm)),
        );
    }
    let name = format!("G2P 2^18 on 512^2, {label}");
    if pairs.wants(&name) {
        // A grid at rest, so that the particles stay where they are.
        grid.fill(Node::default());
        let mut moved = hand_points.clone();
        let mut hand_grid = hand_grid;
        for n in 0..SIDE * SIDE {
            let v = hand_grid.v(n);
            hand_grid.add(n, -v, 0.0);
        }
        pairs.run(
            &name,
            || transfer::grid_to_particle(&mut points, &grid, black_box(&mpm)),
            || hand::grid_to_particle(pairs.cpu, &mut moved, &hand_grid, SIDE, black_box(&mpm)),
        );
        let ours: Vec<f32> = points.iter().flat_map(|p| [p.x.x, p.x.y, p.j]).collect();
        let theirs: Vec<f32> = (0..list.len()).flat_map(|p| [moved.x(p).x, moved.x(p).y, moved.j(p)]).collect();
        same(&name, &ours, &theirs, 0.0);
    }
}

/// A step of the solver's cloth.
fn cloth_pair(pairs: &Pairs) {
    let name = "cloth 128 x 128, symplectic Euler, list of springs";
    if !pairs.wants(name) {
        return;
    }
    let scene = allotrope_solvers::solver("springs")
        .and_then(|solver| solver.scene("cloth").map_err(|error| error.to_string()));
    let scene = scene.expect("a built-in scene");
    let setup: &SpringsSetup = scene.setup().expect("a scene of springs");
    let SpringsSetup { parameters, masses, springs, .. } = setup;
    let mut system = MassSpring::<Aos, List>::with(*parameters, masses, springs).expect("a sound scene");
    let vector = |v: DVec3| v.to_array();
    let record = |m: &allotrope_solvers::mass_spring::Mass| hand_springs::Mass {
        x: vector(m.x),
        v: vector(m.v),
        f: [0.0; 3],
        mass: m.mass,
        fixed: m.fixed,
    };
    let mut hand: Vec<_> = masses.iter().map(record).collect();
    let list = springs.iter().map(|spring| hand_springs::Spring {
        ends: spring.ends,
        stiffness: spring.bond.stiffness,
        rest: spring.bond.rest,
        dashpot: spring.bond.dashpot,
    });
    let list: Vec<_> = list.collect();
    let step = hand_springs::Step {
        dt: parameters.dt,
        gravity: vector(parameters.gravity),
        decay: (-parameters.dt * parameters.drag).exp(),
        walls: parameters.walls.map(vector),
    };
    for _ in 0..100 {
        system.step().expect("a stable step");
        hand_springs::step(pairs.cpu, &list, &mut hand, &step);
    }
    let ours: Vec<f32> = system.positions().iter().flat_map(|x| x.to_array()).map(|x| x as f32).collect();
    let theirs: Vec<f32> = hand.iter().flat_map(|mass| mass.x).map(|x| x as f32).collect();
    same(name, &ours, &theirs, 1e-6);
    pairs.run(
        name,
        || _ = system.step().expect("a stable step"),
        || _ = black_box(hand_springs::step(pairs.cpu, &list, &mut hand, black_box(&step))),
    );
}

/// An iteration of conjugate gradients beside loops over the same arrays that do nothing but move them.
fn solve_pairs(pairs: &Pairs) {
    for n in [1024, 2048] {
        let name = format!("conjugate gradients {n}^2, beside its streams");
        if !pairs.wants(&name) {
            continue;
        }
        let values: Vec<f64> = (0..n * n).map(|at| f64::from(at as u32 * 7919 % 1009) / 1009.0).collect();
        let mut r = Field::<f64, Aos>::new([n, n]);
        r.copy_from_slice(&values);
        let (mut x, mut p, mut spare) = (r.clone(), r.clone(), r.clone());
        let mut hand: [_; 4] = std::array::from_fn(|_| Aligned::new(&values));
        let laplacian = Laplacian::new();
        pairs.run(
            &name,
            || {
                black_box(laplacian.turn(&r, &mut p, &mut spare, black_box(1e-9)));
                black_box(laplacian.descend(&mut x, &mut r, &p, &spare, black_box(1e-9)));
            },
            || {
                let [old, new, x, r] = &mut hand;
                hand_streams::conjugate_gradients(pairs.cpu, black_box(1e-9), old, new, x, r);
                black_box(&mut *new);
            },
        );
    }
}

/// Z-order beside rows: the same kernels, the one in the place of the twin in rows.
fn morton_pairs(pairs: &Pairs) {
    for n in [2048, 256] {
        let name = format!("Jacobi {n}^2, Morton blocks of 8 beside rows");
        if pairs.wants(&name) {
            let mut rows = Field::<f32, Aos, Ij>::from_shape(n);
            rows.copy_from_slice(&ramp(n * n));
            let (curve, mut next_row) = (rows.relayout::<Morton<8>>(), Field::<f32, Aos, Ij>::from_shape(n));
            let mut next = Field::<f32, Morton<8>, Ij>::from_shape(n);
            stencils::jacobi(0.25, &rows, &mut next_row);
            stencils::jacobi(0.25, &curve, &mut next);
            same(&name, &next.to_vec(), &next_row.to_vec(), 0.0);
            pairs.run(
                &name,
                || stencils::jacobi(black_box(0.25), &curve, &mut next),
                || stencils::jacobi(black_box(0.25), &rows, &mut next_row),
            );
        }
    }
    for (count, label, side) in [(1 << 20, "2^20", 1024), (1 << 18, "2^18", 512)] {
        let name = format!("P2G {label} unsorted on {side}^2, Morton blocks of 8 beside rows");
        if pairs.wants(&name) {
            let list = drawn_points(count);
            let mut points = Field::<Point, Aos>::new([count]);
            list.iter().enumerate().for_each(|(p, point)| points.set(p, *point));
            let mpm = Mpm::new(side);
            let (mut rows, mut curve) =
                (Field::<Node, Aos, Ij>::from_shape(side), Field::<Node, Morton<8>, Ij>::from_shape(side));
            transfer::particle_to_grid(&points, &mut rows, &mpm);
            transfer::particle_to_grid(&points, &mut curve, &mpm);
            same(&name, &curve.members().m.to_vec(), &rows.members().m.to_vec(), 0.0);
            pairs.run(
                &name,
                || transfer::particle_to_grid(&points, &mut curve, black_box(&mpm)),
                || transfer::particle_to_grid(&points, &mut rows, black_box(&mpm)),
            );
        }
    }
}

/// Square fields, without naming the axes twice.
trait FromShape {
    fn from_shape(n: usize) -> Self;
}
impl<R: Record, L: Layout<Ij>> FromShape for Field<R, L, Ij> {
    fn from_shape(n: usize) -> Self {
        Field::<R, L>::new([n, n])
    }
}

fn main() {
    harness::rounds(|pairs| {
        stream_pairs(pairs);
        jacobi_pairs(pairs);
        laplacian_pairs(pairs);
        body_pairs(pairs);
        transfer_pairs(pairs);
        cloth_pair(pairs);
        solve_pairs(pairs);
        morton_pairs(pairs);
    });
}
