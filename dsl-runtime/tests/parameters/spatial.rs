//! One record and one kernel for two and three axes, single and double precision.

use allotrope::prelude::*;
use allotrope::spatial::*;

/// A material point.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Point<X: Spatial, T: Real> {
    x: X::Vec<T>,
    v: X::Vec<T>,
    c: X::Mat<T>,
}

/// A grid node.
#[derive(Record, Clone, Copy, Default, Debug, PartialEq)]
struct Node<X: Spatial, T: Real> {
    v: X::Vec<T>,
    m: T,
}

/// A layout that names members, whatever the parameters.
type Parted<X, T> = layout!(Point<X, T>: dense(i).dense(i, 4).place([x, v], [split(c)]));

/// Quadratic B-spline weights of the three nodes along each axis.
fn weights<X: Spatial, T: Real>(fx: X::Vec<T>) -> [X::Vec<T>; 3] {
    let real = T::from_f64;
    let square = |v: X::Vec<T>| v * v;
    let half = X::Vec::<T>::splat(real(0.5));
    [square(-fx + real(1.5)) * half, -square(fx - real(1.0)) + real(0.75), square(fx - real(0.5)) * half]
}

/// The product of the weights along all axes.
fn weight<X: Spatial, T: Real>(w: &[X::Vec<T>; 3], offset: X::Index) -> T {
    X::Vec::<T>::from_fn(|axis| w[offset[axis] as usize][axis]).element_product()
}

/// Scatters mass and momentum with the affine term of APIC.
#[kernel]
fn particle_to_grid<X: Spatial, T: Real>(
    points: &Field<Point<X, T>, _>,
    grid: &mut Field<Node<X, T>, _, X>,
    inv_dx: T,
    mass: T,
) {
    for p in points {
        let at = points.x[p] * inv_dx;
        let base = (at - T::from_f64(0.5)).to_index();
        let fx = at - base.to_vec();
        let w = weights::<X, T>(fx);
        for offset in unroll!(X, 0..3) {
            let weight = weight::<X, T>(&w, offset);
            if weight == T::from_f64(0.0) {
                continue;
            }
            let distance = (offset.to_vec::<T>() - fx) * inv_dx.recip();
            grid.v[base + offset] += (points.v[p] + points.c[p] * distance) * (weight * mass);
            grid.m[base + offset] += weight * mass;
        }
    }
}

/// Momentum to velocity, and a fall.
#[kernel]
fn grid_update<X: Spatial, T: Real>(grid: &mut Field<Node<X, T>, _, X>, fall: X::Vec<T>) -> T {
    let mut mass = T::from_f64(0.0);
    for at in grid.interior(1) {
        mass += grid.m[at];
        if grid.m[at] > T::from_f64(0.0) {
            grid.v[at] = grid.v[at] * grid.m[at].recip() + fall;
        }
    }
    mass
}

/// Gathers velocities, with a loop that is not in a kernel's parallel loop around it.
#[kernel]
fn grid_to_particle<X: Spatial, T: Real>(
    points: &mut Field<Point<X, T>, _>,
    grid: &Field<Node<X, T>, _, X>,
    inv_dx: T,
) -> X::Vec<T> {
    let mut momentum = X::Vec::<T>::default();
    for p in points {
        let at = points.x[p] * inv_dx;
        let base = (at - T::from_f64(0.5)).to_index();
        let w = weights::<X, T>(at - base.to_vec());
        let mut v = X::Vec::<T>::default();
        for offset in unroll!(X, 0..3) {
            v += grid.v[base + offset] * weight::<X, T>(&w, offset);
        }
        points.v[p] = v;
        momentum += v;
    }
    momentum
}

/// Points on a diagonal that rise along the last axis and turn.
fn points<X: Spatial, T: Real, L: Layout<I>>(count: usize) -> Field<Point<X, T>, L> {
    let mut points = Field::<Point<X, T>, L>::new([count]);
    for p in 0..count {
        let mut point = Point::<X, T>::default();
        for axis in 0..X::RANK {
            point.x[axis] = T::from_f64(2.2 + 0.13 * p as f64 + 0.31 * axis as f64);
        }
        point.v[X::RANK - 1] = T::from_f64(0.5);
        points.set(p, point);
    }
    points
}

/// The mass on the grid and the points' momentum after a step.
fn step<X: Spatial, T: Real, P: Layout<I>, G: Layout<X>>(
    mut grid: Field<Node<X, T>, G, X>,
    scatter: Scatter,
) -> (f64, X::Vec<T>) {
    let mut points = points::<X, T, P>(20);
    let mut fall = X::Vec::<T>::default();
    fall[0] = T::from_f64(-0.25);
    let schedule = Schedule { threads: 2, grain: 4, scatter, ..Schedule::default() };
    schedule.run(|| {
        particle_to_grid(&points, &mut grid, T::from_f64(1.0), T::from_f64(2.0));
        let mass = grid_update(&mut grid, fall);
        (mass.to_f64(), grid_to_particle(&mut points, &grid, T::from_f64(1.0)))
    })
}

#[test]
fn mass_and_momentum_are_kept_in_plane_and_space() {
    fn run<X: Spatial, T: Real, P: Layout<I>, G: Layout<X>>(
        grid: impl Fn() -> Field<Node<X, T>, G, X>,
        tolerance: f64,
    ) {
        for scatter in [Scatter::Serial, Scatter::Private, Scatter::Atomic, Scatter::Colored] {
            let (mass, momentum) = step::<X, T, P, G>(grid(), scatter);
            assert!((mass - 40.0).abs() < 40.0 * tolerance, "{mass}");
            for axis in 0..X::RANK {
                let expected = if axis == 0 {
                    -5.0
                } else if axis == X::RANK - 1 {
                    10.0
                } else {
                    0.0
                };
                assert!((momentum[axis].to_f64() - expected).abs() < 10.0 * tolerance, "{momentum:?}");
            }
        }
    }
    run::<Ij, f32, Aos, _>(|| Field::<Node<Ij, f32>, Aos>::new([8, 8]), 1e-5);
    run::<Ij, f32, Parted<Ij, f32>, _>(
        || Field::<Node<Ij, f32>, layout!(Node<Ij, f32>: dense(ij).place([m], [v]))>::new([8, 8]),
        1e-5,
    );
    run::<Ijk, f64, Parted<Ijk, f64>, _>(
        || Field::<Node<Ijk, f64>, layout!(Node<Ijk, f64>: dense(ijk).soa)>::new([8, 8, 9]),
        1e-13,
    );
    run::<Ij, f64, Split, _>(|| Field::<Node<Ij, f64>, Morton<4>>::new([8, 9]), 1e-13);
    run::<Ijk, f64, AoSoA<4>, _>(|| Field::<Node<Ijk, f64>, Soa>::new([8, 9, 8]), 1e-13);
}

#[test]
fn points_beyond_the_grid_are_errors() {
    let mut points = points::<Ij, f32, Aos>(1);
    points.set(0, Point { x: vec2(6.9, 2.0), ..points.get(0) });
    let mut grid = Field::<Node<Ij, f32>, Aos>::new([8, 8]);
    let result = std::panic::catch_unwind(core::panic::AssertUnwindSafe(|| {
        particle_to_grid(&points, &mut grid, 1.0, 1.0);
    }));
    let text = *result.expect_err("a panic").downcast::<String>().expect("a text");
    assert!(text.contains("particle_to_grid") && text.contains("[8, 1]"), "{text}");
}

#[test]
fn functions_of_vectors_and_matrices() {
    fn run<X: Spatial, T: Real>() {
        let real = T::from_f64;
        let mut v = X::Vec::<T>::splat(real(2.0));
        v[0] = real(-1.5);
        let product = X::Mat::<T>::outer(v, v);
        assert_eq!(product.trace(), v.length_squared());
        assert_eq!(product * v, v * v.dot(v));
        assert_eq!((product.row(1), product.col(0)), (v * real(2.0), v * real(-1.5)));
        let twice = X::Mat::<T>::from_diagonal(X::Vec::<T>::splat(real(2.0)));
        assert_eq!(twice.inverse() * v, v * real(0.5));
        assert_eq!(twice.determinant(), real(2.0).powi(X::RANK as i32));
        assert_eq!(X::Mat::<T>::identity() - X::Mat::<T>::identity().transpose(), X::Mat::<T>::zero());
        assert_eq!((v.floor().to_index()[0], v.to_index()[0], v.to_index()[1]), (-2, -1, 2));
        let index = X::Index::splat(3) * 2 - 1;
        assert_eq!(X::Vec::<T>::from_index(index), index.to_vec::<T>());
        assert_eq!((v.min_element(), v.abs().max_element(), v.is_finite()), (real(-1.5), real(2.0), true));
    }
    run::<Ij, f32>();
    run::<Ij, f64>();
    run::<Ijk, f32>();
    run::<Ijk, f64>();
}

#[test]
fn functions_from_axes() {
    fn run<X: Spatial, T: Real>(sum: i32, product: i32)
    where
        Soa: Layout<X>,
    {
        let index = X::Index::from_fn(|axis| axis as i32 + 2);
        let v = X::Vec::<T>::from_fn(|axis| T::from_i32(index[axis]));
        assert_eq!(v, index.to_vec::<T>());
        assert_eq!((v.element_sum(), v.element_product()), (T::from_i32(sum), T::from_i32(product)));
        let matrix = X::Mat::<T>::from_fn(|row, column| T::from_i32(10 * row as i32 + column as i32));
        assert_eq!(matrix.row(1)[0], T::from_i32(10));
        assert_eq!(matrix.col(1)[0], T::ONE);
        assert_eq!(matrix.trace(), T::from_i32(11 * (X::RANK * (X::RANK - 1) / 2) as i32));
        let field = Field::<T, Soa>::new(X::shape(|axis| 4 + axis));
        assert_eq!(field.shape().as_ref(), &[4, 5, 6][..X::RANK]);
    }
    run::<Ij, f32>(5, 6);
    run::<Ij, f64>(5, 6);
    run::<Ijk, f32>(9, 24);
    run::<Ijk, f64>(9, 24);
}

/// Adds to each cell around a place how many offsets it took to come there: the order of `unroll!`.
#[kernel]
fn order<X: Spatial>(places: &Field<X::Index, _>, seen: &mut Field<i32, _, X>) {
    for p in places {
        let base = places[p];
        let mut count = 0;
        for offset in unroll!(X, -1..2) {
            count += 1;
            if (base + offset).min(X::Index::default()) == X::Index::default() {
                seen[base + offset] += count;
            }
        }
    }
}

#[test]
fn offsets_run_in_the_order_of_the_axes() {
    fn run<X: Spatial>(place: i32) -> Vec<i32>
    where
        Soa: Layout<X>,
    {
        let mut places = Field::<X::Index, Aos>::new([1]);
        places.set(0, X::Index::splat(place));
        let mut seen = Field::<i32, Soa>::new(X::shape(|_axis| 3));
        order::<X>(&places, &mut seen);
        seen.to_vec().into_iter().filter(|&count| count > 0).collect()
    }
    assert!(run::<Ij>(1).into_iter().eq(1..=9));
    assert!(run::<Ijk>(1).into_iter().eq(1..=27));
    // In a corner, where not all offsets lie within, they are taken in loops.
    assert_eq!(run::<Ij>(0), [5, 6, 8, 9]);
    assert_eq!(run::<Ijk>(0), [14, 15, 17, 18, 23, 24, 26, 27]);
}
