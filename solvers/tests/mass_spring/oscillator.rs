//! One undamped oscillator: the map of a step, and what a thousand of them do to its energy.

use super::*;

/// The matrix of a step on `(x, v / w)`, by columns.
fn step_map(z: f64, integrator: Integrator) -> [[f64; 2]; 2] {
    let dt = 0.01;
    let w = z / dt;
    [[1.0, 0.0], [0.0, 1.0]].map(|[x, v]| {
        let mut system = oscillator(w * w, x, v * w, with(integrator, dt));
        advance(&mut system, 1);
        [system.mass(1).x.x, system.mass(1).v.x / w]
    })
}

/// `|lambda|` of the larger eigenvalue, and the phase of a step over `z`, where it turns.
fn eigenvalue([[a, c], [b, d]]: [[f64; 2]; 2], z: f64) -> (f64, Option<f64>) {
    let (half, determinant) = (0.5 * (a + d), a * d - b * c);
    let root = half * half - determinant;
    if root < 0.0 {
        return (determinant.sqrt(), Some((-root).sqrt().atan2(half) / z));
    }
    (half.abs() + root.sqrt(), None)
}

fn of(beta: f64) -> Integrator {
    if beta == 0.0 { Integrator::SymplecticEuler } else { Integrator::Beta(beta) }
}

/// For `z = w dt` and beta 0, 1/2 and 1: `|lambda|` and the phase a step over `z`.
#[expect(clippy::approx_constant, reason = "as printed")]
const TABLE: [(f64, [(f64, f64); 3]); 4] = [
    (0.1, [(1.00000000, 1.000417), (0.99750934, 0.998858), (0.99503719, 0.996687)]),
    (0.5, [(1.00000000, 1.010721), (0.94280904, 0.973390), (0.89442719, 0.927295)]),
    (1.0, [(1.0, 1.047198), (0.81649658, 0.911738), (0.70710678, 0.785398)]),
    (1.9, [(1.0, 1.319196), (0.59708143, 0.796078), (0.46574643, 0.571747)]),
];

#[test]
fn amplitudes_and_phases_are_those_of_the_table() {
    for (z, row) in TABLE {
        for (beta, (amplitude, phase)) in [0.0, 0.5, 1.0].into_iter().zip(row) {
            let (measured, turned) = eigenvalue(step_map(z, of(beta)), z);
            assert!((measured - amplitude).abs() < 1e-6, "z {z}, beta {beta}: {measured}, not {amplitude}");
            assert!((turned.unwrap() - phase).abs() < 1e-6, "z {z}, beta {beta}: {turned:?}, not {phase}");
        }
    }
    let (grows, turned) = eigenvalue(step_map(2.1, of(0.0)), 2.1);
    assert!((grows - 1.87732804).abs() < 1e-6 && turned.is_none(), "{grows}");
}

/// The formulas behind the table: `D^(-1/2)` with `D = 1 + beta z^2`, trace `(D + 1 - z^2) / D`.
#[test]
fn maps_are_those_of_the_family() {
    for (z, beta) in [(0.3, 0.5), (1.3, 1.0), (0.7, 0.25), (1.1, 0.0)] {
        let [[a, c], [b, d]] = step_map(z, of(beta));
        let denominator = 1.0 + beta * z * z;
        assert!((a * d - b * c - 1.0 / denominator).abs() < 1e-11, "determinant for {z}, {beta}");
        assert!((a + d - (denominator + 1.0 - z * z) / denominator).abs() < 1e-11, "trace for {z}, {beta}");
    }
}

fn energy_after(steps: usize, dt: f64, integrator: Integrator) -> f64 {
    let mut system = oscillator(1.0, 1.0, 0.0, with(integrator, dt));
    let start = system.kinetic_energy() + system.elastic_energy();
    advance(&mut system, steps);
    (system.kinetic_energy() + system.elastic_energy()) / start
}

#[test]
fn energies_after_a_thousand_steps_are_those_of_the_table() {
    for (integrator, expected) in [
        (Integrator::SymplecticEuler, 0.9954498469),
        (Integrator::Beta(0.5), 0.9490632933),
        (Integrator::Beta(1.0), 0.9048419419),
        (Integrator::ForwardEuler, 1.1051653926),
        (Integrator::ImplicitMidpoint, 1.0),
    ] {
        let energy = energy_after(1000, 0.01, integrator);
        assert!((energy - expected).abs() < 1e-9, "{integrator:?}: {energy}, not {expected}");
    }
    assert!((energy_after(1000, 0.01, Integrator::ForwardEuler) / 1.0001f64.powi(1000) - 1.0).abs() < 1e-10);
}

#[test]
fn symplectic_energy_stays_in_its_range() {
    let mut system = oscillator(1.0, 1.0, 0.0, with(Integrator::SymplecticEuler, 0.01));
    let (mut least, mut most) = (f64::INFINITY, 0.0f64);
    for _ in 0..10_000 {
        advance(&mut system, 1);
        let energy = 2.0 * (system.kinetic_energy() + system.elastic_energy());
        (least, most) = (least.min(energy), most.max(energy));
    }
    assert!((least - 0.995025).abs() < 1e-6 && (most - 1.005025).abs() < 1e-6, "{least} to {most}");
}

#[test]
fn the_midpoint_is_of_second_order_and_the_others_of_first() {
    let error = |steps: usize, integrator| {
        let mut system = oscillator(1.0, 1.0, 0.0, with(integrator, 1.0 / steps as f64));
        advance(&mut system, steps);
        (system.mass(1).x.x - 1f64.cos()).hypot(system.mass(1).v.x + 1f64.sin())
    };
    for (integrator, order) in [
        (Integrator::ImplicitMidpoint, 2.0),
        (Integrator::Beta(0.5), 1.0),
        (Integrator::Beta(1.0), 1.0),
        (Integrator::SymplecticEuler, 1.0),
        (Integrator::ForwardEuler, 1.0),
    ] {
        let measured = (error(100, integrator) / error(200, integrator)).log2();
        assert!((measured - order).abs() < 0.03, "{integrator:?}: order {measured}");
    }
}

/// The notes' Young's modulus is a force: with `k = Y / l` it is the same spring.
#[test]
fn stiffness_is_a_force_a_length() {
    let bond = Bond { stiffness: 1000.0 / 0.1, rest: 0.1, dashpot: 0.0 };
    let force = bond.force(dvec3(0.0, 0.12, 0.0), DVec3::ZERO);
    assert!((force - dvec3(0.0, -1000.0 * (0.12 / 0.1 - 1.0), 0.0)).length() < 1e-9, "{force}");
    assert_eq!(bond.force(DVec3::ZERO, DVec3::X), DVec3::ZERO);
}
