//! A step of symplectic Euler of masses and springs in two interleaved lists.

use super::versions;

/// A mass, as its record lies in memory.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Mass {
    /// Position.
    pub x: [f64; 3],
    /// Velocity.
    pub v: [f64; 3],
    /// Force.
    pub f: [f64; 3],
    /// In kg.
    pub mass: f64,
    /// Whether it is held.
    pub fixed: bool,
}

/// A spring, as its record lies in memory.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Spring {
    /// Numbers of its masses.
    pub ends: [u32; 2],
    /// In N/m.
    pub stiffness: f64,
    /// Length at rest.
    pub rest: f64,
    /// In N s/m.
    pub dashpot: f64,
}

/// The constants of a step.
#[derive(Clone, Copy)]
pub struct Step {
    /// Seconds.
    pub dt: f64,
    /// m/s^2.
    pub gravity: [f64; 3],
    /// What drag leaves of a velocity.
    pub decay: f64,
    /// The corners of the box.
    pub walls: [[f64; 3]; 2],
}

/// The masses at the ends of a spring.
#[inline(always)]
fn ends(masses: &mut [Mass], ends: [u32; 2]) -> [*mut Mass; 2] {
    let first = masses.as_mut_ptr();
    assert!((ends[0] as usize) < masses.len() && (ends[1] as usize) < masses.len());
    // SAFETY: both are within the list.
    ends.map(|end| unsafe { first.add(end as usize) })
}

versions! {
    /// Adds the forces of springs, then moves the masses. Returns how many are not finite.
    pub fn step(springs: &[Spring], masses: &mut [Mass], step: &Step) -> u32 {
        for spring in springs {
            let [a, b] = ends(masses, spring.ends);
            // SAFETY: pointers into the list, of which no other reference is in use.
            let (one, other) = unsafe { (&*a, &*b) };
            let d: [f64; 3] = std::array::from_fn(|axis| one.x[axis] - other.x[axis]);
            let u: [f64; 3] = std::array::from_fn(|axis| one.v[axis] - other.v[axis]);
            let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            if length == 0.0 {
                continue;
            }
            let inverse = 1.0 / length;
            let n = d.map(|d| d * inverse);
            let rate = u[0] * n[0] + u[1] * n[1] + u[2] * n[2];
            let pull = -(spring.stiffness * (length - spring.rest) + spring.dashpot * rate);
            for (axis, n) in n.into_iter().enumerate() {
                // SAFETY: as above.
                unsafe {
                    (*a).f[axis] += n * pull;
                    (*b).f[axis] -= n * pull;
                }
            }
        }
        let mut broken = 0;
        for mass in masses {
            if !mass.fixed {
                let inverse = 1.0 / mass.mass;
                let mut sum = 0.0;
                for axis in 0..3 {
                    let acceleration = mass.f[axis] * inverse + step.gravity[axis];
                    let v = (mass.v[axis] + acceleration * step.dt) * step.decay;
                    let free = mass.x[axis] + v * step.dt;
                    let x = free.max(step.walls[0][axis]).min(step.walls[1][axis]);
                    mass.x[axis] = x;
                    mass.v[axis] = if x == free { v } else { 0.0 };
                    sum += mass.x[axis] + mass.v[axis];
                }
                broken += u32::from(!sum.is_finite());
            }
            mass.f = [0.0; 3];
        }
        broken
    }
}
