//! Particles as PLY, the Stanford polygon format (binary, little endian), which mesh viewers and point cloud programs
//! read.

use allotrope_solvers::Simulation;

/// Bytes a particle: seven floats, and the number of its material.
const STRIDE: usize = 8 * 4;

/// The particles in the order in which they were given: `x y z` in metres (in 2D `z` is zero), `vx vy vz` in m/s,
/// `pressure` in Pa, `material`.
pub fn particles(simulation: &dyn Simulation) -> Vec<u8> {
    let count = simulation.particles();
    let floats: String =
        ["x", "y", "z", "vx", "vy", "vz", "pressure"].map(|name| format!("property float {name}\n")).concat();
    let header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment step {}, time {} s\nelement vertex {count}\n{floats}\
         property uint material\nend_header\n",
        simulation.steps(),
        simulation.time()
    );
    let mut bytes = Vec::with_capacity(header.len() + STRIDE * count);
    bytes.extend_from_slice(header.as_bytes());
    let motion = simulation.positions().into_iter().zip(simulation.velocities());
    let rest = simulation.pressures().into_iter().zip(simulation.material_of());
    for ((x, v), (pressure, material)) in motion.zip(rest) {
        for value in x.into_iter().chain(v).chain([pressure]) {
            bytes.extend_from_slice(&(value as f32).to_le_bytes());
        }
        bytes.extend_from_slice(&material.to_le_bytes());
    }
    bytes
}
