//! Activity in kernels and on the host: what is fixed when a loop starts, and what is seen when.

use allotrope::prelude::*;

#[kernel]
fn grow(field: &mut Field<f32, _, Ij>) -> u32 {
    let mut visited = 0;
    for ij in field {
        visited += 1;
        field.activate(ij + ivec2(0, 1));
        field[ij] = 1.0;
    }
    visited
}

#[kernel]
fn shrink(field: &mut Field<f32, _, Ij>) -> u32 {
    let mut still = 0;
    for ij in field {
        field.deactivate(ij);
        if field.is_active(ij) {
            still += 1;
        }
    }
    still
}

/// Reads never activate; `+= 0.0` does, a branch that is not taken does not.
#[kernel]
fn touch(points: &Field<f32, _>, field: &mut Field<f32, _, Ij>) {
    for p in points {
        let q = (10 * p, 10 * p);
        if points[p] > 0.0 {
            field[q] += 0.0;
        }
    }
}

#[kernel]
fn sum(field: &Field<f32, _, Ij>) -> f32 {
    let mut sum = 0.0;
    for (i, j) in ndrange!(0..40, 0..40) {
        sum += field[(i, j)];
    }
    sum
}

/// Own writes to a sparse field from a loop over another.
#[kernel]
fn copy(from: &Field<f32, _, Ij>, to: &mut Field<f32, _, Ij>) {
    for ij in from {
        if from[ij] > 1.5 {
            to[ij] = from[ij];
        }
    }
}

type Bits = layout!(pointer(ij, 2).bitmasked(ij, 4).aos);

#[test]
fn elements_are_fixed_when_a_loop_starts() {
    for threads in [1, 3] {
        Schedule { threads, grain: 1, ..Schedule::default() }.run(|| {
            let mut field = Field::<f32, Bits>::new([40, 40]);
            (0..10).for_each(|i| field.set([i, 0], 0.5));
            assert_eq!(grow(&mut field), 10);
            assert_eq!(field.active_len(), 20);
            assert_eq!(grow(&mut field), 20);
            assert_eq!(field.active_len(), 30);
            assert_eq!((field.get([3, 1]), field.get([3, 2])), (1.0, 0.0));
            assert_eq!(shrink(&mut field), 30, "deactivation comes when the loop ends");
            assert_eq!((field.active_len(), field.blocks().len()), (0, 0));
        });
    }
}

#[test]
fn what_activates() {
    let mut points = Field::<f32, Aos>::new([4]);
    points.copy_from_slice(&[0.0, 1.0, 0.0, 1.0]);
    for scatter in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
        Schedule { threads: 2, grain: 1, scatter, ..Schedule::default() }.run(|| {
            let mut field = Field::<f32, Bits>::new([40, 40]);
            touch(&points, &mut field);
            let active: Vec<IVec2> = field.active_iter().map(|(at, _)| at).collect();
            assert_eq!(active, [ivec2(10, 10), ivec2(30, 30)]);
            assert_eq!(sum(&field), 0.0);
            assert_eq!(field.active_len(), 2, "reads do not activate");
        });
    }
}

#[test]
fn own_writes_elsewhere_activate_what_they_write() {
    let mut from = Field::<f32, Sparse<8>>::new([40, 40]);
    let mut to = Field::<f32, Bits>::new([40, 40]);
    let mut same = Field::<f32, Sparse<8>>::new([40, 40]);
    from.set([3, 4], 2.0);
    from.set([3, 5], 1.0);
    from.set([30, 30], 1.0);
    copy(&from, &mut to);
    copy(&from, &mut same);
    assert_eq!(to.active_iter().collect::<Vec<_>>(), [(ivec2(3, 4), 2.0)]);
    assert_eq!((same.active_len(), same.get([3, 4])), (64, 2.0));
    let dense = from.relayout::<Aos>();
    let mut sparse = Field::<f32, Sparse<8>>::new([40, 40]);
    copy(&dense, &mut sparse);
    assert_eq!((sparse.active_len(), sparse.get([3, 4])), (64, 2.0));
}

#[test]
fn relayouts_keep_activity() {
    let mut from = Field::<f32, Bits>::new([40, 40]).with_background(-1.0);
    from.set([3, 4], 2.0);
    from.activate([30, 31]);
    let to = from.relayout::<layout!(hash(ij).bitmasked(ij, 8).aos)>();
    assert!(to.active_iter().eq([(ivec2(3, 4), 2.0), (ivec2(30, 31), -1.0)]));
    let rows = from.relayout::<Aos>();
    assert_eq!((rows.get([0, 0]), rows.get([3, 4])), (-1.0, 2.0));
    let mut other = Field::<f32, layout!(pointer(ij, 3).pointer(ij, 5).aos)>::new([40, 40]);
    other.set([1, 1], 5.0);
    other.copy_from(&from);
    assert!(other.active_iter().eq(from.active_iter()));
    assert_eq!(other.background(), -1.0);
}

#[test]
fn files_keep_activity() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("field.npz");
    let mut field = Field::<f32, layout!(hash(ij).bitmasked(ij, 8).aos), Ij>::unbounded();
    field.set([-1_000_000, 7], 2.0);
    field.activate([5, 1_000_000]);
    field.save(&path).expect("saved");
    let mut again = Field::<f32, SparseHash<4>, Ij>::unbounded();
    again.set([0, 0], 1.0);
    again.load(&path).expect("loaded");
    assert_eq!((again.get([-1_000_000, 7]), again.get([0, 0]), again.active_len()), (2.0, 0.0, 32));
    let error = Field::<f32, Bits>::new([40, 40]).load(&path).expect_err("outside");
    assert!(
        error.to_string().contains("has the index [-1000000, 7] in row 0, which lies outside of the field"),
        "{error}"
    );
}

#[test]
fn branches_have_their_own_activity() {
    #[derive(Record, Clone, Copy, Default, PartialEq, Debug)]
    struct Node {
        v: Vec2,
        m: f32,
    }
    #[kernel]
    fn add(grid: &mut Field<Node, _, Ij>, at: IVec2) -> u32 {
        let mut visited = 0;
        for ij in grid.m {
            grid.m[ij] += 1.0;
            visited += 1;
        }
        for _ in 0..1 {
            grid.m.activate(at);
        }
        visited
    }
    type Both = layout!(Node: dense(ij).place([v]) + pointer(ij).bitmasked(ij, 8).place([m]));
    let mut grid = Field::<Node, Both>::new([40, 40]);
    assert_eq!(add(&mut grid, ivec2(3, 4)), 0);
    assert_eq!(add(&mut grid, ivec2(30, 4)), 1);
    assert_eq!(add(&mut grid, ivec2(30, 4)), 2);
    assert_eq!((grid.get([3, 4]).m, grid.get([30, 4]).m, grid.get([0, 0]).m), (2.0, 1.0, 0.0));
    grid.members_mut().v.set([7, 7], Vec2::ONE);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("grid.npz");
    grid.save(&path).expect("saved");
    let mut again = Field::<Node, Both>::new([40, 40]);
    again.load(&path).expect("loaded");
    assert_eq!(add(&mut again, ivec2(3, 4)), 2);
    let same = again.clone();
    assert_eq!((same.get([3, 4]).m, same.get([7, 7]).v), (3.0, Vec2::ONE));
}

#[test]
fn bytes_follow_the_blocks() {
    let mut shell = Field::<f32, layout!(pointer(ijk, 8).bitmasked(ijk, 8).aos)>::new([256, 256, 256]);
    for i in 20..236 {
        for j in 20..236 {
            let (x, y) = (i as f32 - 128.0, j as f32 - 128.0);
            let inside = 90.0f32.powi(2) - x * x - y * y;
            if inside > 0.0 {
                shell.set([i, j, (128.0 + inside.sqrt()) as i32], 1.0);
                shell.set([i, j, (128.0 - inside.sqrt()) as i32], 1.0);
            }
        }
    }
    // Of a block of 8^3 values with its bits.
    let blocks = shell.blocks().len() * (8 * 8 * 8 * 4 + 64);
    let table = 32 * 32 * 32 * 8;
    assert!(shell.bytes() as f64 <= 1.05 * blocks as f64 + table as f64, "{} of {blocks}", shell.bytes());
    shell.clear();
    shell.prune();
    assert!(shell.bytes() <= table + 64, "{} bytes of nothing", shell.bytes());
}

/// Notes the elements in the loop's order.
#[kernel]
fn order(field: &Field<f32, _, Ij>, seen: &mut Field<IVec2, layout!(dynamic(i, 1_000_000, chunk = 4096).aos), I>) {
    for at in field {
        seen.append((), at);
    }
}

/// So many blocks that several jobs look for the active ones: what they find is one list, in memory order.
#[test]
fn active_blocks_of_large_roots_come_in_memory_order() {
    fn check<L: Layout<Ij>>(mut field: Field<f32, L, Ij>, side: i32) {
        let mut numbers = super::Numbers(side as u64);
        for round in 0..3 {
            for _ in 0..if cfg!(allotrope_sanitized) { 800 } else { 8_000 } {
                let at = ivec2(numbers.below(1200) as i32, numbers.below(1200) as i32);
                if round == 2 { field.deactivate(at) } else { field.set(at, 1.0) }
            }
            let mut expected: Vec<IVec2> = field.active_iter().map(|(at, _)| at).collect();
            expected.sort_by_key(|at| (at.x / side, at.y / side, at.x % side, at.y % side));
            let mut seen = Field::<IVec2, layout!(dynamic(i, 1_000_000, chunk = 4096).aos), I>::new([]);
            Schedule { threads: 3, deterministic: true, ..Schedule::default() }.run(|| order(&field, &mut seen));
            let seen: Vec<IVec2> = seen.active_iter().map(|(_, at)| at).collect();
            assert!(seen == expected, "round {round}: {} elements, {} expected", seen.len(), expected.len());
        }
    }
    check(Field::<f32, layout!(pointer(ij).bitmasked(ij, 4).aos)>::new([1200, 1200]), 4);
    check(Field::<f32, Sparse<4>>::new([1200, 1200]), 4);
    check(Field::<f32, layout!(hash(ij).bitmasked(ij, 4).aos), Ij>::unbounded(), 4);
}
