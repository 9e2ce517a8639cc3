//! Unrolled stencils around bases: blocks that are found once a base, beside dense fields.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::Numbers;

/// Adds to three elements along each axis around every base.
#[kernel]
fn scatter<X: Spatial>(bases: &[u32], field: &mut Field<i64, _, X>, places: &[X::Index]) {
    for b in bases {
        let base = places[bases[b] as usize];
        for offset in unroll!(X, 0..3) {
            // Some offsets are left out, so that blocks stay away where nothing is added.
            if !(bases[b] + offset[0] as u32).is_multiple_of(4) {
                field[base + offset] += i64::from(bases[b] + 1);
            }
        }
    }
}

/// Adds to all of them.
#[kernel]
fn scatter_to_all<X: Spatial>(bases: &[u32], field: &mut Field<i64, _, X>, places: &[X::Index]) {
    for b in bases {
        let base = places[bases[b] as usize];
        for offset in unroll!(X, 0..3) {
            field[base + offset] += i64::from(bases[b] + 1);
        }
    }
}

/// Adds up the elements around every base.
#[kernel]
fn gather<X: Spatial>(bases: &[u32], field: &Field<i64, _, X>, places: &[X::Index], sums: &mut Field<i64, Soa>) {
    for b in bases {
        let base = places[bases[b] as usize];
        let mut sum = 0;
        for offset in unroll!(X, 0..3) {
            sum += field[base + offset];
        }
        sums[b] = sum;
    }
}

/// A block is there if something was added to it, and only then.
fn needed<X: Spatial, L: Layout<X>>(sparse: &mut Field<i64, L, X>) {
    let blocks = sparse.blocks().len();
    sparse.prune();
    assert!(blocks > 0 && sparse.blocks().len() == blocks, "blocks to which nothing was added");
}

/// The same around the same bases in a sparse and a dense field.
fn check<X: Spatial, L: Layout<X>>(mut sparse: Field<i64, L, X>, mut dense: Field<i64, Aos, X>, first: i32, end: i32) {
    let mut numbers = Numbers(end as u64);
    // Up to the field's ends on both sides.
    let places: Vec<X::Index> =
        (0..500).map(|_| X::Index::from_fn(|_| first + numbers.below((end - 2 - first) as usize) as i32)).collect();
    let bases: Vec<u32> = (0..500).collect();
    let mut sums = [Field::<i64, Soa>::new([bases.len()]), Field::<i64, Soa>::new([bases.len()])];
    for scatter_by in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
        for threads in [1, 3] {
            sparse.clear();
            dense.fill(0);
            Schedule { threads, scatter: scatter_by, grain: 16, ..Schedule::default() }.run(|| {
                scatter(&bases, &mut sparse, &places);
                scatter(&bases, &mut dense, &places);
                gather(&bases, &sparse, &places, &mut sums[0]);
                gather(&bases, &dense, &places, &mut sums[1]);
            });
            assert_eq!(sums[0].to_vec(), sums[1].to_vec(), "{scatter_by}, {threads} threads");
            let total: i64 = sparse.active_iter().map(|(_, value)| value).sum();
            assert_eq!(total, dense.iter().sum::<i64>(), "{scatter_by}, {threads} threads");
            needed(&mut sparse);
            sparse.clear();
            dense.fill(0);
            Schedule { threads, scatter: scatter_by, grain: 16, ..Schedule::default() }.run(|| {
                scatter_to_all(&bases, &mut sparse, &places);
                scatter_to_all(&bases, &mut dense, &places);
            });
            // Cells of a block beyond the dense field hold nothing.
            for (at, value) in sparse.active_iter().filter(|(_, value)| *value != 0) {
                assert_eq!(value, dense.get(at), "{scatter_by}, {threads} threads, {at:?}");
            }
            let total: i64 = sparse.active_iter().map(|(_, value)| value).sum();
            assert_eq!(total, dense.iter().sum::<i64>(), "{scatter_by}, {threads} threads");
            needed(&mut sparse);
        }
    }
}

#[test]
fn blocks_around_a_base_are_those_of_its_offsets() {
    let plane = || Field::<i64, Aos>::new([43, 43]).with_origin([-20, -20]);
    check(Field::<i64, Sparse<4>>::new([43, 43]).with_origin([-20, -20]), plane(), -20, 23);
    check(
        Field::<i64, layout!(pointer(ij).dense(ij, (5, 3)).aos)>::new([43, 43]).with_origin([-20, -20]),
        plane(),
        -20,
        23,
    );
    check(
        Field::<i64, layout!(pointer(ij, 3).bitmasked(ji, 4).aos)>::new([43, 43]).with_origin([-20, -20]),
        plane(),
        -20,
        23,
    );
    // Neighbours in a block lie at various distances.
    check(
        Field::<i64, layout!(pointer(ij).morton(ij, 4).aos)>::new([43, 43]).with_origin([-20, -20]),
        plane(),
        -20,
        23,
    );
    // The box is wider than a block.
    check(
        Field::<i64, layout!(pointer(ij).dense(ij, (1, 4)).aos)>::new([43, 43]).with_origin([-20, -20]),
        plane(),
        -20,
        23,
    );
    check(Field::<i64, SparseHash<4>, Ij>::unbounded(), plane(), -20, 23);
    let space = || Field::<i64, Aos>::new([14, 14, 14]);
    check(Field::<i64, Sparse<4>>::new([14, 14, 14]), space(), 0, 14);
    check(Field::<i64, SparseHash<3>, Ijk>::unbounded(), space(), 0, 14);
}

/// Adds along the diagonal of a box, in three ways.
#[kernel]
fn diagonal(way: i32, field: &mut Field<i64, _, Ij>, base: IVec2) {
    for t in 0..1 {
        if way == 0 {
            for i in unroll!(0..3) {
                field[base + ivec2(i, i)] += 1 + i64::from(t);
            }
        }
        if way == 1 {
            for (i, j) in unroll!(0..3, 0..3) {
                if i == j {
                    field[base + ivec2(i, j)] += 1;
                }
            }
        }
        if way == 2 {
            for (i, j) in unroll!(0..3, 0..3) {
                if i != j {
                    continue;
                }
                field[base + ivec2(i, j)] += 1;
            }
        }
    }
}

#[test]
fn what_is_added_to_a_part_of_a_box_makes_no_other_block() {
    for way in 0..3 {
        let mut field = Field::<i64, Sparse<2>>::new([8, 8]);
        diagonal(way, &mut field, ivec2(1, 1));
        // Elements (1, 1), (2, 2) and (3, 3): of the four blocks that the box reaches two hold them.
        assert_eq!(field.active_len(), 2 * 4, "way {way}");
        assert_eq!(field.active_iter().map(|(_, value)| value).sum::<i64>(), 3, "way {way}");
    }
}
