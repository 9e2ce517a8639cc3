//! Kernels on lattices, and their integrals.

use allotrope_solvers::sph::{Smoothing, Spline};

/// The points of a lattice of spacing 1 around the origin, which is left out, out to `reach`.
fn lattice(dimensions: usize, reach: i32) -> Vec<[f64; 3]> {
    let along = |axis: usize| if axis < dimensions { -reach..=reach } else { 0..=0 };
    let mut points = Vec::new();
    for i in along(0) {
        for j in along(1) {
            points.extend(along(2).map(|k| [i, j, k].map(f64::from)));
        }
    }
    points.retain(|point| point.iter().any(|&x| x != 0.0));
    points
}

fn squared(x: &[f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum()
}

/// Neighbours, the sum of V W, and the sum of |grad W|^2 dx^(2 d + 2), by an independent program.
#[rustfmt::skip]
const SUMS: [(usize, f64, usize, f64, f64); 12] = [
    (1, 1.2, 4, 1.001800, 0.379737), (1, 1.3, 4, 1.003466, 0.304610),
    (2, 1.0, 8, 1.000862, 0.520033), (2, 1.2, 20, 0.999757, 0.316446), (2, 1.3, 20, 0.999947, 0.235624),
    (2, 1.5, 24, 1.003440, 0.136018), (2, 2.0, 44, 0.999958, 0.042034),
    (3, 1.0, 26, 0.999972, 0.424840), (3, 1.2, 56, 1.000810, 0.207972), (3, 1.3, 80, 0.997262, 0.143146),
    (3, 1.5, 92, 1.001795, 0.072560), (3, 2.0, 250, 1.000079, 0.016915),
];

#[test]
fn sums_over_lattices() {
    for (dimensions, h, neighbours, sum, squares) in SUMS {
        let kernel = Smoothing::<f64>::new(Spline::Cubic, dimensions, h).unwrap();
        let single = Smoothing::<f32>::new(Spline::Cubic, dimensions, h).unwrap();
        let points = lattice(dimensions, 4);
        let near: Vec<_> = points.iter().filter(|x| squared(x) < kernel.support().powi(2)).collect();
        assert_eq!(near.len(), neighbours, "{dimensions}D, h = {h}");
        let total = kernel.weight(0.0) + points.iter().map(|x| kernel.weight(squared(x))).sum::<f64>();
        assert!((total - sum).abs() < 1e-5, "{dimensions}D, h = {h}: {total}, not {sum}");
        let total = points.iter().map(|x| kernel.slope(squared(x)).powi(2) * squared(x)).sum::<f64>();
        assert!((total - squares).abs() < 1e-5, "{dimensions}D, h = {h}: {total}, not {squares}");
        for axis in 0..dimensions {
            let gradient: f64 = points.iter().map(|x| kernel.slope(squared(x)) * x[axis]).sum();
            assert!(gradient.abs() < 1e-14, "{dimensions}D, h = {h}: {gradient}");
        }
        for x in points.iter().map(squared) {
            let (double, single) = (kernel.weight(x), f64::from(single.weight(x as f32)));
            assert!((double - single).abs() < 1e-6, "{dimensions}D, h = {h}, at {x}: {double}, {single}");
        }
    }
}

#[test]
fn integrals() {
    // What a Gaussian holds within three smoothing lengths.
    let held = [0.99997791, 0.99987659, 0.99956015];
    for (form, dimensions) in
        [Spline::Cubic, Spline::Gaussian].into_iter().flat_map(|form| (1..=3).map(move |d| (form, d)))
    {
        let kernel = Smoothing::<f64>::new(form, dimensions, 0.7).unwrap();
        let (count, width) = (20_000, kernel.support() / 20_000.0);
        let shell = |r: f64| match dimensions {
            1 => 2.0,
            2 => std::f64::consts::TAU * r,
            _ => 2.0 * std::f64::consts::TAU * r * r,
        };
        let integral: f64 =
            (0..count).map(|n| (f64::from(n) + 0.5) * width).map(|r| kernel.weight(r * r) * shell(r) * width).sum();
        let expected = if form == Spline::Cubic { 1.0 } else { held[dimensions - 1] };
        assert!((integral - expected).abs() < 1e-7, "{form:?}, {dimensions}D: {integral}");
    }
}

#[test]
fn slopes_are_those_of_the_weights() {
    for (form, dimensions) in
        [Spline::Cubic, Spline::Gaussian].into_iter().flat_map(|form| (1..=3).map(move |d| (form, d)))
    {
        let kernel = Smoothing::<f64>::new(form, dimensions, 0.3).unwrap();
        for r in (1..90).map(|n| 0.01 * f64::from(n)).filter(|r| (r - kernel.support()).abs() > 1e-3) {
            let step = 1e-6;
            let difference = (kernel.weight((r + step).powi(2)) - kernel.weight((r - step).powi(2))) / (2.0 * step);
            let slope = kernel.slope(r * r) * r;
            assert!(
                (slope - difference).abs() < 1e-6 * kernel.weight(0.0),
                "{form:?}, {dimensions}D, {r}: {slope}, {difference}"
            );
        }
        assert_eq!(kernel.slope(0.0) * 0.0, 0.0);
        assert_eq!(kernel.slope(kernel.support_squared()), 0.0);
    }
}
