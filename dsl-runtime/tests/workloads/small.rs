//! Small ones: a histogram, a time step from the fastest point, an advance in plane and space, an emitter by random numbers.

use allotrope::prelude::*;
use allotrope::spatial::*;

use crate::{close, on_threads, scattered};

#[kernel]
fn histogram(keys: &Field<u8, _>, bins: &mut Field<u32, _>) {
    for i in keys {
        bins[keys[i]] += 1;
    }
}

#[test]
fn counts_are_exact() {
    fn run<K: Layout<I>, B: Layout<I>>() {
        on_threads(|| {
            let mut keys = Field::<u8, K>::new([1000]);
            (0..1000).for_each(|n| keys.set(n, (n * n % 251) as u8));
            let mut bins = Field::<u32, B>::new([256]);
            histogram(&keys, &mut bins);
            assert!((0..256).all(|bin| bins.get(bin) == (0..1000).filter(|n| n * n % 251 == bin).count() as u32));
        });
    }
    run::<Aos, Aos>();
    run::<AoSoA<16>, Soa>();
    run::<Blocked<8>, Blocked<8>>();
}

#[derive(Record, Clone, Copy, Default)]
struct Body<X: Spatial, T: Real> {
    x: X::Vec<T>,
    v: X::Vec<T>,
}

#[kernel]
fn time_step(points: &Field<Body<Ij, f32>, _>, cfl: f32, dx: f32) -> f32 {
    let mut fastest = 1e-6f32;
    for p in points {
        fastest.max_assign(points.v[p].length());
    }
    cfl * dx / fastest
}

#[kernel]
fn advance<X: Spatial, T: Real>(points: &mut Field<Body<X, T>, _>, dt: T) {
    for p in points {
        points.x[p] += points.v[p] * dt;
    }
}

#[kernel]
fn emit<X: Spatial, T: Real>(points: &mut Field<Body<X, T>, _>, first: i32, count: i32, step: u64) {
    for s in first..first + count {
        points.x[s] = random(step, (s, 0));
        points.v[s] = random::<X::Vec<T>>(step, (s, 1)) * T::from(2.0) - T::ONE;
    }
}

#[test]
fn bodies_are_emitted_and_move() {
    fn run<X: Spatial, T: Real, L: Layout<I>>() {
        on_threads(|| {
            let mut bodies = Field::<Body<X, T>, L>::new([60]);
            emit(&mut bodies, 0, 40, 7);
            emit(&mut bodies, 40, 20, 8);
            let start: Vec<Body<X, T>> = bodies.iter().collect();
            assert!(start.iter().all(|body| body.x.min_element() >= T::ZERO && body.x.max_element() < T::ONE));
            assert!(start.iter().any(|body| body.v.min_element() < T::ZERO));
            advance(&mut bodies, T::from(0.5));
            for (body, start) in bodies.iter().zip(&start) {
                assert_eq!(body.x, start.x + start.v * T::from(0.5));
            }
        });
    }
    run::<Ij, f32, Aos>();
    run::<Ijk, f32, Soa>();
    run::<Ijk, f64, AoSoA<4>>();
}

#[test]
fn the_fastest_sets_the_time_step() {
    on_threads(|| {
        let mut bodies = Field::<Body<Ij, f32>, AoSoA<8>>::new([100]);
        let speeds: Vec<Vec2> = (0..100).map(|n| vec2(scattered(n), scattered(n + 100))).collect();
        bodies.members_mut().v.copy_from_slice(&speeds);
        let fastest = speeds.iter().map(|v| v.length()).fold(0.0, f32::max);
        close(&[time_step(&bodies, 0.4, 0.1)], &[0.4 * 0.1 / fastest], 1e-6);
    });
}
