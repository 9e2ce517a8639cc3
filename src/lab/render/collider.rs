//! Colliders: where they stand at a time, how far off they are, and where a ray meets them.

use std::sync::LazyLock;

use allotrope_solvers::mesh::ClosedMesh;
use allotrope_solvers::scene::{Collider, ColliderShape};

use super::colour::Colour;
use super::solid::{Vec3, dot, minus, plus, unit};

/// A collider where it stands at the time of a picture.
#[derive(Clone, Copy, Debug)]
pub(super) enum Placed<'a> {
    Ball { center: Vec3, radius: f64 },
    Box { from: Vec3, to: Vec3 },
    HalfSpace { point: Vec3, normal: Vec3 },
    Mesh { mesh: &'a ClosedMesh, moved: Vec3 },
}

/// All colliders at a time.
pub(super) fn at(colliders: &[Collider], time: f64) -> Vec<Placed<'_>> {
    let place = |collider: &'_ Collider| -> Vec3 { collider.velocity.map(|velocity| velocity * time) };
    let placed = colliders.iter().map(|collider| {
        let moved = place(collider);
        match &collider.shape {
            ColliderShape::Ball { center, radius } => {
                Placed::Ball { center: plus(*center, moved, 1.0), radius: *radius }
            }
            ColliderShape::Box { from, to } => Placed::Box { from: plus(*from, moved, 1.0), to: plus(*to, moved, 1.0) },
            ColliderShape::HalfSpace { point, normal } => {
                Placed::HalfSpace { point: plus(*point, moved, 1.0), normal: *normal }
            }
            ColliderShape::Mesh(mesh) => Placed::Mesh { mesh, moved },
        }
    });
    placed.collect()
}

/// Where a ray first meets a shape from outside: how many of its lengths from its origin, and the normal there.
pub(super) type Hit = Option<(f64, Vec3)>;

impl Placed<'_> {
    /// Metres in a plane from a point to the surface, below zero inside. A mesh is in no plane.
    pub(super) fn distance(&self, x: Vec3) -> f64 {
        match *self {
            Placed::Ball { center, radius } => (x[0] - center[0]).hypot(x[1] - center[1]) - radius,
            Placed::Box { from, to } => {
                let beyond: [f64; 2] = std::array::from_fn(|axis| (from[axis] - x[axis]).max(x[axis] - to[axis]));
                let outside = beyond[0].max(0.0).hypot(beyond[1].max(0.0));
                outside + beyond[0].max(beyond[1]).min(0.0)
            }
            Placed::HalfSpace { point, normal } => dot(minus(x, point), normal),
            Placed::Mesh { .. } => f64::INFINITY,
        }
    }

    /// Where a ray meets the surface, if it does; meshes are drawn by their triangles instead. Who stands inside of a
    /// collider, or behind the plane of a half-space, does not see it, since it would hide everything.
    pub(super) fn hit(&self, origin: Vec3, ray: Vec3) -> Hit {
        match *self {
            Placed::Ball { center, radius } => {
                let arm = minus(origin, center);
                let (a, b, c) = (dot(ray, ray), dot(arm, ray), dot(arm, arm) - radius * radius);
                let root = b * b - a * c;
                let t = (-b - root.max(0.0).sqrt()) / a;
                (root > 0.0 && t > 0.0).then(|| (t, unit(plus(arm, ray, t))))
            }
            Placed::Box { from, to } => {
                let (mut enter, mut leave, mut side) = (f64::NEG_INFINITY, f64::INFINITY, 0);
                for axis in 0..3 {
                    let ends = [from[axis], to[axis]].map(|end| (end - origin[axis]) / ray[axis]);
                    // A ray along the sides divides by zero: it is between them for ever, or never.
                    let (near, far) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
                    if near > enter {
                        (enter, side) = (near, axis);
                    }
                    leave = leave.min(far);
                }
                let normal = std::array::from_fn(|axis| if axis == side { -ray[axis].signum() } else { 0.0 });
                (enter > 0.0 && enter < leave).then_some((enter, normal))
            }
            Placed::HalfSpace { point, normal } => {
                let (toward, height) = (dot(ray, normal), dot(minus(origin, point), normal));
                (toward < 0.0 && height > 0.0).then(|| (-height / toward, normal))
            }
            Placed::Mesh { .. } => None,
        }
    }
}

/// Of colliders in a plane, and of their rims.
static GREYS: LazyLock<[Colour; 2]> = LazyLock::new(|| [0x59616e, 0xa3adbc].map(Colour::hex));

/// The grey of colliders in a plane, and how much of a pixel they cover, so many pixels from the surface: with a
/// lighter rim.
pub(super) fn flat(distance: f64) -> (Colour, f32) {
    let share = |pixels: f64| pixels.clamp(0.0, 1.0) as f32;
    (GREYS[0].mix(GREYS[1], share(distance + 3.0)), share(0.5 - distance))
}

#[cfg(test)]
mod tests {
    use allotrope_solvers::scene::Contact;

    use super::*;

    fn collider(shape: ColliderShape) -> Collider {
        Collider { shape, contact: Contact::Slip, velocity: [1.0, 0.0, -2.0] }
    }

    #[test]
    fn distances_are_below_zero_inside() {
        let ball = Placed::Ball { center: [1.0, 2.0, 0.0], radius: 0.5 };
        assert_eq!([[1.0, 2.0, 0.0], [1.5, 2.0, 0.0], [1.0, 4.0, 0.0]].map(|x| ball.distance(x)), [-0.5, 0.0, 1.5]);
        let cuboid = Placed::Box { from: [0.0; 3], to: [4.0, 2.0, 0.0] };
        let places = [[1.0, 1.0, 0.0], [0.25, 1.0, 0.0], [5.0, 1.0, 0.0], [7.0, 6.0, 0.0]];
        assert_eq!(places.map(|x| cuboid.distance(x)), [-1.0, -0.25, 1.0, 5.0]);
        let ramp = Placed::HalfSpace { point: [0.0, 1.0, 0.0], normal: [0.6, 0.8, 0.0] };
        assert!((ramp.distance([1.0, 1.0, 0.0]) - 0.6).abs() < 1e-12 && ramp.distance([0.0; 3]) < 0.0);
    }

    #[test]
    fn colliders_move_on_with_time() {
        let colliders = [
            collider(ColliderShape::Ball { center: [0.0; 3], radius: 1.0 }),
            collider(ColliderShape::Box { from: [0.0; 3], to: [1.0; 3] }),
            collider(ColliderShape::HalfSpace { point: [0.0; 3], normal: [0.0, 0.0, 1.0] }),
        ];
        let hits = |time| {
            at(&colliders, time).iter().map(|shape| shape.hit([2.1, 0.5, 10.0], [0.0, 0.0, -1.0])).collect::<Vec<_>>()
        };
        assert_eq!(hits(0.0), [None, None, Some((10.0, [0.0, 0.0, 1.0]))]);
        let after = hits(2.0);
        assert_eq!(after[1..], [Some((13.0, [0.0, 0.0, 1.0])), Some((14.0, [0.0, 0.0, 1.0]))]);
        let (depth, normal) = after[0].unwrap();
        let height = (1.0f64 - 0.01 - 0.25).sqrt();
        assert!((depth - (14.0 - height)).abs() < 1e-12 && (normal[2] - height).abs() < 1e-12, "{depth} {normal:?}");
    }

    #[test]
    fn from_inside_or_behind_nothing_is_met() {
        let shapes = [
            Placed::Ball { center: [0.0; 3], radius: 1.0 },
            Placed::Box { from: [-1.0; 3], to: [1.0; 3] },
            Placed::HalfSpace { point: [0.0, 0.5, 0.0], normal: [0.0, 1.0, 0.0] },
        ];
        for shape in shapes {
            assert_eq!(shape.hit([0.0; 3], [0.1, 1.0, 0.2]), None, "{shape:?}");
            assert_eq!(shape.hit([0.0, 9.0, 0.0], [0.0, 1.0, 0.0]), None, "{shape:?}");
            assert!(shape.hit([0.0, 9.0, 0.0], [0.0, -1.0, 0.0]).is_some(), "{shape:?}");
        }
    }

    #[test]
    fn flat_colliders_have_a_light_rim() {
        let (inside, covered) = flat(-20.0);
        let (rim, _) = flat(-1.0);
        assert!(covered == 1.0 && rim.0[0] > 2.0 * inside.0[0]);
        assert_eq!((flat(0.0).1, flat(1.0).1), (0.5, 0.0));
    }
}
