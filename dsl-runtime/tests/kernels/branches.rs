//! Fields whose members stand under different nodes: a loop names the branch by a member.

use allotrope::prelude::*;

use crate::Node;

/// Runs a test in layouts of two branches, and in one of one branch.
macro_rules! in_branches {
    ($run:ident) => {
        $run::<layout!(Node: dense(ij).place([v]) + dense(ji).place([m]))>();
        $run::<layout!(Node: dense(ij).dense(ij, 4).place([m]) + dense(ij).place([split(v)]))>();
        $run::<layout!(Node: morton(ij, 4).place([m]) + dense(ij).dense(ij, (3, 2)).place([v]))>();
        $run::<Blocked<4>>();
    };
}

fn numbered<L: Layout<Ij>>() -> Field<Node, L, Ij> {
    let mut field = Field::<Node, L>::new([11, 13]);
    for i in 0..11 {
        for j in 0..13 {
            field.set([i, j], Node { v: vec2(i as f32, j as f32), m: (i * 20 + j) as f32 });
        }
    }
    field
}

#[kernel]
fn smooth(from: &Field<Node, _, Ij>, to: &mut Field<Node, _, Ij>) {
    for (i, j) in to.m.interior(1) {
        to.m[(i, j)] = from.m[(i - 1, j)] + from.m[(i + 1, j)] + from.m[(i, j - 1)] + from.m[(i, j + 1)];
        to.v[(i, j)] += from.v[(i, j)] - from.v[(i + 1, j - 1)];
    }
    for ij in to.v.border(1) {
        to[ij] = from[ij];
        to.m[ij] *= 2.0;
    }
}

#[test]
fn stencils_own_elements_and_whole_records() {
    fn run<L: Layout<Ij>>() {
        let from = numbered::<L>();
        let mut to = numbered::<L>();
        smooth(&from, &mut to);
        for i in 0..11usize {
            for j in 0..13usize {
                let at = from.get([i, j]);
                let inside = (1..10).contains(&i) && (1..12).contains(&j);
                let expected = match inside {
                    true => Node { v: at.v + vec2(-1.0, 1.0), m: 4.0 * at.m },
                    false => Node { v: at.v, m: 2.0 * at.m },
                };
                assert_eq!(to.get([i, j]), expected, "({i}, {j}) in {}", std::any::type_name::<L>());
            }
        }
    }
    in_branches!(run);
}

#[kernel]
fn scatter(keys: &Field<IVec2, _>, grid: &mut Field<Node, _, Ij>) {
    for p in keys {
        grid.m[keys[p]] += 1.0;
        grid.v[keys[p]] += vec2(p as f32, -1.0);
    }
}

#[kernel]
fn scatter_masses(keys: &Field<IVec2, _>, grid: &mut Field<Node, _, Ij>) {
    for p in keys {
        grid.m[keys[p]].max_assign(p as f32);
    }
}

#[test]
fn every_schedule_accumulates() {
    fn run<L: Layout<Ij>>() {
        let mut keys = Field::<IVec2, Soa>::new([3000]);
        (0..3000).for_each(|p| keys.set(p, ivec2(p * p % 11, p % 13)));
        for scatter_by in [Scatter::Serial, Scatter::Atomic, Scatter::Colored, Scatter::Private] {
            for threads in [1, 2] {
                let mut grid = Field::<Node, L>::new([11, 13]);
                let mut most = numbered::<L>();
                Schedule { threads, scatter: scatter_by, ..Schedule::default() }.run(|| {
                    scatter(&keys, &mut grid);
                    scatter_masses(&keys, &mut most);
                });
                for i in 0..11 {
                    for j in 0..13 {
                        let here: Vec<i32> = (0..3000).filter(|p| (p * p % 11, p % 13) == (i, j)).collect();
                        let sum: i32 = here.iter().sum();
                        let expected = Node { v: vec2(sum as f32, -(here.len() as f32)), m: here.len() as f32 };
                        assert_eq!(grid.get([i, j]), expected);
                        let most_here = here.last().map_or(0.0, |&p| p as f32).max((i * 20 + j) as f32);
                        assert_eq!(most.get([i, j]), Node { v: vec2(i as f32, j as f32), m: most_here });
                    }
                }
            }
        }
    }
    in_branches!(run);
}

#[kernel]
fn relax(grid: &mut Field<Node, _, Ij>, n: usize) {
    for (i, j) in grid.m.interior(1).checkerboard(0) {
        grid.m[(i, j)] = grid.m[(i, j + 1)] + grid.v[(i, j)].x;
    }
    for (i, j) in grid.v.colored(2, 2) {
        grid.v[(i, j)].y = -1.0;
    }
    #[serial]
    for (i, j) in grid.m {
        grid.m[(0, 0)] += grid.m[(i, j)];
    }
    for k in 0..n {
        for (i, j) in grid.m.interior(4) {
            grid.v[(k, 0)].x += grid.m[(i, j)];
        }
    }
}

#[test]
fn colours_serial_loops_and_inner_loops() {
    fn run<L: Layout<Ij>>() {
        let mut grid = numbered::<L>();
        relax(&mut grid, 2);
        let start = |i: usize, j: usize| (i * 20 + j) as f32;
        let mass = |i: usize, j: usize| {
            let inside = (1..10).contains(&i) && (1..12).contains(&j) && (i + j).is_multiple_of(2);
            if inside { start(i, j + 1) + i as f32 } else { start(i, j) }
        };
        let all =
            |inner: usize| (inner..11 - inner).flat_map(|i| (inner..13 - inner).map(move |j| mass(i, j))).sum::<f32>();
        assert_eq!(grid.get([0, 0]).m, all(0));
        assert_eq!(grid.get([5, 5]).m, mass(5, 5));
        assert_eq!(grid.get([0, 0]).v.x, all(4));
        assert_eq!((grid.get([1, 2]).v.y, grid.get([1, 3]).v.y), (-1.0, 3.0));
    }
    in_branches!(run);
}

#[test]
fn whole_fields_change_their_layout() {
    type Two = layout!(Node: dense(ij).dense(ij, 4).place([m]) + dense(ji).place([v]));
    type Other = layout!(Node: dense(ij).place([split(v)]) + morton(ij, 2).place([m]));
    let rows = numbered::<Aos>();
    let two = rows.relayout::<Two>();
    let other = two.relayout::<Other>();
    assert!(other.iter().eq(rows.iter()) && two.clone().iter().eq(rows.iter()));
    assert_eq!(two.members().v.to_vec(), rows.members().v.to_vec());
    let mut copy = Field::<Node, Two>::new([11, 13]).with_background(Node { v: Vec2::ONE, m: 3.0 });
    assert_eq!(copy.get([10, 12]), Node { v: Vec2::ONE, m: 3.0 });
    copy.members_mut().m.fill(7.0);
    assert_eq!(copy.get([10, 12]), Node { v: Vec2::ONE, m: 7.0 });
    copy.copy_from(&other);
    assert!(copy.iter().eq(rows.iter()));
}

#[test]
fn records_of_two_branches_are_sorted_whole() {
    type Two = layout!(Node: dense(i).place([m]) + dense(i).dense(i, 8).place([v]));
    let mut points = Field::<Node, Two>::new([100]);
    (0..100).for_each(|p| points.set(p, Node { v: vec2(p as f32, 1.0), m: (p * 37 % 100) as f32 }));
    points.reorder_by_key(|point| point.m as u32);
    for p in 0..100 {
        let point = points.get(p);
        assert_eq!((point.m, (point.v.x as usize * 37 % 100) as f32), (p as f32, p as f32));
    }
}
