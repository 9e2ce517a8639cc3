//! The fluid's kernels in both precisions, in the plane and in space.

use allotrope::prelude::*;
use allotrope::spatial::*;
use allotrope_solvers::Scene;
use allotrope_solvers::mpm::MpmSetup;
use allotrope_solvers::mpm::fluid::{Mpm, Node, Point, kernels};
use allotrope_solvers::scene::Folder;

const TEXT: &str = r#"
version = 1
solver = "mpm"
dimensions = 2
grid = 24
length = 1.0
dt = 2e-4
material = { stiffness = 100.0, density = 1.0 }
body = [{ shape = "ball", center = [0.5, 0.4], radius = 0.2 }]
"#;

fn scene<X: Spatial>() -> Scene {
    let text = match X::RANK {
        2 => TEXT.to_owned(),
        _ => TEXT.replace("dimensions = 2", "dimensions = 3").replace("[0.5, 0.4]", "[0.5, 0.4, 0.6]"),
    };
    Scene::parse(&text, "test", Folder::BuiltIn).unwrap()
}

/// Where points lie after 100 steps in which they fall and turn, and by how much of it the grid's mass is wrong.
fn run<X: Spatial, T: Real>() -> (Vec<f64>, f64)
where
    Aos: Layout<X>,
{
    let scene = scene::<X>();
    let setup = scene.setup::<MpmSetup>().unwrap();
    let (mpm, start) = (Mpm::<X, T>::new(&scene, setup), scene.particles().unwrap().x);
    let mut points = Field::<Point<X, T>, Soa>::new([start.len()]);
    for (p, x) in start.iter().enumerate() {
        let x = X::Vec::<T>::from_fn(|axis| T::from_f64(x[axis]));
        let mut v = X::Vec::<T>::zero();
        (v[0], v[1]) = (T::from(0.5) - x[1], x[0] - T::from(0.5));
        points.set(p, Point { x, v, c: X::Mat::<T>::zero(), j: T::ONE });
    }
    let mut grid = Field::<Node<X, T>, Aos>::new(X::shape(|axis| setup.grid[axis]));
    for _ in 0..100 {
        kernels::clear(&mut grid);
        kernels::particle_to_grid(&points, &mut grid, &mpm);
        assert_eq!(kernels::update_grid(&mut grid, &mpm), 0);
        kernels::grid_to_particle(&mut points, &grid, &mpm);
    }
    assert_eq!(kernels::count_broken(&points, &mpm), 0);
    let mass: f64 = grid.iter().map(|node| node.m.to_f64()).sum();
    let expected = start.len() as f64 * mpm.mass.to_f64();
    let places = points.iter().flat_map(|point| (0..X::RANK).map(move |axis| point.x[axis].to_f64()));
    (places.collect(), (mass / expected - 1.0).abs())
}

fn both_precisions_agree<X: Spatial>()
where
    Aos: Layout<X>,
{
    let ((single, error), (double, small_error)) = (run::<X, f32>(), run::<X, f64>());
    assert!(error < 1e-5 && small_error < 1e-13, "{error}, {small_error}");
    let difference = single.iter().zip(&double).map(|(single, double)| (single - double).abs()).fold(0.0, f64::max);
    assert!(difference > 0.0 && difference < 1e-5, "{difference}");
}

#[test]
fn single_and_double_precision_agree_in_the_plane() {
    both_precisions_agree::<Ij>();
}

#[test]
fn single_and_double_precision_agree_in_space() {
    both_precisions_agree::<Ijk>();
}
