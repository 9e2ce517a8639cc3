//! What stands in the way of particles: the walls of the domain, and colliders in it.

use super::keys::Keys;
use super::region::{self, CORNERS, MESH};
use super::{Folder, SceneError};
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

const SURFACE: &[&str] = &["contact", "friction", "velocity"];

pub(crate) const WALLS: &[&str] =
    &["contact", "friction", "velocity", "left", "right", "floor", "ceiling", "back", "front"];

/// What each shape of a collider takes beside `shape` and what its surface does.
const SHAPES: &[(&str, &[&str])] =
    &[("ball", &["center", "radius"]), ("box", CORNERS), ("half-space", &["point", "normal"]), ("mesh", MESH)];

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Separate,
    Slip,
    Sticky,
}

impl Wall {
    /// What a table says of a surface; what it does not say is as in `base`.
    fn read(keys: &Keys<'_>, dimensions: usize, base: Self) -> Result<Self, SceneError> {
        let kinds = [("separate", Kind::Separate), ("slip", Kind::Slip), ("sticky", Kind::Sticky)];
        let (known, friction) = match base.contact {
            Contact::Separate { friction } => (Kind::Separate, friction),
            Contact::Slip => (Kind::Slip, 0.0),
            Contact::Sticky => (Kind::Sticky, 0.0),
        };
        let contact = match keys.choice("contact", "contact", &kinds)?.unwrap_or(known) {
            Kind::Separate => {
                let friction = keys.number("friction")?.unwrap_or(friction);
                if !(0.0..=1e30).contains(&friction) {
                    return Err(keys.fault("friction", "must be zero, which is none, or above"));
                }
                Contact::Separate { friction }
            }
            kind => {
                if keys.has("friction") {
                    let (name, _) = kinds.iter().find(|(_, other)| *other == kind).unwrap_or(&kinds[0]);
                    let message = format!("belongs to `contact = \"separate\"`, and the contact is `{name}`");
                    return Err(keys.fault("friction", message));
                }
                if kind == Kind::Slip { Contact::Slip } else { Contact::Sticky }
            }
        };
        Ok(Self { contact, velocity: keys.vector("velocity", dimensions)?.unwrap_or(base.velocity) })
    }
}

/// Reads a table `[walls]`, in which the tables of single sides overrule what is said of all.
pub(crate) fn read_walls(keys: &Keys<'_>, dimensions: usize) -> Result<Walls, SceneError> {
    let all = Wall::read(keys, dimensions, Wall::default())?;
    let mut walls = [[all; 2]; 3];
    for (axis, names) in SIDES.iter().enumerate() {
        for (side, name) in names.iter().enumerate() {
            let table = keys.table(name, SURFACE)?;
            if axis >= dimensions {
                if table.is_some() {
                    return Err(keys.fault(name, "is a wall of `dimensions = 3`; in the plane there is none"));
                }
                continue;
            }
            let wall = &mut walls[axis][side];
            if let Some(table) = &table {
                *wall = Wall::read(table, dimensions, all)?;
            }
            if wall.velocity[axis] != 0.0 {
                let message = format!(
                    "would move the wall `{name}` out of its plane; its component along axis {axis} must be zero"
                );
                let own = table.as_ref().filter(|table| table.has("velocity"));
                let cure = if own.is_some() { "" } else { ", or the wall's own table must tell another velocity" };
                return Err(own.unwrap_or(keys).fault("velocity", message + cure));
            }
        }
    }
    Ok(walls)
}

impl Collider {
    /// Reads a table of `[[collider]]`, the keys of which are not checked yet.
    pub(crate) fn read(keys: &Keys<'_>, dimensions: usize, folder: &Folder) -> Result<Self, SceneError> {
        let name = region::shape_of(keys, "collider", SHAPES, SURFACE)?;
        let shape = match name {
            "ball" => {
                let (center, radius) = region::ball(keys, dimensions)?;
                ColliderShape::Ball { center, radius }
            }
            "box" => {
                let (from, to) = region::corners(keys, dimensions)?;
                ColliderShape::Box { from, to }
            }
            "half-space" => ColliderShape::HalfSpace {
                point: keys.required_vector("point", dimensions, "[0.0, 0.1]")?,
                normal: read_normal(keys, dimensions)?,
            },
            _ => ColliderShape::Mesh(region::mesh(keys, dimensions, folder)?),
        };
        let Wall { contact, velocity } = Wall::read(keys, dimensions, Wall::default())?;
        Ok(Self { shape, contact, velocity })
    }
}

/// A direction, made to have the length one.
fn read_normal(keys: &Keys<'_>, dimensions: usize) -> Result<[f64; 3], SceneError> {
    let normal = keys.required_vector("normal", dimensions, "[0.0, 1.0]")?;
    // By the largest component first, so that squares neither vanish nor overflow.
    let largest = normal.iter().fold(0.0, |largest: f64, component| largest.max(component.abs()));
    if largest == 0.0 {
        return Err(keys.fault("normal", "has no length, and so no direction; write, for example, `normal = [0, 1]`"));
    }
    let normal = normal.map(|component| component / largest);
    let length = normal.iter().map(|component| component * component).sum::<f64>().sqrt();
    Ok(normal.map(|component| component / length))
}
