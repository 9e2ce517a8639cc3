//! What a continuum asks of records and kernels: one line for each way to carry velocity.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::medium::Body;
use super::{
    AffinePoint, ChangingNode, Dimensions, Node, PlainPoint, PolynomialPoint, Transfers, affine, plain, polynomial,
    quadratic,
};
use crate::mpm::convert::{matrices, saved_matrices, saved_vectors, vectors};
use crate::mpm::materials::Model;
use crate::mpm::obstacles::Obstacles;
use crate::{Array, State};

/// A way to carry velocity.
pub(in crate::mpm) trait Carrier<X: Dimensions>: Send + Sync + 'static {
    /// A particle.
    type Point: Record + Send + Sync;
    /// A grid node.
    type Node: Record + Send + Sync;

    /// A particle that begins.
    fn point(body: &Body<X>, mpm: &Transfers<X>) -> Self::Point;
    /// What every particle holds.
    fn body(point: &Self::Point, mpm: &Transfers<X>) -> Body<X>;
    /// Puts what every particle holds, but for velocity and its gradient.
    fn set_body(point: &mut Self::Point, body: &Body<X>);
    /// What this one's particles carry.
    fn carried(count: usize, point: &dyn Fn(usize) -> Self::Point) -> Vec<Array>;
    /// Puts it.
    fn set_carried<P: Layout<I>>(points: &mut Field<Self::Point, P>, state: &State) -> Result<(), String>;
    /// Velocity and mass.
    fn node(node: &Self::Node) -> (X::Vec<f32>, f32);

    // The kernels.
    fn clear<G: Layout<X>>(grid: &mut Field<Self::Node, G, X>);
    fn scatter<P: Layout<I>, G: Layout<X>>(
        points: &Field<Self::Point, P>,
        grid: &mut Field<Self::Node, G, X>,
        mpm: &Transfers<X>,
    );
    fn update_grid<G: Layout<X>>(grid: &mut Field<Self::Node, G, X>, mpm: &Transfers<X>, obstacles: &Obstacles) -> u32;
    fn gather<P: Layout<I>, G: Layout<X>>(
        points: &mut Field<Self::Point, P>,
        grid: &Field<Self::Node, G, X>,
        mpm: &Transfers<X>,
    );
    fn deform<P: Layout<I>>(points: &mut Field<Self::Point, P>, materials: &[Model]);
    fn count_broken<P: Layout<I>>(points: &Field<Self::Point, P>, mpm: &Transfers<X>) -> u32;
}

/// A velocity and its gradient; `ANY`: with any spline and forces, rather than quadratic splines and least squares alone.
pub(in crate::mpm) struct Affine<const ANY: bool>;

/// A velocity.
pub(in crate::mpm) struct Plain;

/// A polynomial field.
pub(in crate::mpm) struct Polynomial;

/// The functions of a carrier that are the same text for each.
macro_rules! same {
    ($point:ident, $kernels:ident, $grid:ident) => {
        fn set_body(point: &mut $point<X>, body: &Body<X>) {
            point.x = body.x;
            point.stress = body.stress;
            point.mass = body.mass;
            point.deformation_gradient = body.deformation_gradient;
            point.plastic = body.plastic;
            point.material = body.material;
        }

        fn node(node: &Self::Node) -> (X::Vec<f32>, f32) {
            (node.v, node.m)
        }

        fn clear<G: Layout<X>>(grid: &mut Field<Self::Node, G, X>) {
            $grid::clear(grid);
        }

        fn update_grid<G: Layout<X>>(
            grid: &mut Field<Self::Node, G, X>,
            mpm: &Transfers<X>,
            obstacles: &Obstacles,
        ) -> u32 {
            $grid::update_grid(grid, mpm, obstacles)
        }

        fn deform<P: Layout<I>>(points: &mut Field<$point<X>, P>, materials: &[Model]) {
            $kernels::deform(points, materials);
        }

        fn count_broken<P: Layout<I>>(points: &Field<$point<X>, P>, mpm: &Transfers<X>) -> u32 {
            $kernels::count_broken(points, mpm)
        }
    };
}

impl<X: Dimensions, const ANY: bool> Carrier<X> for Affine<ANY> {
    type Point = AffinePoint<X>;
    type Node = Node<X>;

    same!(AffinePoint, affine, affine);

    fn point(body: &Body<X>, _mpm: &Transfers<X>) -> AffinePoint<X> {
        let Body { x, v, c, stress, mass, deformation_gradient, plastic, material } = *body;
        AffinePoint { x, v, c, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &AffinePoint<X>, _mpm: &Transfers<X>) -> Body<X> {
        let AffinePoint { x, v, c, stress, mass, deformation_gradient, plastic, material } = *point;
        Body { x, v, c, stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(count: usize, point: &dyn Fn(usize) -> AffinePoint<X>) -> Vec<Array> {
        vec![
            vectors::<X>("velocity", (0..count).map(|p| point(p).v)),
            matrices::<X>("velocity_gradient", (0..count).map(|p| point(p).c)),
        ]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<AffinePoint<X>, P>, state: &State) -> Result<(), String> {
        let v = saved_vectors::<X>(state, "velocity", points.len())?;
        let c = saved_matrices::<X>(state, "velocity_gradient", points.len())?;
        for p in 0..points.len() {
            points.set(p, AffinePoint { v: v(p), c: c(p), ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<X>>(
        points: &Field<AffinePoint<X>, P>,
        grid: &mut Field<Node<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        // A condition on the type apart: what it leaves out is not compiled.
        if const { ANY } && !mpm.constants.is_usual() {
            affine::particle_to_grid(points, grid, mpm);
        } else {
            quadratic::particle_to_grid(points, grid, mpm);
        }
    }

    fn gather<P: Layout<I>, G: Layout<X>>(
        points: &mut Field<AffinePoint<X>, P>,
        grid: &Field<Node<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        if const { ANY } && !mpm.constants.is_usual() {
            affine::grid_to_particle(points, grid, mpm);
        } else {
            quadratic::grid_to_particle(points, grid, mpm);
        }
    }
}

impl<X: Dimensions> Carrier<X> for Plain {
    type Point = PlainPoint<X>;
    type Node = ChangingNode<X>;

    same!(PlainPoint, plain, plain);

    fn point(body: &Body<X>, _mpm: &Transfers<X>) -> PlainPoint<X> {
        let Body { x, v, stress, mass, deformation_gradient, plastic, material, .. } = *body;
        PlainPoint { x, v, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &PlainPoint<X>, _mpm: &Transfers<X>) -> Body<X> {
        let PlainPoint { x, v, stress, mass, deformation_gradient, plastic, material } = *point;
        Body { x, v, c: X::Mat::<f32>::zero(), stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(count: usize, point: &dyn Fn(usize) -> PlainPoint<X>) -> Vec<Array> {
        vec![vectors::<X>("velocity", (0..count).map(|p| point(p).v))]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<PlainPoint<X>, P>, state: &State) -> Result<(), String> {
        let v = saved_vectors::<X>(state, "velocity", points.len())?;
        for p in 0..points.len() {
            points.set(p, PlainPoint { v: v(p), ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<X>>(
        points: &Field<PlainPoint<X>, P>,
        grid: &mut Field<ChangingNode<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        plain::particle_to_grid(points, grid, mpm);
    }

    fn gather<P: Layout<I>, G: Layout<X>>(
        points: &mut Field<PlainPoint<X>, P>,
        grid: &Field<ChangingNode<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        plain::grid_to_particle(points, grid, mpm);
    }
}

impl<X: Dimensions> Carrier<X> for Polynomial {
    type Point = PolynomialPoint<X>;
    type Node = Node<X>;

    same!(PolynomialPoint, polynomial, affine);

    fn point(body: &Body<X>, mpm: &Transfers<X>) -> PolynomialPoint<X> {
        let Body { x, v, c, stress, mass, deformation_gradient, plastic, material } = *body;
        let mut modes = X::Modes::default();
        modes.as_mut()[0] = v;
        for axis in 0..X::RANK {
            if axis + 1 < mpm.constants.modes {
                modes.as_mut()[axis + 1] = c.col(axis) * mpm.constants.dx;
            }
        }
        PolynomialPoint { x, modes, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &PolynomialPoint<X>, mpm: &Transfers<X>) -> Body<X> {
        let PolynomialPoint { x, modes, stress, mass, deformation_gradient, plastic, material } = *point;
        let coefficients = modes.as_ref();
        let c = X::Mat::<f32>::from_fn(|row, column| coefficients[column + 1][row] * mpm.constants.inv_dx);
        Body { x, v: coefficients[0], c, stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(count: usize, point: &dyn Fn(usize) -> PolynomialPoint<X>) -> Vec<Array> {
        let components = |point: PolynomialPoint<X>| {
            let numbers = |n: usize| point.modes.as_ref()[n / X::RANK][n % X::RANK];
            (0..X::RANK * X::MODES.len()).map(numbers).collect::<Vec<_>>()
        };
        vec![Array::numbers("modes", X::RANK * X::MODES.len(), (0..count).map(point).flat_map(components))]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<PolynomialPoint<X>, P>, state: &State) -> Result<(), String> {
        let components = X::RANK * X::MODES.len();
        let values = state.numbers("modes", components, points.len())?;
        for (p, values) in values.chunks_exact(components).enumerate() {
            let mut modes = X::Modes::default();
            for (mode, values) in modes.as_mut().iter_mut().zip(values.chunks_exact(X::RANK)) {
                *mode = X::Vec::<f32>::from_fn(|axis| values[axis]);
            }
            points.set(p, PolynomialPoint { modes, ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<X>>(
        points: &Field<PolynomialPoint<X>, P>,
        grid: &mut Field<Node<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        polynomial::particle_to_grid(points, grid, mpm);
    }

    fn gather<P: Layout<I>, G: Layout<X>>(
        points: &mut Field<PolynomialPoint<X>, P>,
        grid: &Field<Node<X>, G, X>,
        mpm: &Transfers<X>,
    ) {
        polynomial::grid_to_particle(points, grid, mpm);
    }
}
