//! Bodies of fluid: their shapes, and the particles that fill them.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::keys::Keys;
use super::region::{self, MESH};
use super::{Folder, Particles, SceneError};
use crate::mesh::ClosedMesh;
use crate::nearest::hint;

/// A body of fluid.
#[derive(Clone, Debug)]
pub struct Body {
    /// What it fills.
    pub shape: Shape,
    /// Of which of the scene's materials.
    pub material: usize,
    /// Velocity in metres a second.
    pub velocity: [f64; 3],
    /// Rotation about its centre in rad/s; in 2D about the third axis.
    pub spin: [f64; 3],
    /// Stretching along each axis about its centre, in 1/s; negative where it is compressed.
    pub stretch: [f64; 3],
}

/// What a body fills.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A box.
    Box {
        /// The lower corner.
        from: [f64; 3],
        /// The upper corner.
        to: [f64; 3],
        /// How particles are placed in it.
        fill: Fill,
    },
    /// A disk or ball, filled by a lattice.
    Ball {
        /// Its centre.
        center: [f64; 3],
        /// Its radius.
        radius: f64,
        /// Whether by the lattice of [`Fill::Aligned`].
        aligned: bool,
    },
    /// The inside of a closed mesh, filled by a lattice.
    Mesh(ClosedMesh),
    /// Given positions.
    Points(Vec<[f64; 3]>),
}

/// How particles are placed in a box.
#[derive(Clone, Debug)]
pub enum Fill {
    /// Uniformly at random.
    Random {
        /// How many.
        particles: usize,
        /// Of the generator.
        seed: u64,
    },
    /// On those points of a lattice that are a whole number and a half of spacings from the origin, and so lie in every
    /// cell of the grid in the same way.
    Aligned,
    /// On a lattice of the scene's spacing, each moved at random by up to half of `jitter` spacings along each axis.
    Lattice {
        /// From zero to one.
        jitter: f64,
        /// Of the generator.
        seed: u64,
    },
}

/// What every body takes beside its shape.
const COMMON: &[&str] = &["velocity", "spin", "stretch", "material"];

/// What each shape takes beside that.
const SHAPES: &[(&str, &[&str])] = &[
    ("box", &["from", "to", "aligned", "particles", "seed", "jitter"]),
    ("ball", &["center", "radius", "aligned"]),
    ("mesh", MESH),
    ("points", &["file"]),
];

impl Body {
    /// Reads a table of `[[body]]`, the keys of which are not checked yet. `materials` are the names of those that it may
    /// be of, `seed` is for one that has none of its own.
    pub(crate) fn read(
        keys: &Keys<'_>,
        dimensions: usize,
        materials: &[&str],
        seed: u64,
        folder: &Folder,
    ) -> Result<Self, SceneError> {
        let shape = match region::shape_of(keys, "body", SHAPES, COMMON)? {
            "box" => {
                let (from, to) = region::corners(keys, dimensions)?;
                Shape::Box { from, to, fill: read_fill(keys, seed)? }
            }
            "ball" => {
                let (center, radius) = region::ball(keys, dimensions)?;
                Shape::Ball { center, radius, aligned: keys.flag("aligned")?.unwrap_or(false) }
            }
            "mesh" => Shape::Mesh(region::mesh(keys, dimensions, folder)?),
            _ => Shape::Points(read_points(keys, dimensions, folder)?),
        };
        Ok(Self {
            shape,
            material: material_index(keys, materials)?,
            velocity: keys.vector("velocity", dimensions)?.unwrap_or_default(),
            spin: read_spin(keys, dimensions)?,
            stretch: keys.vector("stretch", dimensions)?.unwrap_or_default(),
        })
    }

    /// Gives the positions of this body their velocities, and appends them.
    pub(crate) fn set_off(&self, positions: Vec<[f64; 3]>, particles: &mut Particles) {
        let ([a, b, c], [i, j, k]) = (self.spin, self.stretch);
        let gradient = [[i, -c, b], [c, j, -a], [-b, a, k]];
        let n = positions.len() as f64;
        let center: [f64; 3] = std::array::from_fn(|axis| positions.iter().map(|x| x[axis]).sum::<f64>() / n);
        for x in positions {
            let arm: [f64; 3] = std::array::from_fn(|axis| x[axis] - center[axis]);
            let turn = |row: [f64; 3]| row[0] * arm[0] + row[1] * arm[1] + row[2] * arm[2];
            particles.x.push(x);
            particles.v.push(std::array::from_fn(|axis| self.velocity[axis] + turn(gradient[axis])));
            particles.c.push(gradient);
            particles.material.push(self.material as u32);
        }
    }
}

impl Shape {
    /// Volume in m^3 (in 2D, m^2); of given points, zero.
    pub(crate) fn volume(&self, dimensions: usize) -> f64 {
        match self {
            Self::Box { from, to, .. } => (0..dimensions).map(|axis| to[axis] - from[axis]).product(),
            Self::Ball { radius, .. } if dimensions == 2 => std::f64::consts::PI * radius.powi(2),
            Self::Ball { radius, .. } => 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3),
            Self::Mesh(mesh) => mesh.volume(),
            Self::Points(_) => 0.0,
        }
    }

    /// About how many particles fill the shape at this spacing.
    pub(crate) fn estimate(&self, spacing: f64, dimensions: usize) -> f64 {
        match self {
            Self::Box { fill: Fill::Random { particles, .. }, .. } => *particles as f64,
            Self::Points(positions) => positions.len() as f64,
            other => other.volume(dimensions) / spacing.powi(dimensions as i32),
        }
    }

    /// The positions that fill the shape at this spacing; if they are more than `room`, the fault.
    pub(crate) fn fill(&self, spacing: f64, dimensions: usize, room: usize) -> Result<Vec<[f64; 3]>, String> {
        let estimate = self.estimate(spacing, dimensions);
        if estimate > room as f64 {
            return Err(format!(
                "would hold {estimate:.0} particles, and more than {} are refused",
                super::MOST_PARTICLES
            ));
        }
        Ok(match self {
            Self::Box { from, to, fill: Fill::Random { particles, seed } } => {
                let mut random = ChaCha8Rng::seed_from_u64(*seed);
                let mut within = |axis: usize| {
                    if axis < dimensions { from[axis] + (to[axis] - from[axis]) * unit(&mut random) } else { 0.0 }
                };
                (0..*particles).map(|_| std::array::from_fn(&mut within)).collect()
            }
            Self::Box { from, to, fill: Fill::Lattice { jitter, seed } } => {
                let mut random = ChaCha8Rng::seed_from_u64(*seed);
                let mut positions = lattice(*from, *to, spacing, dimensions);
                for component in positions.iter_mut().flat_map(|x| &mut x[..dimensions]) {
                    *component += jitter * spacing * (unit(&mut random) - 0.5);
                }
                positions
            }
            Self::Box { from, to, fill: Fill::Aligned } => aligned(*from, *to, spacing, dimensions),
            Self::Ball { center, radius, aligned: on_grid } => {
                let inside = |x: &[f64; 3]| {
                    (0..dimensions).map(|axis| (x[axis] - center[axis]).powi(2)).sum::<f64>() <= radius * radius
                };
                let positions = if *on_grid {
                    let reach = radius + spacing;
                    aligned(center.map(|c| c - reach), center.map(|c| c + reach), spacing, dimensions)
                } else {
                    // A lattice of the very spacing, that is symmetrical about the centre.
                    let reach = 0.5 * spacing * (2.0 * radius / spacing).ceil();
                    lattice(center.map(|c| c - reach), center.map(|c| c + reach), spacing, dimensions)
                };
                positions.into_iter().filter(inside).collect()
            }
            Self::Mesh(mesh) => mesh.fill(spacing),
            Self::Points(positions) => positions.clone(),
        })
    }
}

/// Uniform in [0, 1), with the 24 bits that single precision holds.
fn unit(random: &mut ChaCha8Rng) -> f64 {
    f64::from(random.next_u32() >> 8) * 2f64.powi(-24)
}

/// The middles of the cells of a box that is cut into whole cells of about the given spacing; the last axis runs
/// fastest.
fn lattice(from: [f64; 3], to: [f64; 3], spacing: f64, dimensions: usize) -> Vec<[f64; 3]> {
    let side = |axis: usize| if axis < dimensions { to[axis] - from[axis] } else { 0.0 };
    let count: [usize; 3] = std::array::from_fn(|axis| ((side(axis) / spacing).round() as usize).max(1));
    let at = |axis: usize, n: usize| {
        if axis < dimensions { from[axis] + side(axis) * (n as f64 + 0.5) / count[axis] as f64 } else { 0.0 }
    };
    let mut positions = Vec::with_capacity(count.iter().product());
    for i in 0..count[0] {
        for j in 0..count[1] {
            positions.extend((0..count[2]).map(|k| [at(0, i), at(1, j), at(2, k)]));
        }
    }
    positions
}

/// The points of the lattice of odd multiples of half the spacing that lie in a box, its lower sides included; the last
/// axis runs fastest.
fn aligned(from: [f64; 3], to: [f64; 3], spacing: f64, dimensions: usize) -> Vec<[f64; 3]> {
    let coordinates: [Vec<f64>; 3] = std::array::from_fn(|axis| {
        if axis >= dimensions {
            return vec![0.0];
        }
        let (first, last) = ((from[axis] / spacing - 1.5).floor() as i64, (to[axis] / spacing + 0.5).ceil() as i64);
        let within = |x: &f64| from[axis] <= *x && *x < to[axis];
        (first..=last).map(|n| (n as f64 + 0.5) * spacing).filter(within).collect()
    });
    let [i, j, k] = &coordinates;
    let columns = i.iter().flat_map(|&x| j.iter().map(move |&y| (x, y)));
    columns.flat_map(|(x, y)| k.iter().map(move |&z| [x, y, z])).collect()
}

/// Which of the materials a body asks for; the first, if it asks for none.
fn material_index(body: &Keys<'_>, materials: &[&str]) -> Result<usize, SceneError> {
    let Some(name) = body.text("material")? else { return Ok(0) };
    materials.iter().position(|material| *material == name).ok_or_else(|| {
        body.fault("material", format!("is not the name of a material{}", hint(name, materials.iter().copied())))
    })
}

fn read_fill(keys: &Keys<'_>, seed: u64) -> Result<Fill, SceneError> {
    let seed = keys.whole("seed", 0, i64::MAX)?.map_or(seed, |seed| seed as u64);
    let aligned = keys.flag("aligned")?.unwrap_or(false);
    for (key, does) in [("particles", "asks for random particles"), ("jitter", "moves particles")] {
        if aligned && keys.has(key) {
            return Err(
                keys.fault(key, format!("{does}, and `aligned` puts them on the grid's lattice; leave one out"))
            );
        }
    }
    if aligned {
        return Ok(Fill::Aligned);
    }
    match keys.whole("particles", 1, super::MOST_PARTICLES as i64)? {
        Some(_) if keys.has("jitter") => {
            Err(keys
                .fault("jitter", "moves particles of a lattice, and `particles` asks for random ones; leave one out"))
        }
        Some(particles) => Ok(Fill::Random { particles: particles as usize, seed }),
        None => Ok(Fill::Lattice { jitter: keys.between("jitter", 0.0, 1.0)?.unwrap_or(0.0), seed }),
    }
}

fn read_points(keys: &Keys<'_>, dimensions: usize, folder: &Folder) -> Result<Vec<[f64; 3]>, SceneError> {
    let bytes = keys.file("file", "\"points.txt\"", |name| folder.read(name))?;
    let text = String::from_utf8(bytes).map_err(|_| keys.fault("file", "is not a text in UTF-8"))?;
    let mut positions = Vec::new();
    for (n, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        let words: Vec<&str> = line.split([',', ' ', '\t', '\r']).filter(|word| !word.is_empty()).collect();
        if words.is_empty() {
            continue;
        }
        let numbers: Vec<f64> =
            words.iter().filter_map(|word| word.parse().ok()).filter(|x: &f64| x.is_finite()).collect();
        if numbers.len() != dimensions || words.len() != dimensions {
            return Err(keys.fault(
                "file",
                format!("has on line {} `{}`, where {dimensions} finite numbers are wanted", n + 1, line.trim()),
            ));
        }
        let mut position = [0.0; 3];
        position[..dimensions].copy_from_slice(&numbers);
        positions.push(position);
    }
    Ok(positions)
}

fn read_spin(keys: &Keys<'_>, dimensions: usize) -> Result<[f64; 3], SceneError> {
    if dimensions == 2 {
        Ok([0.0, 0.0, keys.number("spin")?.unwrap_or(0.0)])
    } else {
        Ok(keys.vector("spin", 3)?.unwrap_or_default())
    }
}
