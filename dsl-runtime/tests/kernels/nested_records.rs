//! Records in records: each member is reached by its path, an inner record as a whole as well.

use allotrope::prelude::*;

use crate::Node;

/// Two levels of records, and members on each.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Cell {
    flag: u8,
    node: Node,
    pair: Pair,
}

#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Pair {
    first: Node,
    weight: f64,
    ids: [i16; 3],
}

/// Runs a test in several layouts.
macro_rules! in_layouts {
    ($run:ident) => {
        $run::<Aos>();
        $run::<Soa>();
        $run::<layout!(dense(ij).dense(ij, 4).split)>();
        $run::<Blocked<4>>();
        $run::<layout!(Cell: dense(ij).place([node, flag], [pair.first.v], [split(pair.ids), pair.weight, pair.first.m]))>();
        $run::<layout!(Cell: dense(ij).dense(ij, 4).place([pair]) + dense(ji).place([node.m, flag], [split(node.v)]))>();
    };
}

fn cell(i: usize, j: usize) -> Cell {
    let n = (i * 20 + j) as f32;
    let node = |x: f32| Node { v: vec2(x, -n), m: n + x };
    Cell {
        flag: (i + j) as u8,
        node: node(0.25),
        pair: Pair { first: node(0.5), weight: f64::from(n) + 0.125, ids: [i as i16, j as i16, -1] },
    }
}

fn numbered<L: Layout<Ij>>() -> Field<Cell, L, Ij> {
    let mut field = Field::<Cell, L>::new([9, 10]);
    (0..9).for_each(|i| (0..10).for_each(|j| field.set([i, j], cell(i, j))));
    field
}

#[kernel]
fn step(from: &Field<Cell, _, Ij>, to: &mut Field<Cell, _, Ij>) {
    for (i, j) in to.node.interior(1) {
        to.node.m[(i, j)] = from.node.m[(i - 1, j)] + from.pair.first.m[(i, j + 1)];
        to.pair.first[(i, j)] = from.node[(i, j)];
        to.pair.ids[(i, j)][2] += from.pair.ids[(i + 1, j)][0];
        to.node.v[(i, j)].y = 7.0;
    }
}

#[test]
fn members_are_reached_by_their_paths() {
    fn run<L: Layout<Ij>>() {
        let from = numbered::<L>();
        let mut to = from.clone();
        step(&from, &mut to);
        for i in 0..9 {
            for j in 0..10 {
                let mut expected = cell(i, j);
                if (1..8).contains(&i) && (1..9).contains(&j) {
                    expected.node.m = cell(i - 1, j).node.m + cell(i, j + 1).pair.first.m;
                    expected.pair.first = cell(i, j).node;
                    expected.pair.ids[2] += (i + 1) as i16;
                    expected.node.v.y = 7.0;
                }
                assert_eq!(to.get([i, j]), expected, "({i}, {j}) in {}", std::any::type_name::<L>());
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn gather(cells: &mut Field<Cell, _, Ij>, at: &Field<IVec2, _>) -> (f64, i32) {
    let mut sum = (0.0, 0);
    for p in at {
        cells.pair.weight[at[p]] += 0.5;
        cells.node.v[at[p]].x += 1.0;
        sum.0 += cells.pair.first.m[at[p]] as f64;
        sum.1 += cells.flag[at[p]] as i32;
    }
    sum
}

#[test]
fn elements_of_inner_records_accumulate() {
    fn run<L: Layout<Ij>>() {
        let mut at = Field::<IVec2, Soa>::new([2000]);
        (0..2000).for_each(|p| at.set(p, ivec2(p * p % 9, p % 10)));
        for scatter in [Scatter::Serial, Scatter::Atomic, Scatter::Colored, Scatter::Private] {
            let mut cells = numbered::<L>();
            let sum = Schedule { threads: 2, scatter, ..Schedule::default() }.run(|| gather(&mut cells, &at));
            let mut expected = (0.0, 0);
            for p in 0..2000usize {
                let here = cell(p * p % 9, p % 10);
                expected = (expected.0 + f64::from(here.pair.first.m), expected.1 + i32::from(here.flag));
            }
            assert_eq!(sum, expected);
            for i in 0..9 {
                for j in 0..10 {
                    let count = (0..2000).filter(|p| (p * p % 9, p % 10) == (i, j)).count();
                    let mut expected = cell(i, j);
                    expected.pair.weight += 0.5 * count as f64;
                    expected.node.v.x += count as f32;
                    assert_eq!(cells.get([i, j]), expected);
                }
            }
        }
    }
    in_layouts!(run);
}

#[kernel]
fn average(u: &Member<f32, _, Ij>) -> f32 {
    let mut sum = 0.0;
    for ij in u {
        sum += u[ij];
    }
    sum / u.len() as f32
}

#[test]
fn the_host_reaches_members_of_members() {
    fn run<L: Layout<Ij>>() {
        let mut cells = numbered::<L>();
        let firsts: Vec<Node> = (0..90).map(|n| cell(n / 10, n % 10).pair.first).collect();
        assert_eq!(cells.members().pair.first.m.to_vec(), firsts.iter().map(|node| node.m).collect::<Vec<_>>());
        let mean: f32 = firsts.iter().map(|node| node.m).sum::<f32>() / 90.0;
        assert!((average(&cells.members().pair.first.m) - mean).abs() < 1e-3);
        let pair = cells.members_mut().pair;
        let (mut first, mut weight) = (pair.first.v, pair.weight);
        first.fill(vec2(3.0, 4.0));
        weight.set([2, 3], -1.0);
        let mut expected = cell(2, 3);
        (expected.pair.first.v, expected.pair.weight) = (vec2(3.0, 4.0), -1.0);
        assert_eq!(cells.get([2, 3]), expected);
        assert!(cells.relayout::<Aos>().iter().eq(cells.iter()));
    }
    in_layouts!(run);
}

#[test]
fn whole_records_are_sorted() {
    let mut cells = Field::<Cell, Soa>::new([90]);
    (0..90).for_each(|n| cells.set(n, cell(n * 7 % 90 / 10, n * 7 % 90 % 10)));
    cells.reorder_by_key(|cell| (cell.pair.ids[0] * 10 + cell.pair.ids[1]) as u32);
    assert!((0..90).all(|n| cells.get(n) == cell(n / 10, n % 10)));
}

#[kernel]
fn relax(cells: &mut Field<Cell, _, Ij>, at: &Field<IVec2, _>) {
    #[relaxed]
    for p in at {
        let pair = cells.pair[at[p]];
        cells.pair[at[p]] = Pair { weight: 1.0, ..pair };
        cells.pair.first.m[at[p]] += 1.0;
    }
}

#[test]
fn inner_records_meet_component_by_component() {
    let mut cells = numbered::<Aos>();
    let mut at = Field::<IVec2, Soa>::new([500]);
    (0..500).for_each(|p| at.set(p, ivec2(p % 3, 4)));
    Schedule { threads: 1, ..Schedule::default() }.run(|| relax(&mut cells, &at));
    let mut expected = cell(1, 4);
    (expected.pair.weight, expected.pair.first.m) = (1.0, expected.pair.first.m + 167.0);
    assert_eq!(cells.get([1, 4]), expected);
    assert_eq!(cells.get([4, 4]), cell(4, 4));
}
