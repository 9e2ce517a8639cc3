//! Every way finds the pairs that a loop over all pairs finds.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope_solvers::sph::neighbours::*;

/// For each particle, how many are near, and the sum of a function of their numbers; each is visited at most once.
#[kernel]
fn tally<X: Spatial, W: Walk<X>>(
    x: &Field<X::Vec<f32>, Soa>,
    ids: &Field<u32, Soa>,
    near: &Field<u32, W::Layout, W::Axes>,
    walk: &W,
    squared: f32,
    found: &mut Field<UVec2, Soa>,
) {
    for p in x {
        let own = x[p];
        let mut sum = UVec2::ZERO;
        walk.each(near, p, own, |q| {
            if (x[q] - own).length_squared() < squared {
                sum += uvec2(1, mixed(ids[q]));
            }
        });
        found[p] = sum;
    }
}

/// Sums of such numbers differ where sets of ids do.
fn mixed(id: u32) -> u32 {
    (id + 1).wrapping_mul(2_654_435_761) >> 8
}

/// In the order of the ids.
fn found<X: Spatial, S: Search<X>>(x: &[X::Vec<f32>], options: &Options<X>) -> Result<Vec<UVec2>, Crowded> {
    let mut search = S::new(options).unwrap();
    let mut ids: Vec<u32> = (0..x.len() as u32).collect();
    if S::SORTED {
        ids.sort_by_key(|&id| search.key(x[id as usize]));
    }
    let mut places = Field::<X::Vec<f32>, Soa>::new([x.len()]);
    ids.iter().enumerate().for_each(|(p, &id)| places.set(p, x[id as usize]));
    let mut names = Field::<u32, Soa>::new([x.len()]);
    names.copy_from_slice(&ids);
    let mut sums = Field::<UVec2, Soa>::new([x.len()]);
    // Twice: what a search kept of an earlier time must not be found again.
    for _ in 0..2 {
        search.update(&places)?;
    }
    tally::<X, S::Walk>(&places, &names, search.near(), &search.walk(), options.radius * options.radius, &mut sums);
    let mut found = vec![UVec2::ZERO; x.len()];
    ids.iter().zip(sums.iter()).for_each(|(&id, sum)| found[id as usize] = sum);
    Ok(found)
}

fn agrees<X: Spatial>(what: &str, x: &[X::Vec<f32>], options: Options<X>) {
    let options = Options { particles: x.len(), ..options };
    let near = |a: &X::Vec<f32>, b: &X::Vec<f32>| (*b - *a).length_squared() < options.radius * options.radius;
    let of = |a: &X::Vec<f32>| {
        let near = x.iter().enumerate().filter(|(_, b)| near(a, b));
        near.map(|(id, _)| uvec2(1, mixed(id as u32))).fold(UVec2::ZERO, |sum, one| sum + one)
    };
    let expected: Vec<UVec2> = x.iter().map(of).collect();
    for threads in [1, 2] {
        Schedule { threads, ..Schedule::default() }.run(|| {
            assert!(found::<X, SortedCells<X>>(x, &options).unwrap() == expected, "{what}: sorted cells");
            assert!(found::<X, CellLists<X>>(x, &options).unwrap() == expected, "{what}: cells");
            assert!(found::<X, HashedCells<X>>(x, &options).unwrap() == expected, "{what}: hashed cells");
            assert!(found::<X, NeighbourLists<X>>(x, &options).unwrap() == expected, "{what}: neighbour lists");
        });
    }
}

fn scattered<X: Spatial>(count: usize, lower: f32, upper: f32) -> Vec<X::Vec<f32>> {
    let draw = |p: usize, axis: usize| random::<f32>(11, (p as u64, axis as u32));
    (0..count).map(|p| X::Vec::<f32>::from_fn(|axis| lower + (upper - lower) * draw(p, axis))).collect()
}

fn everywhere<X: Spatial>() {
    let cube = |side: f32| Options::<X> {
        radius: 0.125,
        lower: X::Vec::<f32>::splat(0.0),
        upper: X::Vec::<f32>::splat(side),
        ..Options::new(0)
    };
    agrees::<X>("scattered", &scattered::<X>(1500, 0.0, 1.0), cube(1.0));
    agrees::<X>("scattered, with a skin", &scattered::<X>(800, 0.0, 1.0), Options { skin: 0.03, ..cube(1.0) });
    // Beyond the box on all sides.
    agrees::<X>("outside", &scattered::<X>(700, -0.4, 1.3), cube(0.9));
    agrees::<X>("a box smaller than the radius", &scattered::<X>(100, 0.0, 0.1), cube(0.1));
    agrees::<X>(
        "far away",
        &scattered::<X>(500, -70.0, -69.0),
        Options { lower: X::Vec::<f32>::splat(-70.0), upper: X::Vec::<f32>::splat(-69.0), ..cube(1.0) },
    );
    // On the borders of cells, at multiples of the radius and a hair beside them; cells are a thousandth wider.
    let border = |side: f32| {
        let along = |n: usize| side * (n as f32) * (1.0 + [0.0, 1e-7, -1e-7][n % 3]);
        let count = if X::RANK == 2 { 81 } else { 729 };
        (0..count).map(|n| X::Vec::<f32>::from_fn(|axis| along(n / [1, 9, 81][axis] % 9))).collect::<Vec<_>>()
    };
    agrees::<X>("on borders", &border(0.125), cube(1.0));
    agrees::<X>("on the cells' borders", &border(0.125 * 1.001), cube(1.0));
    // A cluster, with some at one place.
    let mut cluster = scattered::<X>(300, 0.0, 1.0);
    cluster.extend(scattered::<X>(60, 0.49, 0.51));
    cluster.extend([X::Vec::<f32>::splat(0.5); 10]);
    agrees::<X>("clustered", &cluster, cube(1.0));
}

#[test]
fn all_ways_find_all_pairs_in_the_plane() {
    everywhere::<Ij>();
}

#[test]
fn all_ways_find_all_pairs_in_space() {
    everywhere::<Ijk>();
}

#[test]
fn lists_that_are_too_short_name_particle_and_count() {
    let mut x = scattered::<Ij>(50, 0.0, 1.0);
    x.extend(vec![vec2(0.5, 0.5); 140]);
    let options = Options::<Ij> { radius: 0.01, ..Options::new(x.len()) };
    let Crowded { particle, count, most, in_cell } = found::<Ij, NeighbourLists<Ij>>(&x, &options).unwrap_err();
    assert_eq!((count, most, in_cell), (140, 128, false));
    // Sorted, the 140 stand together behind those in lower cells.
    assert!(particle < 51, "{particle}");
    assert!(found::<Ij, SortedCells<Ij>>(&x, &options).is_ok());
    for error in [found::<Ij, CellLists<Ij>>(&x, &options), found::<Ij, HashedCells<Ij>>(&x, &options)] {
        let error = error.unwrap_err();
        assert_eq!((error.particle, error.count, error.most), (50, 140, MOST_IN_CELL));
        assert_eq!(error.to_string(), "particle 50 has 140 particles in its cell, whose list holds at most 128");
    }
    let longer = Options { most: 140, ..options };
    assert!(found::<Ij, NeighbourLists<Ij>>(&x, &longer).is_ok());
}
