//! The particles that walls are made of.

use super::WcsphSetup;
use crate::scene::{ColliderShape, MOST_PARTICLES};

/// Places along an axis, and whether each is so deep in a wall that its layers count it.
type Along = Vec<(f64, bool)>;

impl WcsphSetup {
    /// The places of the particles of all walls.
    ///
    /// # Errors
    /// Where they are too many.
    pub(in crate::sph::wcsph) fn wall_places(&self) -> Result<Vec<[f64; 3]>, String> {
        let mut places = product(&std::array::from_fn(|axis| self.sides(axis)))?;
        for collider in &self.colliders {
            if let ColliderShape::Box { from, to } = &collider.shape {
                places.extend(product(&std::array::from_fn(|axis| self.shell(axis, from[axis], to[axis])))?);
            }
        }
        Ok(places)
    }

    /// Along an axis of the domain: the layers beyond its ends where there are walls, and the places between them.
    fn sides(&self, axis: usize) -> Along {
        if axis >= self.dimensions {
            return vec![(0.0, false)];
        }
        let (side, dx) = (self.extent[axis], self.spacing);
        let depth = |layer: usize| (layer as f64 + 0.5) * dx;
        let mut along = Along::new();
        if self.closed[axis][0] {
            along.extend((0..self.layers).rev().map(|layer| (-depth(layer), true)));
        }
        along.extend(middles(0.0, side, dx).map(|x| (x, false)));
        if self.closed[axis][1] {
            along.extend((0..self.layers).map(|layer| (side + depth(layer), true)));
        }
        along
    }

    /// Along an axis of a box: the layers within its ends, and the places between them.
    fn shell(&self, axis: usize, from: f64, to: f64) -> Along {
        if axis >= self.dimensions {
            return vec![(0.0, false)];
        }
        let count = middles(from, to, self.spacing).count();
        let deep = |n: usize| n < self.layers || n + self.layers >= count;
        middles(from, to, self.spacing).enumerate().map(|(n, x)| (x, deep(n))).collect()
    }
}

/// The middles of the parts of a range that is cut into whole parts of about the spacing.
fn middles(from: f64, to: f64, spacing: f64) -> impl Iterator<Item = f64> {
    let count = ((to - from) / spacing).round().max(1.0);
    (0..count as usize).map(move |n| from + (to - from) * (n as f64 + 0.5) / count)
}

/// All places that belong to a wall along one axis at least.
fn product([i, j, k]: &[Along; 3]) -> Result<Vec<[f64; 3]>, String> {
    let count = |along: &Along| along.len() as f64;
    let free = |along: &Along| along.iter().filter(|(_, wall)| !wall).count() as f64;
    let walls = count(i) * count(j) * count(k) - free(i) * free(j) * free(k);
    if walls > MOST_PARTICLES as f64 {
        return Err(format!("would hold {walls:.0} particles, and more than {MOST_PARTICLES} are refused"));
    }
    let mut places = Vec::with_capacity(walls as usize);
    for &(x, a) in i {
        for &(y, b) in j {
            places.extend(k.iter().filter(|(_, c)| a || b || *c).map(|&(z, _)| [x, y, z]));
        }
    }
    Ok(places)
}
