//! How much memory a scene takes.

use super::WcsphSetup;
use crate::scene::{Scene, SceneError, gibibytes};

impl WcsphSetup {
    /// Bytes that a simulation with so many particles takes while it is built, at most about: the particle twice, as when it
    /// is sorted, with `3 d + 3` words, where it was, its list of neighbours, its number, and 124 bytes for the position, velocity and
    /// gradient with which it starts.
    pub fn estimated_bytes(&self, particles: usize) -> u64 {
        let (d, most) = (self.dimensions as u64, self.most as u64);
        particles as u64 * (4 * (2 * (3 * d + 3) + d + most + 2) + 124)
    }

    /// Refuses particles of the scene, which has this setup, that do not fit into `available` bytes.
    ///
    /// # Errors
    /// Tells the sizes in GiB.
    pub fn check_memory(&self, scene: &Scene, particles: usize, available: u64) -> Result<(), SceneError> {
        let bytes = self.estimated_bytes(particles);
        if bytes <= available {
            return Ok(());
        }
        let (takes, there) = (gibibytes(bytes as f64), gibibytes(available as f64));
        let message = format!("makes about {particles} particles, which take {takes}, and {there} are available");
        Err(scene.fault(format!("spacing = {}", self.spacing), message).of_memory())
    }
}
