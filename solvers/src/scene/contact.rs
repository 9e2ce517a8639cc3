//! What stands in the way of particles: the walls of the domain, and colliders in it.

use crate::mesh::ClosedMesh;

/// What a surface does to a velocity that meets it, relative to its own (SIGGRAPH course on MPM 2016, section 12.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Nothing moves along it or away from it.
    Sticky,
    /// Nothing moves through it or away from it.
    Slip,
    /// Nothing moves into it; what moves along it is slowed by Coulomb friction.
    Separate {
        /// The coefficient; zero: no friction.
        friction: f64,
    },
}

/// A side of the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// What it does.
    pub contact: Contact,
    /// Its velocity in m/s.
    pub velocity: [f64; 3],
}

impl Default for Wall {
    fn default() -> Self {
        Self { contact: Contact::Separate { friction: 0.0 }, velocity: [0.0; 3] }
    }
}

/// The sides of the domain by axis: below, above. In 2D the third axis' do nothing.
pub type Walls = [[Wall; 2]; 3];

/// The names of the sides, as [`Walls`] orders them.
pub const SIDES: [[&str; 2]; 3] = [["left", "right"], ["floor", "ceiling"], ["back", "front"]];

/// A body that particles cannot enter.
#[derive(Clone, Debug)]
pub struct Collider {
    /// What it fills at the start.
    pub shape: ColliderShape,
    /// What its surface does.
    pub contact: Contact,
    /// In m/s; it moves on by this.
    pub velocity: [f64; 3],
}

/// What a collider fills.
#[derive(Clone, Debug)]
pub enum ColliderShape {
    /// A disk or ball.
    Ball {
        /// Its centre.
        center: [f64; 3],
        /// Its radius.
        radius: f64,
    },
    /// A box.
    Box {
        /// The lower corner.
        from: [f64; 3],
        /// The upper corner.
        to: [f64; 3],
    },
    /// All that lies behind a plane.
    HalfSpace {
        /// A point of the plane.
        point: [f64; 3],
        /// Away from what is filled; of length one.
        normal: [f64; 3],
    },
    /// The inside of a closed mesh (3D).
    Mesh(ClosedMesh),
}
