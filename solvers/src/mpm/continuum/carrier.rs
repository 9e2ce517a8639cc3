//! What a continuum asks of records and kernels: one line for each way to carry velocity.

use allotrope::prelude::*;

use super::medium::Body;
use super::{
    AffinePoint, ChangingNode, MODES, Matrix, Modes, Node, Nodes, PlainPoint, PolynomialPoint, Transfers, Vector,
    affine, from_columns, plain, polynomial, quadratic,
};
use crate::mpm::materials::Model;
use crate::mpm::obstacles::Obstacles;
use crate::{Array, State};

/// A way to carry velocity.
pub(in crate::mpm) trait Carrier: Send + Sync + 'static {
    /// A particle.
    type Point: Record + Send + Sync;
    /// A grid node.
    type Node: Record + Send + Sync;

    /// A particle that begins.
    fn point(body: &Body, mpm: &Transfers) -> Self::Point;
    /// What every particle holds.
    fn body(point: &Self::Point, mpm: &Transfers) -> Body;
    /// Puts what every particle holds, but for velocity and its gradient.
    fn set_body(point: &mut Self::Point, body: &Body);
    /// What this one's particles carry.
    fn carried(points: &mut dyn Iterator<Item = Self::Point>) -> Vec<Array>;
    /// Puts it.
    fn set_carried<P: Layout<I>>(points: &mut Field<Self::Point, P>, state: &State) -> Result<(), String>;
    /// Velocity and mass.
    fn node(node: &Self::Node) -> (Vector, f32);

    // The kernels.
    fn clear<G: Layout<Nodes>>(grid: &mut Field<Self::Node, G, Nodes>);
    fn scatter<P: Layout<I>, G: Layout<Nodes>>(
        points: &Field<Self::Point, P>,
        grid: &mut Field<Self::Node, G, Nodes>,
        mpm: &Transfers,
    );
    fn update_grid<G: Layout<Nodes>>(
        grid: &mut Field<Self::Node, G, Nodes>,
        mpm: &Transfers,
        obstacles: &Obstacles,
    ) -> u32;
    fn gather<P: Layout<I>, G: Layout<Nodes>>(
        points: &mut Field<Self::Point, P>,
        grid: &Field<Self::Node, G, Nodes>,
        mpm: &Transfers,
    );
    fn deform<P: Layout<I>>(points: &mut Field<Self::Point, P>, materials: &[Model]);
    fn count_broken<P: Layout<I>>(points: &Field<Self::Point, P>, mpm: &Transfers) -> u32;
}

/// A velocity and its gradient.
pub(in crate::mpm) struct Affine;

/// A velocity.
pub(in crate::mpm) struct Plain;

/// A polynomial field.
pub(in crate::mpm) struct Polynomial;

/// The functions of a carrier that are the same text for each.
macro_rules! same {
    ($point:ident, $kernels:ident, $grid:ident) => {
        fn set_body(point: &mut $point, body: &Body) {
            point.x = body.x;
            point.stress = body.stress;
            point.mass = body.mass;
            point.deformation_gradient = body.deformation_gradient;
            point.plastic = body.plastic;
            point.material = body.material;
        }

        fn node(node: &Self::Node) -> (Vector, f32) {
            (node.v, node.m)
        }

        fn clear<G: Layout<Nodes>>(grid: &mut Field<Self::Node, G, Nodes>) {
            $grid::clear(grid);
        }

        fn update_grid<G: Layout<Nodes>>(
            grid: &mut Field<Self::Node, G, Nodes>,
            mpm: &Transfers,
            obstacles: &Obstacles,
        ) -> u32 {
            $grid::update_grid(grid, mpm, obstacles)
        }

        fn deform<P: Layout<I>>(points: &mut Field<$point, P>, materials: &[Model]) {
            $kernels::deform(points, materials);
        }

        fn count_broken<P: Layout<I>>(points: &Field<$point, P>, mpm: &Transfers) -> u32 {
            $kernels::count_broken(points, mpm)
        }
    };
}

impl Carrier for Affine {
    type Point = AffinePoint;
    type Node = Node;

    same!(AffinePoint, affine, affine);

    fn point(body: &Body, _mpm: &Transfers) -> AffinePoint {
        let Body { x, v, c, stress, mass, deformation_gradient, plastic, material } = *body;
        AffinePoint { x, v, c, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &AffinePoint, _mpm: &Transfers) -> Body {
        let AffinePoint { x, v, c, stress, mass, deformation_gradient, plastic, material } = *point;
        Body { x, v, c, stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(points: &mut dyn Iterator<Item = AffinePoint>) -> Vec<Array> {
        let (v, c): (Vec<_>, Vec<_>) = points.map(|point| (point.v.to_array(), point.c.to_cols_array())).unzip();
        vec![Array::floats("velocity", v), Array::floats("velocity_gradient", c)]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<AffinePoint, P>, state: &State) -> Result<(), String> {
        const SQUARE: usize = super::DIMENSIONS * super::DIMENSIONS;
        let v = state.floats("velocity", points.len())?;
        let c = state.floats::<SQUARE>("velocity_gradient", points.len())?;
        for (p, (v, c)) in v.iter().zip(c).enumerate() {
            let (v, c) = (Vector::from_array(*v), Matrix::from_cols_array(c));
            points.set(p, AffinePoint { v, c, ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<Nodes>>(
        points: &Field<AffinePoint, P>,
        grid: &mut Field<Node, G, Nodes>,
        mpm: &Transfers,
    ) {
        if mpm.constants.is_usual() {
            quadratic::particle_to_grid(points, grid, mpm);
        } else {
            affine::particle_to_grid(points, grid, mpm);
        }
    }

    fn gather<P: Layout<I>, G: Layout<Nodes>>(
        points: &mut Field<AffinePoint, P>,
        grid: &Field<Node, G, Nodes>,
        mpm: &Transfers,
    ) {
        if mpm.constants.is_usual() {
            quadratic::grid_to_particle(points, grid, mpm);
        } else {
            affine::grid_to_particle(points, grid, mpm);
        }
    }
}

impl Carrier for Plain {
    type Point = PlainPoint;
    type Node = ChangingNode;

    same!(PlainPoint, plain, plain);

    fn point(body: &Body, _mpm: &Transfers) -> PlainPoint {
        let Body { x, v, stress, mass, deformation_gradient, plastic, material, .. } = *body;
        PlainPoint { x, v, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &PlainPoint, _mpm: &Transfers) -> Body {
        let PlainPoint { x, v, stress, mass, deformation_gradient, plastic, material } = *point;
        Body { x, v, c: Matrix::ZERO, stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(points: &mut dyn Iterator<Item = PlainPoint>) -> Vec<Array> {
        vec![Array::floats("velocity", points.map(|point| point.v.to_array()))]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<PlainPoint, P>, state: &State) -> Result<(), String> {
        for (p, v) in state.floats("velocity", points.len())?.iter().enumerate() {
            points.set(p, PlainPoint { v: Vector::from_array(*v), ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<Nodes>>(
        points: &Field<PlainPoint, P>,
        grid: &mut Field<ChangingNode, G, Nodes>,
        mpm: &Transfers,
    ) {
        plain::particle_to_grid(points, grid, mpm);
    }

    fn gather<P: Layout<I>, G: Layout<Nodes>>(
        points: &mut Field<PlainPoint, P>,
        grid: &Field<ChangingNode, G, Nodes>,
        mpm: &Transfers,
    ) {
        plain::grid_to_particle(points, grid, mpm);
    }
}

impl Carrier for Polynomial {
    type Point = PolynomialPoint;
    type Node = Node;

    same!(PolynomialPoint, polynomial, affine);

    fn point(body: &Body, mpm: &Transfers) -> PolynomialPoint {
        let Body { x, v, c, stress, mass, deformation_gradient, plastic, material } = *body;
        let mut modes: Modes = [Vector::ZERO; MODES.len()];
        modes[0] = v;
        for axis in 0..super::DIMENSIONS {
            if axis + 1 < mpm.constants.modes {
                modes[axis + 1] = c.col(axis) * mpm.constants.dx;
            }
        }
        PolynomialPoint { x, modes, stress, mass, deformation_gradient, plastic, material }
    }

    fn body(point: &PolynomialPoint, mpm: &Transfers) -> Body {
        let PolynomialPoint { x, modes, stress, mass, deformation_gradient, plastic, material } = *point;
        let columns = std::array::from_fn(|axis| modes[axis + 1] * mpm.constants.inv_dx);
        let c = from_columns(columns);
        Body { x, v: modes[0], c, stress, mass, deformation_gradient, plastic, material }
    }

    fn carried(points: &mut dyn Iterator<Item = PolynomialPoint>) -> Vec<Array> {
        const COMPONENTS: usize = super::DIMENSIONS * MODES.len();
        let flat = |modes: Modes| {
            let mut values = [0.0; COMPONENTS];
            for (value, component) in values.iter_mut().zip(modes.iter().flat_map(|mode| mode.to_array())) {
                *value = component;
            }
            values
        };
        vec![Array::floats("modes", points.map(|point| flat(point.modes)))]
    }

    fn set_carried<P: Layout<I>>(points: &mut Field<PolynomialPoint, P>, state: &State) -> Result<(), String> {
        const COMPONENTS: usize = super::DIMENSIONS * MODES.len();
        for (p, values) in state.floats::<COMPONENTS>("modes", points.len())?.iter().enumerate() {
            let (values, _) = values.as_chunks::<{ super::DIMENSIONS }>();
            let modes = std::array::from_fn(|mode| Vector::from_array(values[mode]));
            points.set(p, PolynomialPoint { modes, ..points.get(p) });
        }
        Ok(())
    }

    fn scatter<P: Layout<I>, G: Layout<Nodes>>(
        points: &Field<PolynomialPoint, P>,
        grid: &mut Field<Node, G, Nodes>,
        mpm: &Transfers,
    ) {
        polynomial::particle_to_grid(points, grid, mpm);
    }

    fn gather<P: Layout<I>, G: Layout<Nodes>>(
        points: &mut Field<PolynomialPoint, P>,
        grid: &Field<Node, G, Nodes>,
        mpm: &Transfers,
    ) {
        polynomial::grid_to_particle(points, grid, mpm);
    }
}
