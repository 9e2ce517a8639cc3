//! The longest step that an explicit integrator bears.

use super::parameters::{Integrator, Parameters};
use super::records::{Mass, Spring};

/// The longest stable step in s of an explicit integrator; infinite, if nothing oscillates, and none for implicit ones,
/// which are stable with any.
///
/// For the highest angular frequency `w` and the highest damping rate `c` of the system, symplectic Euler is stable for
/// `w^2 dt^2 + 2 c dt < 4`: for `dt < 2 / w` without dashpots. `w^2` is at most the largest sum, over the two masses of
/// a spring, of the stiffness of all their springs over their mass (Fried 1972, "Bounds on the extremal eigenvalues of
/// the finite element stiffness and mass matrices"; fixed masses count nothing), likewise `c`. The bound is met by one
/// mass on a wall, `2 sqrt(m / k)`, by two free masses, `sqrt(2 m / k)`, and by a long chain, `sqrt(m / k)`; where
/// springs of many directions meet, the true one can be up to twice as long.
///
/// Forward Euler asks of each oscillation that `w^2 dt < c`: of each spring that `dt` is below its dashpot over its
/// stiffness; without dashpots, no step is stable.
pub fn largest_step(masses: &[Mass], springs: &[Spring], parameters: &Parameters) -> Option<f64> {
    if !parameters.integrator.is_explicit() {
        return None;
    }
    let mut sums = vec![(0.0, 0.0); masses.len()];
    for spring in springs {
        for end in spring.ends {
            let (stiffness, dashpot) = &mut sums[end as usize];
            *stiffness += spring.bond.stiffness;
            *dashpot += spring.bond.dashpot;
        }
    }
    let rate = |end: u32, sum: f64| if masses[end as usize].fixed { 0.0 } else { sum / masses[end as usize].mass };
    let (mut square, mut damping) = (0.0f64, 0.0f64);
    for [a, b] in springs.iter().map(|spring| spring.ends) {
        let ((stiff_a, damp_a), (stiff_b, damp_b)) = (sums[a as usize], sums[b as usize]);
        square = square.max(rate(a, stiff_a) + rate(b, stiff_b));
        damping = damping.max(rate(a, damp_a) + rate(b, damp_b));
    }
    let pull = parameters.attractor.strength.max(0.0);
    square += pull;
    if square == 0.0 {
        return Some(f64::INFINITY);
    }
    // The positive root of `square dt^2 + 2 damping dt = 4`, without cancellation.
    let symplectic = 4.0 / (damping + (damping * damping + 4.0 * square).sqrt());
    if parameters.integrator == Integrator::SymplecticEuler {
        return Some(symplectic);
    }
    let moves = |spring: &&Spring| spring.ends.iter().any(|&end| !masses[end as usize].fixed);
    let least = springs.iter().filter(moves).map(|spring| spring.bond.dashpot / spring.bond.stiffness);
    let damped = if pull > 0.0 { 0.0 } else { least.fold(f64::INFINITY, f64::min) };
    Some(damped.min(symplectic))
}
