//! The same scene in other sizes.

use toml::{Table, Value};

use super::memory::{gibibytes, node_bytes};
use super::{Body, Fill, LONGEST, MOST_PARTICLES, Scene, SceneError, Scheme, Shape};

/// A grid of more nodes is refused.
const MOST_NODES: u64 = 1 << 28;

/// Refuses a grid of too many nodes, and tells its size.
pub(super) fn check_nodes(grid: [usize; 3], dimensions: usize, scheme: Scheme) -> Result<(), String> {
    // At most 2^45.
    let nodes: u64 = grid.iter().map(|&nodes| nodes as u64).product();
    if nodes <= MOST_NODES {
        return Ok(());
    }
    let size = gibibytes((nodes * node_bytes(dimensions, scheme)) as f64);
    Err(format!(
        "has {nodes} nodes, which take {size}, and more than {MOST_NODES} (2^28) are refused without `sparse = true`"
    ))
}

impl Scene {
    /// Changes the text in the way in which the scene was changed.
    fn rewrite(&mut self, change: impl FnOnce(&mut Table)) {
        if let Ok(mut table) = self.text.parse::<Table>() {
            change(&mut table);
            self.text = table.to_string();
        }
    }

    /// The same scene on `nodes` nodes along the first axis, and in proportion along the others. The time step is
    /// changed in proportion to the cell, so that the Courant number stays.
    ///
    /// # Errors
    /// If an axis becomes too short for its walls, or the grid too large.
    pub fn with_grid(mut self, nodes: usize) -> Result<Self, SceneError> {
        let (old, least) = (self.grid[0], 2 * self.wall + 4);
        for extent in &mut self.grid[..self.dimensions] {
            *extent = (*extent as f64 * nodes as f64 / old as f64).round() as usize;
        }
        let key = format!("grid = {nodes}");
        if self.grid[..self.dimensions].iter().any(|&extent| !(least..=LONGEST as usize).contains(&extent)) {
            return Err(self.fault(key, format!("cannot be; an axis takes from {least} to {LONGEST} nodes")));
        }
        if !self.sparse
            && let Err(fault) = check_nodes(self.grid, self.dimensions, self.transfer.scheme)
        {
            return Err(self.fault(key, fault));
        }
        self.dt *= old as f64 / nodes as f64;
        let extents: Vec<_> = self.grid[..self.dimensions].iter().map(|&extent| Value::from(extent as i64)).collect();
        let dt = self.dt;
        self.rewrite(|table| {
            table.insert("grid".into(), extents.into());
            table.insert("dt".into(), dt.into());
        });
        Ok(self)
    }

    /// The same scene with `count` particles: exactly so many where they are drawn at random, about so many where they
    /// lie on a lattice, whose spacing is changed.
    ///
    /// # Errors
    /// If the spacing would leave its bounds, or positions are given one by one.
    pub fn with_particles(mut self, count: usize) -> Result<Self, SceneError> {
        let key = format!("particles = {count}");
        if count == 0 || count > MOST_PARTICLES {
            return Err(self.fault(key, format!("is not from 1 to {MOST_PARTICLES}")));
        }
        let random = |body: &Body| match &body.shape {
            Shape::Box { fill: Fill::Random { particles, .. }, .. } => Some(*particles),
            _ => None,
        };
        let drawn: Vec<usize> = self.bodies.iter().filter_map(random).collect();
        if self.bodies.iter().any(|body| matches!(body.shape, Shape::Points(_))) {
            return Err(self.fault(key, "cannot be, since the scene gives its particles one by one"));
        }
        if drawn.len() == self.bodies.len() {
            let total: usize = drawn.iter().sum();
            let mut left = count;
            for (n, body) in self.bodies.iter_mut().enumerate() {
                if let Shape::Box { fill: Fill::Random { particles, .. }, .. } = &mut body.shape {
                    let share = (*particles as f64 / total as f64 * count as f64).round() as usize;
                    *particles = if n + 1 == drawn.len() { left } else { share.min(left) };
                    left -= *particles;
                }
            }
            let counts: Vec<_> = self.bodies.iter().filter_map(random).collect();
            self.rewrite(|table| {
                let bodies = table.get_mut("body").and_then(Value::as_array_mut).into_iter().flatten();
                for (body, count) in bodies.filter_map(Value::as_table_mut).zip(counts) {
                    body.insert("particles".into(), (count as i64).into());
                }
            });
        } else if drawn.is_empty() {
            let volume: f64 = self.bodies.iter().map(|body| body.shape.volume(self.dimensions)).sum();
            self.spacing = (volume / count as f64).powf(1.0 / self.dimensions as f64) / self.dx();
            if !(0.05..=1.0).contains(&self.spacing) {
                let message = format!(
                    "needs a spacing of {:.3} cells, which is not from 0.05 to 1; change the grid too",
                    self.spacing
                );
                return Err(self.fault(key, message));
            }
            let spacing = self.spacing;
            self.rewrite(|table| _ = table.insert("spacing".into(), spacing.into()));
        } else {
            return Err(self.fault(key, "cannot be, since the scene has both random and regular bodies"));
        }
        Ok(self)
    }
}
