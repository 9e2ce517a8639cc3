//! Accumulation at any index, under every schedule.

use allotrope::prelude::*;

use crate::Node;

/// Runs under schedules of one and several threads.
fn every_schedule(run: impl Fn()) {
    for scatter in [Scatter::Serial, Scatter::Atomic, Scatter::Private, Scatter::Colored, Scatter::Auto] {
        for threads in [1, 3] {
            Schedule { threads, scatter, ..Schedule::default() }.run(&run);
        }
    }
}

#[kernel]
fn histogram(keys: &Field<u8, _>, bins: &mut Field<u32, _>) {
    for p in keys {
        bins[keys[p]] += 1;
    }
}

#[test]
fn histograms_lose_no_count() {
    every_schedule(|| {
        let (mut keys, mut bins) = (Field::<u8, Aos>::new([50_000]), Field::<u32, Soa>::new([7]));
        for i in 0..50_000usize {
            keys.set(i, (i * i % 7) as u8);
        }
        histogram(&keys, &mut bins);
        let mut expected = [0u32; 7];
        (0..50_000usize).for_each(|i| expected[i * i % 7] += 1);
        assert_eq!(bins.iter().collect::<Vec<_>>(), expected);
    });
}

#[kernel]
fn count_both(keys: &Field<u8, _>, both: &mut Field<IVec2, _>) {
    for p in keys {
        both[keys[p]] += ivec2(1, 2);
    }
}

/// A component's run that does not fill its last cache line, before that of the next.
#[test]
fn every_component_of_a_bare_vector_is_combined() {
    fn run<L: Layout<I>>() {
        let mut keys = Field::<u8, Aos>::new([50_000]);
        (0..50_000usize).for_each(|p| keys.set(p, (p % 5) as u8));
        every_schedule(|| {
            let mut both = Field::<IVec2, L>::new([5]);
            count_both(&keys, &mut both);
            assert_eq!(both.iter().collect::<Vec<_>>(), [ivec2(10_000, 20_000); 5]);
        });
    }
    run::<Aos>();
    run::<Soa>();
    run::<Split>();
    run::<AoSoA<4>>();
}

/// What was found of a key.
#[derive(Record, Clone, Copy, Debug, PartialEq)]
struct Found {
    any: bool,
    weight: f64,
    all: bool,
    odd: bool,
}

#[kernel]
fn find(keys: &Field<u8, _>, found: &mut Field<Found, _>) -> (bool, bool) {
    let mut seen = (false, true);
    for p in keys {
        found.any[keys[p]] |= p > 40_000;
        found.all[keys[p]] &= p < 49_999;
        found.odd[keys[p]] ^= true;
        seen.0 |= keys[p] == 6;
        seen.1 &= keys[p] < 6;
    }
    seen
}

#[test]
fn truth_accumulates() {
    fn run<L: Layout<I>>() {
        let mut keys = Field::<u8, Soa>::new([50_000]);
        (0..50_000usize).for_each(|p| keys.set(p, (p * p % 7) as u8));
        every_schedule(|| {
            let mut found = Field::<Found, L>::new([7]);
            found.fill(Found { any: false, weight: 3.0, all: true, odd: false });
            assert_eq!(find(&keys, &mut found), (false, true));
            for key in 0..7 {
                let of = |p: &usize| p * p % 7 == key;
                let expected = Found {
                    any: (40_001..50_000).any(|p| of(&p)),
                    weight: 3.0,
                    all: !of(&49_999),
                    odd: (0..50_000).filter(of).count() % 2 == 1,
                };
                assert_eq!(found.get(key), expected);
            }
        });
    }
    run::<Aos>();
    run::<Split>();
}

/// What a cell gathers.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Cell {
    least: i32,
    most: i32,
    bits: u16,
    all: u16,
    odd: u8,
    product: i64,
    sum: IVec2,
    count: i32,
}

#[kernel]
fn gather_all(cells: &mut Field<Cell, _, Ij>, n: i32) {
    for i in 0..n {
        cells.least[(0, i % 3)].min_assign(i - 50);
        cells.most[(0, i % 3)].max_assign(i);
        cells.bits[(0, i % 3)] |= 1 << (i % 16);
        cells.all[(0, i % 3)] &= !(1 << (i % 5));
        cells.odd[(0, i % 3)] ^= 1;
        if i < 6 {
            cells.product[(0, i % 3)] *= i as i64 + 1;
        }
        cells.sum[(0, i % 3)] += ivec2(i, 1);
        cells.sum[(1, 0)] -= ivec2(0, 2);
        cells.count[(0, i % 3)] += 1;
    }
}

#[test]
fn every_operator_accumulates() {
    every_schedule(|| {
        let mut cells = Field::<Cell, Blocked<2>>::new([2, 3]);
        cells.fill(Cell { all: u16::MAX, product: 2, ..Cell::default() });
        gather_all(&mut cells, 3001);
        for k in 0..3 {
            let of = || (0..3001).filter(|i| i % 3 == k);
            let expected = Cell {
                least: of().fold(0, |a, i| a.min(i - 50)),
                most: of().fold(0, i32::max),
                bits: of().fold(0, |a, i| a | 1 << (i % 16)),
                all: of().fold(u16::MAX, |a, i| a & !(1 << (i % 5))),
                odd: (of().count() % 2) as u8,
                product: 2 * of().filter(|i| *i < 6).map(|i| i as i64 + 1).product::<i64>(),
                sum: ivec2(of().sum(), of().count() as i32),
                count: of().count() as i32,
            };
            assert_eq!(cells.get((0, k)), expected);
        }
        assert_eq!(cells.get((1, 0)).sum, ivec2(0, -6002));
    });
}

#[kernel]
fn springs(ends: &Field<[u32; 2], _>, masses: &mut Field<Node, _>) {
    #[scatter(Private)]
    for s in ends {
        let [a, b] = ends[s];
        let force = vec2(1.0, masses.m[a] - masses.m[b]);
        masses.v[a] += force;
        masses.v[b] -= force;
    }
}

#[test]
fn forces_of_springs_cancel() {
    every_schedule(|| {
        let (mut ends, mut masses) = (Field::<[u32; 2], Soa>::new([999]), Field::<Node, AoSoA<8>>::new([1000]));
        for s in 0..999 {
            ends.set(s, [s as u32, s as u32 + 1]);
        }
        (0..1000).for_each(|p| masses.set(p, Node { v: Vec2::ZERO, m: p as f32 }));
        springs(&ends, &mut masses);
        assert_eq!(masses.get(0).v, vec2(1.0, -1.0));
        assert_eq!(masses.get(999).v, vec2(-1.0, 1.0));
        assert!((1..999).all(|p| masses.get(p).v == Vec2::ZERO));
    });
}

#[kernel]
fn neighbours(cells: &mut Field<Node, _>) {
    for p in cells {
        cells.m[p] += 1.0;
        if p > 0 {
            cells.m[p - 1] += 10.0;
        }
        cells.v[p] = vec2(p as f32, 0.0);
    }
}

#[test]
fn own_and_other_elements_accumulate_together() {
    every_schedule(|| {
        let mut cells = Field::<Node, Aos>::new([5000]);
        neighbours(&mut cells);
        assert!((0..4999).all(|p| cells.get(p) == Node { v: vec2(p as f32, 0.0), m: 11.0 }));
        assert_eq!(cells.get(4999).m, 1.0);
    });
}
