//! What stands in the way of nodes: walls and colliders, as they stand at a time.

use allotrope::prelude::*;

use super::MpmSetup;
use crate::mesh::SignedDistance;
use crate::scene::{Collider, ColliderShape, Contact, Wall};

/// A scene's walls and colliders at a time.
#[derive(Clone, Debug)]
pub struct Obstacles {
    dx: f32,
    /// Nodes below this belong to the lower walls ..
    wall: i32,
    /// .. and above this, on each axis, to the upper ones.
    inner: [i32; 3],
    dimensions: usize,
    sides: [[Surface; 2]; 3],
    bodies: Vec<Body>,
}

/// What a surface does, in single precision.
#[derive(Clone, Copy, Debug)]
struct Surface {
    contact: Contact,
    velocity: Vec3,
}

#[derive(Clone, Debug)]
struct Body {
    shape: Shape,
    surface: Surface,
    /// By how much it has moved.
    moved: Vec3,
}

#[derive(Clone, Debug)]
enum Shape {
    Ball { center: Vec3, radius: f32 },
    Box { center: Vec3, half: Vec3 },
    HalfSpace { point: Vec3, normal: Vec3 },
    Mesh(SignedDistance),
}

fn single(v: [f64; 3]) -> Vec3 {
    Vec3::from_array(v.map(|component| component as f32))
}

impl Obstacles {
    /// The walls and colliders of a scene at its start.
    pub fn new(setup: &MpmSetup) -> Self {
        let surface = |wall: Wall| Surface { contact: wall.contact, velocity: single(wall.velocity) };
        Self {
            dx: setup.dx() as f32,
            wall: setup.wall as i32,
            inner: setup.grid.map(|nodes| nodes as i32 - setup.wall as i32),
            dimensions: setup.dimensions,
            sides: setup.walls.map(|sides| sides.map(surface)),
            bodies: setup.colliders.iter().map(|collider| Body::new(collider, setup)).collect(),
        }
    }

    /// Moves the colliders to where they are at a time in s.
    pub fn move_to(&mut self, time: f64) {
        for body in &mut self.bodies {
            body.moved = body.surface.velocity * time as f32;
        }
    }

    /// The velocity of a node that would have the velocity `v`, were there no obstacles.
    pub fn meet(&self, node: IVec3, v: Vec3) -> Vec3 {
        let mut v = v;
        for axis in 0..self.dimensions {
            let normal = Vec3::AXES[axis];
            if node[axis] < self.wall {
                v = self.sides[axis][0].meet(normal, v);
            } else if node[axis] > self.inner[axis] {
                v = self.sides[axis][1].meet(-normal, v);
            }
        }
        for body in &self.bodies {
            if let Some(normal) = body.normal(node.as_vec3() * self.dx, self.dimensions) {
                v = body.surface.meet(normal, v);
            }
        }
        v
    }
}

impl Surface {
    /// The velocity of a node of this surface; `normal` points out of it (SIGGRAPH course on MPM 2016, section 12.1).
    fn meet(&self, normal: Vec3, v: Vec3) -> Vec3 {
        let relative = v - self.velocity;
        let into = relative.dot(normal);
        match self.contact {
            Contact::Sticky => self.velocity,
            Contact::Slip => v - into * normal,
            Contact::Separate { .. } if into >= 0.0 => v,
            Contact::Separate { friction } => {
                let along = relative - into * normal;
                let (speed, slowed) = (along.length(), friction as f32 * -into);
                if speed <= slowed { self.velocity } else { self.velocity + along - along / speed * slowed }
            }
        }
    }
}

impl Body {
    fn new(collider: &Collider, setup: &MpmSetup) -> Self {
        let shape = match &collider.shape {
            ColliderShape::Ball { center, radius } => Shape::Ball { center: single(*center), radius: *radius as f32 },
            ColliderShape::Box { from, to } => {
                let (from, to) = (single(*from), single(*to));
                Shape::Box { center: 0.5 * (from + to), half: 0.5 * (to - from) }
            }
            ColliderShape::HalfSpace { point, normal } => {
                Shape::HalfSpace { point: single(*point), normal: single(*normal) }
            }
            ColliderShape::Mesh(mesh) => Shape::Mesh(SignedDistance::new(mesh, 0.5 * setup.dx())),
        };
        let surface = Surface { contact: collider.contact, velocity: single(collider.velocity) };
        Self { shape, surface, moved: Vec3::ZERO }
    }

    /// The direction out of the body at a place in it; none outside.
    fn normal(&self, place: Vec3, dimensions: usize) -> Option<Vec3> {
        let place = place - self.moved;
        match &self.shape {
            Shape::Ball { center, radius } => {
                let arm = place - *center;
                (arm.length_squared() < radius * radius).then(|| arm.normalize_or(Vec3::Y))
            }
            Shape::Box { center, half } => {
                let arm = place - *center;
                let depth = *half - arm.abs();
                let nearest = (0..dimensions).min_by(|&a, &b| depth[a].total_cmp(&depth[b]))?;
                (depth[nearest] > 0.0).then(|| Vec3::AXES[nearest] * arm[nearest].signum())
            }
            Shape::HalfSpace { point, normal } => ((place - *point).dot(*normal) < 0.0).then_some(*normal),
            Shape::Mesh(distance) => {
                let (distance, normal) = distance.at(place.to_array().map(f64::from))?;
                (distance < 0.0).then(|| single(normal))
            }
        }
    }
}
