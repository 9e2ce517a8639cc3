//! How much memory a scene takes.

use super::{MpmSetup, Scheme, Transfer};
use crate::mpm::materials::Model;
use crate::scene::{Scene, SceneError, Wall, gibibytes};

impl MpmSetup {
    /// Bytes that a simulation with so many particles takes while it is built, about.
    ///
    /// A particle of `d` dimensions holds, in words of 4 bytes, its position (`d`), mass, material, deformation gradient
    /// and stress (`d^2` each) and two numbers of plasticity, and by the scheme its velocity (`d`), with APIC the
    /// velocity's gradient too (`d^2`), or with PolyPIC the coefficients of all modes (`d 3^d`); a fluid alone, with the
    /// default transfer and walls, only `2 d + d^2 + 1`. To this come 4 bytes for its number and 124 for the position,
    /// velocity and gradient with which it starts. A node holds momentum and mass, `d + 1` words, and with PIC and
    /// FLIP the momentum before, `d` more. Of a sparse grid there are about as many nodes as particles, and four times as many where
    /// blocks are cut at a surface.
    pub fn estimated_bytes(&self, particles: usize) -> u64 {
        particles as u64 * (4 * self.particle_words() + 4 + 124) + self.grid_bytes(particles)
    }

    fn particle_words(&self) -> u64 {
        let d = self.dimensions as u64;
        let fluid = matches!(self.materials[..], [ref only] if matches!(only.model, Model::Fluid { .. }));
        let plain = self.walls.iter().flatten().all(|wall| *wall == Wall::default()) && self.colliders.is_empty();
        if fluid && plain && self.transfer == Transfer::default() {
            return 2 * d + d * d + 1;
        }
        let velocity = match self.transfer.scheme {
            Scheme::Pic | Scheme::Flip { .. } => d,
            Scheme::Apic => d + d * d,
            Scheme::PolyPic { .. } => d * 3u64.pow(d as u32),
        };
        d + velocity + 2 * d * d + 4
    }

    fn grid_bytes(&self, particles: usize) -> u64 {
        let all = self.grid.iter().map(|&nodes| nodes as u64).product::<u64>();
        let nodes = if self.sparse { all.min(4 * particles as u64) } else { all };
        nodes * node_bytes(self.dimensions, self.transfer.scheme)
    }

    /// Refuses a grid or particles of the scene, which has this setup, that do not fit into `available` bytes.
    ///
    /// # Errors
    /// Tells the sizes in GiB.
    pub fn check_memory(&self, scene: &Scene, particles: usize, available: u64) -> Result<(), SceneError> {
        let [i, j, k] = self.grid;
        let size = if self.dimensions == 2 { format!("{i} x {j}") } else { format!("{i} x {j} x {k}") };
        let (grid, all) = (self.grid_bytes(particles), self.estimated_bytes(particles));
        if grid > available {
            let message = format!(
                "takes {} for its {} nodes, and {} are available; take a coarser grid",
                gibibytes(grid as f64),
                i * j * k,
                gibibytes(available as f64)
            );
            return Err(scene.fault(format!("grid = {size}"), message).of_memory());
        }
        if all > available {
            let message = format!(
                "makes {particles} particles, which take {} beside the grid's {}, and {} are available; make the bodies \
                 smaller or `spacing` larger",
                gibibytes((all - grid) as f64),
                gibibytes(grid as f64),
                gibibytes(available as f64)
            );
            return Err(scene.fault("body", message).of_memory());
        }
        Ok(())
    }
}

/// Bytes of a node.
pub(super) fn node_bytes(dimensions: usize, scheme: Scheme) -> u64 {
    let d = dimensions as u64;
    4 * if matches!(scheme, Scheme::Pic | Scheme::Flip { .. }) { 2 * d + 1 } else { d + 1 }
}
