//! Recordings of what loops touch, against counts worked out by hand.

use allotrope::prelude::*;
use allotrope::probe::{Access, Cache, Caches, Index, LoopCounts, MemberCounts, RecordError, Recording, record};

use super::{Node, jacobi};

#[derive(Record, Clone, Copy, Default)]
struct Point {
    x: Vec2,
    v: Vec2,
    m: f32,
}

#[derive(Record, Clone, Copy, Default)]
struct Momentum {
    v: Vec2,
    m: f32,
}

#[kernel]
fn particle_to_grid(points: &Field<Point, _>, grid: &mut Field<Momentum, _, Ij>) {
    for at in grid {
        grid[at] = Momentum { v: Vec2::ZERO, m: 0.0 };
    }
    for p in points {
        let base = points.x[p].as_ivec2();
        for (i, j) in unroll!(0..3, 0..3) {
            grid.v[base + ivec2(i, j)] += points.v[p] / 9.0;
            grid.m[base + ivec2(i, j)] += points.m[p] / 9.0;
        }
    }
}

fn recorded(work: impl FnOnce()) -> Recording {
    record(&Caches::default(), work).expect("a recording").1
}

fn of<'r>(counts: &'r LoopCounts, member: &str, access: Access, index: Index) -> &'r MemberCounts {
    let mut found = counts.members.iter().filter(|m| (m.member, m.access, m.index) == (member, access, index));
    let first = found.next().unwrap_or_else(|| panic!("{member} {access} {index} in {counts:#?}"));
    assert!(found.next().is_none(), "one line each");
    first
}

/// Lines of 64 bytes, and bytes in them, that the values of `run` neighbours `stride` bytes apart touch, from `start` on.
fn lines_of(start: usize, run: usize, stride: usize, bytes: usize) -> (u64, u64) {
    let mut lines: Vec<usize> =
        (0..run).flat_map(|n| [start + n * stride, start + n * stride + bytes - 1]).map(|b| b / 64).collect();
    lines.sort_unstable();
    lines.dedup();
    (lines.len() as u64, (run * bytes) as u64)
}

const N: usize = 66;

fn jacobi_in<L: Layout<Ij>>() -> LoopCounts {
    let mut nodes = Field::<Node, L>::new([N, N]);
    let recording = recorded(|| {
        jacobi(&mut nodes);
        jacobi(&mut nodes);
    });
    let [counts] = recording.loops.as_slice() else { panic!("one loop") };
    assert_eq!((counts.kernel, counts.number, counts.launches), ("jacobi", 0, 2));
    counts.clone()
}

#[test]
fn jacobi_by_hand() {
    let cells = 2 * (N as u64 - 2) * (N as u64 - 2);
    let soa = jacobi_in::<Soa>();
    let aos = jacobi_in::<Aos>();
    for counts in [&soa, &aos, &jacobi_in::<Blocked<8>>(), &jacobi_in::<AoSoA<16>>()] {
        assert_eq!(counts.members.len(), 3, "{counts:#?}");
        for (member, access, index, times) in [
            ("u", Access::Read, Index::Offset, 4),
            ("rhs", Access::Read, Index::Own, 1),
            ("v", Access::Write, Index::Own, 1),
        ] {
            let line = of(counts, member, access, index);
            assert_eq!((line.field, line.count, line.bytes), ("nodes", times * cells, 4 * times * cells), "{member}");
        }
    }
    // In SoA a row of 66 values takes 264 bytes, one after another: rhs is touched in rows 1..65 at 1..65.
    let rows = |stride: usize| (1..N - 1).flat_map(move |i| (1..N - 1).map(move |j| (i * N + j) * stride));
    let expected = |stride: usize, seat: usize| {
        let mut lines: Vec<usize> = rows(stride).map(|byte| (byte + seat) / 64).collect();
        lines.dedup();
        2 * lines.len() as u64
    };
    let line = of(&soa, "rhs", Access::Read, Index::Own);
    assert_eq!((line.lines, line.useful_bytes), (expected(4, 0), 4 * cells));
    // In AoS the records are 16 bytes, of which 4 are of use.
    let line = of(&aos, "rhs", Access::Read, Index::Own);
    assert_eq!((line.lines, line.useful_bytes), (expected(16, 8), 4 * cells));
    assert!((line.useful_bytes_a_line() - 16.0).abs() < 0.5, "a quarter of each line: {line:?}");
    let row = lines_of((N + 1) * 16, N - 2, 16, 4);
    assert_eq!(row, (17, 256), "64 records of 16 bytes that begin in the middle of a line");
}

#[test]
fn particle_to_grid_by_hand() {
    const NODES: usize = 32;
    let places: Vec<Vec2> = (0..500).map(|p| vec2(1.5 + (p % 27) as f32, 1.5 + (p / 27) as f32)).collect();
    let mut points = Field::<Point, Aos>::new([places.len()]);
    points.members_mut().x.copy_from_slice(&places);
    let mut grid = Field::<Momentum, Soa>::new([NODES, NODES]);
    let recording = recorded(|| particle_to_grid(&points, &mut grid));
    let [clear, scatter] = recording.loops.as_slice() else { panic!("two loops: {recording:#?}") };
    assert_eq!((clear.number, scatter.number), (0, 1));
    let nodes = (NODES * NODES) as u64;
    for (member, bytes) in [("v", 8), ("m", 4)] {
        let written = of(clear, member, Access::Write, Index::Own);
        assert_eq!((written.count, written.bytes), (nodes, bytes * nodes));
        assert_eq!((written.lines, written.useful_bytes), (bytes * nodes / 64, bytes * nodes), "all of it");
        let added = of(scatter, member, Access::Accumulate, Index::Computed);
        assert_eq!((added.count, added.bytes), (9 * 500, 9 * 500 * bytes));
    }
    // The points' boxes cover rows 1..=29 and columns 1..=21: 27 and 19 places and two nodes more.
    let mut covered = vec![false; NODES * NODES];
    for x in &places {
        for (i, j) in (0..9).map(|n| (n / 3, n % 3)) {
            covered[(x.x as usize + i) * NODES + x.y as usize + j] = true;
        }
    }
    let touched = covered.iter().filter(|&&node| node).count() as u64;
    assert_eq!(of(scatter, "v", Access::Accumulate, Index::Computed).useful_bytes, 8 * touched);
    assert_eq!(of(scatter, "m", Access::Accumulate, Index::Computed).useful_bytes, 4 * touched);
    // Records of a point are 20 bytes.
    for (member, seat, bytes) in [("x", 0, 8), ("v", 8, 8), ("m", 16, 4)] {
        let read = of(scatter, member, Access::Read, Index::Own);
        assert_eq!((read.lines, read.useful_bytes), lines_of(seat, 500, 20, bytes), "{member}");
    }
    // All is in the second-level cache's reach: each line is fetched once.
    let misses: u64 = recording.loops.iter().flat_map(|counts| &counts.members).map(|m| m.misses[1]).sum();
    assert_eq!(misses, nodes * 12 / 64 + (500u64 * 20).div_ceil(64));
    let heat = |field: &str| recording.heat.iter().find(|heat| heat.field == field).expect("its heat");
    let touches: u64 = heat("grid").touches.iter().map(|&touches| u64::from(touches)).sum();
    assert_eq!(touches, 3 * (nodes + 9 * 500), "component by component");
    assert_eq!(heat("points").touches.len(), (500usize * 20).div_ceil(64));
}

#[kernel]
fn scale(u: &mut Field<f32, _>) {
    for i in u {
        u[i] = 2.0 * u[i];
    }
}

#[test]
fn a_stream_misses_each_line_once() {
    let mut u = Field::<f32, Aos>::new([1 << 16]);
    let caches = Caches { first: Cache { bytes: 4096, ways: 4 }, ..Caches::default() };
    let ((), recording) = record(&caches, || {
        scale(&mut u);
        scale(&mut u);
    })
    .expect("a recording");
    let members = &recording.loops[0].members;
    let misses = |level: usize| members.iter().map(|member| member.misses[level]).sum::<u64>();
    assert_eq!((misses(0), misses(1)), (2 * 4096, 4096), "the second level holds all of it");
    let shared = recording.loops[0].shared_lines;
    assert_eq!(shared, 0, "the halves of a field of whole lines share none");
}

#[test]
fn halves_that_meet_in_a_line_share_it() {
    // Four blocks of 100 elements; the halves meet at element 200, 800 bytes on: in the middle of line 12.
    let mut u = Field::<f32, Aos>::new([400]);
    let schedule = Schedule { grain: 100, ..Schedule::default() };
    let recording = recorded(|| schedule.run(|| scale(&mut u)));
    assert_eq!(recording.loops[0].shared_lines, 1);
}

#[test]
fn sparse_fields_are_recorded_block_by_block() {
    let mut grid = Field::<Momentum, Sparse<4>>::new([64, 64]);
    let mut points = Field::<Point, Soa>::new([1]);
    points.members_mut().x.set([0], vec2(10.5, 10.5));
    let recording = recorded(|| particle_to_grid(&points, &mut grid));
    let scatter = recording.loops.last().expect("a loop");
    assert_eq!(of(scatter, "m", Access::Accumulate, Index::Computed).count, 9);
    assert_eq!(of(scatter, "m", Access::Accumulate, Index::Computed).useful_bytes, 4 * 9);
    assert_eq!(grid.active_len(), 4 * 16);
}

#[test]
fn one_recording_a_thread() {
    let ((inner, ()), recording) = record(&Caches::default(), || {
        let inner = record(&Caches::default(), || ());
        (inner.map(|_| ()), ())
    })
    .expect("a recording");
    assert_eq!(inner, Err(RecordError::Busy));
    assert_eq!(recording, Recording::default());
    let caches = Caches { first: Cache { bytes: 1000, ways: 8 }, ..Caches::default() };
    let error = record(&caches, || ()).expect_err("no such cache");
    assert_eq!(error.to_string(), "a cache of 1000 bytes has no whole number of sets of 8 lines of 64 bytes");
    let panicked = std::panic::catch_unwind(|| record(&Caches::default(), || panic!("in the middle")));
    assert!(panicked.is_err());
    assert!(record(&Caches::default(), || ()).is_ok(), "the thread can record again");
}
