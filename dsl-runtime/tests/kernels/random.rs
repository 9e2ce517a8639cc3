//! Random numbers in kernels.

use allotrope::prelude::*;

#[kernel]
fn throw(points: &mut Field<Vec3, _>, seed: u64, step: u32) -> u32 {
    let mut low = 0;
    for p in points {
        points[p] = random(seed, (p, step));
        low += random::<bool>(seed, (p, step, 1)) as u32;
    }
    low
}

#[kernel]
fn noise(u: &mut Field<f32, _, Ij>, seed: u64) {
    for ij in u {
        u[ij] = random(seed, ij);
    }
}

#[test]
fn numbers_depend_on_neither_threads_nor_layouts() {
    fn run<L: Layout<I>>(threads: usize) -> (Vec<Vec3>, u32) {
        let mut points = Field::<Vec3, L>::new([10_000]);
        let low = Schedule { threads, grain: 64, ..Schedule::default() }.run(|| throw(&mut points, 5, 3));
        (points.iter().collect(), low)
    }
    let (points, low) = run::<Aos>(1);
    assert_eq!((points.clone(), low), run::<Aos>(3));
    assert_eq!((points.clone(), low), run::<AoSoA<8>>(2));
    assert_eq!((points.clone(), low), run::<Split>(1));
    assert_eq!(points[77], random(5, (77, 3)));
    assert!((4700..5300).contains(&low), "{low} of 10000");
    let other = |seed, step| {
        let mut points = Field::<Vec3, Aos>::new([10_000]);
        throw(&mut points, seed, step);
        points.iter().zip(run::<Aos>(1).0).filter(|(a, b)| a == b).count()
    };
    assert_eq!((other(5, 4), other(6, 3), other(5, 3)), (0, 0, 10_000));
}

#[test]
fn indices_are_keys() {
    let mut u = Field::<f32, Morton<4>>::new([9, 5]);
    noise(&mut u, 11);
    for i in 0..9 {
        for j in 0..5 {
            assert_eq!(u.get((i, j)), random::<f32>(11, ivec2(i, j)));
        }
    }
}
